#include <quell/io/exr.hpp>

/// Something of OpenEXR's own, so that its library has to be linked.
bool reads_exr(char const* file) { return quell::io::read_exr(file).size.width > 0; }

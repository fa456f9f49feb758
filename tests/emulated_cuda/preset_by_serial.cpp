#include "rendered.hpp"

// One of the presets that take long to compile: PRESET is its number.
template <> std::vector<emulated_cuda::Result> emulated_cuda::by_serial_of<PRESET>() { return results_by_serial<PRESET>(); }
template <> emulated_cuda::Pictures emulated_cuda::rendered_by_serial_of<PRESET>() { return pictures_by_serial<PRESET>(); }

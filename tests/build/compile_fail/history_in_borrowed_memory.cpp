// error: History<P, Storage>: what quell remembers needs memory of its own
#include <quell/quell.hpp>

constexpr auto denoise = quell::presets::surface(quell::radiance);
#ifdef CORRECT
quell::History history{quell::Extent{8, 8}, denoise, quell::Planar<quell::Float16>{}};
#else
quell::History history{quell::Extent{8, 8}, denoise, quell::Borrowed<>{}};
#endif

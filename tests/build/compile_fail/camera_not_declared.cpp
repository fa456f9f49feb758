// error: a policy uses the camera without saying so: add `static constexpr bool needs_camera = true` to it
#include <quell/quell.hpp>

struct FartherIsDarker {
#ifdef CORRECT
    static constexpr bool needs_camera = true;
#endif
    QUELL_KERNEL auto filter(auto px) const { return quell::scale(px.signal(), typename decltype(px)::Real(px.rays().pixel_size)); }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{FartherIsDarker{}}};

// error: a pass of a fraction of the frame's size looks at the past, the camera or parts of the signal
#include <quell/quell.hpp>

struct HalfLight : quell::InternalChannel<1> {
    static constexpr auto name = "half_light";
    static constexpr int fraction = 2;
};
struct Halve {
    static constexpr int fraction = 2;
    using emits = quell::Channels<HalfLight>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
#ifdef CORRECT
        return quell::emitted<Real>(HalfLight{}, quell::luminance(px.finer_signal(0, 0)));
#else
        return quell::emitted<Real>(HalfLight{}, px.template signal_component<0>());
#endif
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{Halve{}}};

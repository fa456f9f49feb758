// error: a policy looks at a channel of another size than the pass: read a finer one by px.finer(channel, i, j), a coarser one by
// px.coarser(channel)
#include <quell/quell.hpp>

struct DepthUnderIt {
    static constexpr int fraction = 2;
    using reads = quell::Channels<quell::Depth>;
    struct Half : quell::InternalChannel<1> {
        static constexpr auto name = "half";
        static constexpr int fraction = 2;
    };
    using emits = quell::Channels<Half>;
    QUELL_KERNEL auto emit_channels(auto px) const {
#ifdef CORRECT
        return quell::emitted<typename decltype(px)::Real>(Half{}, px.finer(quell::depth, 0, 0));
#else
        return quell::emitted<typename decltype(px)::Real>(Half{}, px[quell::depth]);
#endif
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{DepthUnderIt{}}};

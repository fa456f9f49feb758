// error: a pass makes a channel of another size than its own: give the pass and what it `emits` the same `fraction`
#include <quell/quell.hpp>

struct HalfDepth : quell::InternalChannel<1> {
    static constexpr auto name = "half_depth";
    static constexpr int fraction = 2;
};
struct Halve {
    static constexpr bool leaves_signal = true;
    using reads = quell::Channels<quell::Depth>;
    using emits = quell::Channels<HalfDepth>;
#ifdef CORRECT
    static constexpr int fraction = 2;
#endif
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        if constexpr (decltype(px)::Scope::fraction == 2)
            return quell::emitted<Real>(HalfDepth{}, px.finer(quell::depth, 0, 0));
        else
            return quell::emitted<Real>(HalfDepth{}, px[quell::depth]);
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{Halve{}}};

void denoise_one(quell::Extent size) {
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    quell::run(denoise, frame, history, quell::Serial{});
}

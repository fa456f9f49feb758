// error: a policy returns a channel that it does not list: add the channel to its `emits` or `keeps`
#include <quell/quell.hpp>

struct HalfDepth : quell::InternalChannel<1> {
    static constexpr auto name = "half_depth";
};
struct Halve {
    static constexpr bool leaves_signal = true;
    using reads = quell::Channels<quell::Depth>;
#ifdef CORRECT
    using emits = quell::Channels<HalfDepth>;
#endif
    QUELL_KERNEL auto emit_channels(auto px) const {
        return quell::emitted<typename decltype(px)::Real>(HalfDepth{}, px[quell::depth] * 0.5f);
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{Halve{}}};

void denoise_one(quell::Extent size) {
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    quell::run(denoise, frame, history, quell::Serial{});
}

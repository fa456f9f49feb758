// error: a filter looks at the signal of the last frame without saying so: add `static constexpr bool reads_past_signal = true` to it
#include <quell/quell.hpp>

using namespace quell;

struct Unmoved : InternalChannel<1> {
    static constexpr auto name = "unmoved";
};
struct Difference {
    using emits = Channels<Unmoved>;
#ifdef CORRECT
    static constexpr bool reads_past_signal = true;
#endif
    QUELL_KERNEL auto emit_channels(auto px) const {
        auto const here = nearest_place(px, px.position());
        return emitted<typename decltype(px)::Real>(Unmoved{}, luminance(px.signal()) - luminance(px.past(here).signal()));
    }
};
constexpr Pipeline denoise{radiance, Spatial{Difference{}}, Temporal{StillMotion{}, RunningMean{}}};

void run_it(Frame<Channels<Radiance>>& frame, History<std::remove_const_t<decltype(denoise)>>& history) { run(denoise, frame, history); }

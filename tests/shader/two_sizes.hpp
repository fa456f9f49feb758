#pragma once

#include <quell/quell.hpp>

// Policies whose recording is looked at.
namespace quell::tests {

struct Smaller : Channel<1> {
    static constexpr auto name = "smaller";
    static constexpr int fraction = 2;
};
struct MakeSmaller {
    using emits = Channels<Smaller>;
    static constexpr int fraction = 2, farthest_tap = 2;
    QUELL_KERNEL auto emit_channels(auto px) const {
        auto sum = luminance(px.finer_signal(0, 0)) + luminance(px.finer_signal(1, 1));
        return emitted<typename decltype(px)::Real>(Smaller{}, sum * 0.5f);
    }
};
struct UseSmaller {
    using reads = Channels<Smaller>;
    static constexpr int farthest_tap = 4;
    QUELL_KERNEL auto filter(auto px) const { return px.signal() * px.coarser_interpolated(Smaller{}); }
};

struct Early : Channel<1> {
    static constexpr auto name = "early";
};
struct MakeEarly {
    using emits = Channels<Early>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(Early{}, luminance(px.signal())); }
};
/// Looks at Early in a frame without a past alone.
struct UseEarlyAtFirst {
    using reads = Channels<Early>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const { return px.has_past() ? px.signal() : px.signal() * px[Early{}]; }
};

inline constexpr Temporal accumulate{SurfaceMotion{}, RunningMean{.cap = 16}};
inline constexpr Pipeline two_sizes{radiance, accumulate, Spatial{MakeSmaller{}}, Spatial{UseSmaller{}}};
inline constexpr Pipeline early_at_first{
    radiance, Spatial{MakeEarly{}}, accumulate, Spatial{MakeSmaller{}}, Spatial{UseSmaller{}}, Spatial{UseEarlyAtFirst{}}};

} // namespace quell::tests

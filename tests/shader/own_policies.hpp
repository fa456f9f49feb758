#pragma once

#include <quell/quell.hpp>

// Policies as docs/write_your_own.md prints and tells them, of a file that knows of no recording.
namespace quell::tests {

struct RoughnessEdge {
    using reads = Channels<Roughness>;
    static constexpr int farthest_tap = 0; // it reads its own pixel and that of the tap
    float sigma = 0.1f;

    template <class Real> struct Around {
        Real here, inverse;
        QUELL_KERNEL Real distance(auto near, Real sum) const { return quell::fma(quell::abs(near[roughness] - here), inverse, sum); }
    };
    QUELL_KERNEL auto around(auto px) const {
        using Real = typename decltype(px)::Real;
        return Around<Real>{px[roughness], Real(1.f / sigma)};
    }
};

/// All functions that the page names, with quell:: before them.
struct EveryFunction {
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = luminance(px.signal());
        auto const root = quell::clamp(quell::sqrt(quell::max(light, Real(0.f))), Real(.25f), Real(4.f));
        auto const steps = quell::floor(quell::min(light * 8.f, Real(3.f)));
        auto const more = quell::masked(steps > Real(1.f), quell::fma(root, steps, light));
        return scale(px.signal(), quell::select(quell::is_finite(root), quell::exp(-quell::abs(root)), more));
    }
};

inline constexpr Pipeline own_policies{radiance, Spatial{Atrous{Product{DepthEdge{}, NormalEdge{}, RoughnessEdge{}}, 2}},
                                       Spatial{EveryFunction{}}};

/// Keeps each frame's light, and adds to it that of the last frame, of the one before and of the fourth before, by powers of ten.
struct SeenLight : ExactChannel<3> {
    static constexpr auto name = "seen_light";
};
struct KeepLight {
    using keeps = Channels<SeenLight>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(SeenLight{}, px.signal()); }
};
struct AddLightBefore {
    using reads_kept = Channels<SeenLight, Earlier<SeenLight, 1>, Earlier<SeenLight, 3>>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = px.signal();
        if (!px.has_past()) return sum;
        PixelCoordinates<Real> const here(px.columns(), px.row_of_lanes());
        auto const then = px.past(here);
        sum = add_scaled(sum, then[SeenLight{}], Real(10.f));
        sum = add_scaled(sum, then[Earlier<SeenLight, 1>{}], Real(100.f));
        return add_scaled(sum, then[Earlier<SeenLight, 3>{}], Real(1000.f));
    }
};
inline constexpr Pipeline look_back{radiance, Spatial{KeepLight{}}, Spatial{AddLightBefore{}}};

} // namespace quell::tests

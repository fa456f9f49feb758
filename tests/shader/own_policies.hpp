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

} // namespace quell::tests

#pragma once

#include <quell/presets/named_stages.hpp>

/// A host's own policy: half of what comes out is as the frame's samples.
struct HalfOfSamples {
    static constexpr auto name = "half of samples";
    using reads = quell::Channels<quell::Radiance>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const samples = px[quell::radiance], picture = px.signal();
        auto const half = [&](Real sample, Real made) {
            return quell::select(quell::is_finite(sample), Real(Real(.5f) * (sample + made)), made);
        };
        return quell::vec3<Real>(half(samples.x, picture.x), half(samples.y, picture.y), half(samples.z, picture.z));
    }
};

/// Its line in the list of stages.
inline constexpr std::tuple own_stages{
    quell::NamedStage{"half",
                      [](quell::StandsBehind) {
                          return quell::Pipeline{quell::denoised, quell::Spatial{HalfOfSamples{}}};
                      }},
};

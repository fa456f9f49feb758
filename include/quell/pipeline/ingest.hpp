#pragma once

#include <quell/core/light.hpp>
#include <quell/frame/cursor/taps.hpp>
#include <quell/frame/modulation.hpp>
#include <quell/frame/repair.hpp>
#include <quell/pipeline/firefly.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Luminance that the ingest took away from a sample. Only counted, never stored.
struct Suppressed : Channel<1> {
    static constexpr auto name = "suppressed";
};

/// The first pass. Reads the host's samples, marks unusable ones as missing, applies the modulation, and suppresses fireflies. A missing
/// sample holds the mean of its usable neighbours (MissingMark). It also looks for impossible guides.
/// @tparam Guides those of the pipeline that can be impossible
template <ChannelTag Input, Modulation Form, class Suppression, class Guides> struct Ingest {
    static constexpr auto name = "ingest";
    using parts = Parts<Form>;
    using reads = decltype(Channels<Input>{} | Guides{});
    static constexpr int farthest_tap = farthest_tap_of_part<Form>() == 0 ? 1 : anywhere; // it modulates neighbours too
    Form modulation;
    Suppression suppression;

    template <class Px> struct Sample {
        typename Px::Signal value;
        decltype(std::declval<typename Px::Real>() < std::declval<typename Px::Real>()) usable;
        typename Px::Real brightness; ///< luminance as the host gave it
    };

    QUELL_KERNEL auto operator()(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        using Mark = typename Px::Scope::mark;
        auto const here = sample(px);
        auto value = here.value;
        auto const missing = invert(here.usable);
        if (any(missing)) value = select(missing, around(px), value);
        auto const impossible = impossible_guides<Guides>(px);
        if constexpr (std::is_same_v<Suppression, NoSuppression>)
            return Result{Mark::marked(value, missing)}.with(ImpossibleGuides{}, impossible);
        else {
            auto const factor =
                suppression.factor(px, measured(here), [&](auto neighbour) QUELL_INLINED { return measured(sample(neighbour)); });
            value = select(missing, value, sample(px, factor).value);
            auto const taken = here.brightness * (Real(1.f) - factor);
            return Result{Mark::marked(value, missing)}.with(ImpossibleGuides{}, impossible).with(Suppressed{}, taken);
        }
    }

private:
    /// Luminance for telling fireflies: after the modulation where that is still a colour, else as the host gave it.
    template <class Px> QUELL_KERNEL static auto measured(Sample<Px> const& s) {
        if constexpr (components_of<typename Px::Signal> == Input::components)
            return luminance(s.value);
        else
            return s.brightness;
    }
    /// A sample times `factor`, after the modulation; 0 where it is not usable.
    template <class Px> QUELL_KERNEL Sample<Px> sample(Px const& px, typename Px::Real factor = typename Px::Real(1.f)) const {
        auto const of_host = px[Input{}];
        auto const usable = is_light(of_host);
        auto const given = select(usable, scale(of_host, factor), zero<decltype(of_host + of_host)>());
        auto const value = modulation.inward(px, given);
        return {select(usable, value, zero<typename Px::Signal>()), usable, luminance(given)};
    }
    /// Mean of the usable samples of the 3x3 around; a hole where there is none. Not inlined: few samples are missing.
    template <class Px> QUELL_OUTLINED constexpr typename Px::Signal around(Px const& px) const {
        using Real = typename Px::Real;
        auto sum = zero<typename Px::Signal>();
        Real weights(0.f);
        for_each_neighbour<1>(px, [&](auto neighbour, auto inside, int, int) QUELL_INLINED {
            auto const s = sample(neighbour);
            auto const w = masked(s.usable, inside);
            sum = add_scaled(sum, s.value, w);
            weights = weights + w;
        });
        using Mark = typename Px::Scope::mark;
        return select(weights > Real(0.f), scale(sum, 1.f / max(weights, Real(1.f))), Mark::template no_value<typename Px::Signal>());
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

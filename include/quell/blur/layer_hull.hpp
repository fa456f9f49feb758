#pragma once

#include <quell/blur/layers.hpp>
#include <quell/frame/hull.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The Hull of layers whose signal is multiplied by their coverage. It limits the coverage, and the signal to what the same coverage of the
/// taps' colours would be.
/// @tparam L the signal times the coverage, then the coverage
template <class L> struct LayerHull {
    using Real = real_of<L>;
    using V = decltype(signal_of(std::declval<L const&>()));
    Hull<V> colour;
    Hull<Real> coverage;

    QUELL_KERNEL explicit LayerHull(L const& first) : colour(colour_of(first)), coverage(weight_of(first)) {}
    QUELL_KERNEL void add(L const& layer, auto counts) {
        coverage.add(weight_of(layer), counts);
        colour.add(colour_of(layer), both(counts, weight_of(layer) > Real(0.f)));
    }
    [[nodiscard]] QUELL_KERNEL L limited(L const& layer) const {
        auto const covers = coverage.limited(weight_of(layer));
        return layer_of(Hull<V>(scale(colour.low, covers), scale(colour.high, covers)).limited(signal_of(layer)), covers);
    }

private:
    QUELL_KERNEL static V colour_of(L const& layer) { return scale(signal_of(layer), 1.f / max(weight_of(layer), Real(1e-30f))); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

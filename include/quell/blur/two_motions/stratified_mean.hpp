#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Stratified mean over the open shutter: samples are averaged within equal time strata, then the strata are averaged. An empty stratum
/// takes the nearest one's mean. Random times cluster, so this has much less noise than the mean of all samples. Samples are kept until the
/// weights of all strata are known.
/// @tparam V the values, times their weights
/// @tparam most samples kept per pixel: no more may be added
template <class V, int max_samples> struct StratifiedMean {
    using Real = real_of<V>;
    static constexpr int max_parts = 8; ///< each is at least as long as it takes to cross `pixels_a_part`
    static constexpr float pixels_a_part = 0.5f;
    static constexpr int components = components_of<V>;
    Real count;                                                       ///< number of strata, from 1
    Real weight[max_parts];                                           ///< sum of weights per stratum
    Real held[std::size_t{max_samples}][std::size_t{components + 1}]; ///< weighted values, then the index of the stratum
    int size = 0, next = 0;

    QUELL_KERNEL explicit StratifiedMean(Real pixels)
        : count(floor(clamp(pixels * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(max_parts))))) {
        for (auto& w : weight) w = Real(0.f);
    }
    /// Starts over for other pixels of the pack, which reuse the slots.
    QUELL_KERNEL void restart() { next = 0; }
    /// @param weighted the value times its weight
    /// @param w the weight
    /// @param when fraction of the open shutter; clamped to [0, 1]
    QUELL_KERNEL void add(V const& weighted, Real w, Real when) {
        auto const counts = w > Real(0.f);
        if (!any(counts)) return;
        auto const part = clamp(floor(when * count), Real(0.f), count - 1.f);
        for_each<max_parts>([&](auto i) QUELL_INLINED { weight[i] = weight[i] + masked(part == Real(static_cast<float>(i)), w); });
        auto& place = held[next];
        if (next++ == size) {
            ++size;
            for_each<components>([&](auto c) QUELL_INLINED { place[c] = component<c>(weighted); });
            place[components] = part;
        } else {
            for_each<components>([&](auto c) QUELL_INLINED { place[c] = select(counts, component<c>(weighted), place[c]); });
            place[components] = select(counts, part, place[components]);
        }
    }
    QUELL_KERNEL V mean() const {
        Real share[max_parts];
        find_shares(share);
        auto sum = zero<V>();
        for (int k = 0; k < size; ++k) {
            auto const& one = held[k];
            auto const value = make_value<components, Real>([&](auto c) QUELL_INLINED { return one[c]; });
            sum = add_scaled(sum, value, looked_up<0, max_parts>(share, one[components]));
        }
        return scale(sum, 1.f / count);
    }

private:
    /// Number of strata that each stratum stands for, per weight: halfway to its filled neighbours.
    QUELL_KERNEL void find_shares(Real (&share)[max_parts]) const {
        Real begin[max_parts], before(-1.f), after = count;
        for (int i = 0; i < max_parts; ++i) {
            Real const here(static_cast<float>(i));
            auto const some = weight[i] > Real(0.f);
            begin[i] = masked(before >= Real(0.f), (before + here + 1.f) * 0.5f);
            before = select(some, here, before);
        }
        for (int i = max_parts - 1; i >= 0; --i) {
            Real const here(static_cast<float>(i));
            auto const some = weight[i] > Real(0.f);
            auto const end = select(after < count, (after + here + 1.f) * 0.5f, count);
            share[i] = masked(some, (end - begin[i]) / max(weight[i], Real(1e-12f)));
            after = select(some, here, after);
        }
    }
    /// Unrolled under any flags: a loop would make its constants anew each time.
    template <int n, class Visit> QUELL_KERNEL static void for_each(Visit&& visit) {
        [&]<int... i>(std::integer_sequence<int, i...>) QUELL_INLINED { (visit(std::integral_constant<int, i>{}), ...); }
        (std::make_integer_sequence<int, n>{});
    }
    /// Binary search for a stratum's entry.
    template <int first, int size> QUELL_KERNEL static Real looked_up(Real const (&entries)[max_parts], Real part) {
        if constexpr (size == 1)
            return entries[first];
        else
            return select(part < Real(static_cast<float>(first + size / 2)), looked_up<first, size / 2>(entries, part),
                          looked_up<first + size / 2, size / 2>(entries, part));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

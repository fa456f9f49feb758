#pragma once

#include <quell/core/value.hpp>

namespace quell::detail {

/// The mean of the means of equal parts of the open shutter, of samples that pass at their times: it has much less noise than the mean of
/// all, since times are random and crowd. Samples are held back until it is known how much each part has.
/// @tparam V what is averaged, times a weight; @tparam most samples that it holds of each pixel: no more may be added
template <class V, int most> struct PartMeans {
    using Real = real_of<V>;
    static constexpr int most_parts = 8; ///< they are as long as it takes to pass `pixels_a_part`, at least
    static constexpr float pixels_a_part = 2.f;
    struct Held {
        V value;
        Real part;
    };
    Real count;              ///< of parts, from 1
    Real weight[most_parts]; ///< of all samples in each
    Held held[most];
    int size = 0, next = 0;

    QUELL_KERNEL explicit PartMeans(Real pixels)
        : count(floor(clamp(pixels * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(most_parts))))) {
        for (auto& w : weight) w = Real(0.f);
    }
    /// Samples that are added from here on are for other pixels of the pack than those before: they share the room.
    QUELL_KERNEL void restart() { next = 0; }
    /// @param weighted the value times its weight, @param w the weight that counts in the mean, @param when in [0, 1]
    QUELL_KERNEL void add(V const& weighted, Real w, Real when) {
        auto const counts = w > Real(0.f);
        if (!any(counts)) return;
        // The end of the last part belongs to it.
        auto const part = min(floor(when * count), count - 1.f);
        for_each_part([&](auto i) __attribute__((always_inline)) {
            weight[i] = weight[i] + select(part == Real(static_cast<float>(i)), w, Real(0.f));
        });
        if (next == size)
            held[size++] = Held{weighted, part};
        else
            held[next] = Held{select(counts, weighted, held[next].value), select(counts, part, held[next].part)};
        ++next;
    }
    QUELL_KERNEL V mean() const {
        Real share[most_parts], known(0.f);
        for (int i = 0; i < most_parts; ++i) {
            auto const some = weight[i] > Real(0.f);
            share[i] = select(some, 1.f / max(weight[i], Real(1e-12f)), Real(0.f));
            known = known + select(some, Real(1.f), Real(0.f));
        }
        auto sum = zero<V>();
        for (int k = 0; k < size; ++k) sum = add_scaled(sum, held[k].value, looked_up<0, most_parts>(share, held[k].part));
        return scale(sum, 1.f / max(known, Real(1.f)));
    }

private:
    /// Unrolled, whatever the host's flags: a loop would make its constants anew each time.
    template <class Visit> QUELL_KERNEL static void for_each_part(Visit&& visit) {
        [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) { (visit(std::integral_constant<int, i>{}), ...); }
        (std::make_integer_sequence<int, most_parts>{});
    }
    /// The entry of a part, by halving.
    template <int first, int size> QUELL_KERNEL static Real looked_up(Real const (&entries)[most_parts], Real part) {
        if constexpr (size == 1)
            return entries[first];
        else
            return select(part < Real(static_cast<float>(first + size / 2)), looked_up<first, size / 2>(entries, part),
                          looked_up<first + size / 2, size / 2>(entries, part));
    }
};

} // namespace quell::detail

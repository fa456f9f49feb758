#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Whether an image of floats keeps all their bits.
template <class View> inline constexpr bool keeps_all_bits = requires { requires std::same_as<typename View::Element, float>; };

/// How the signal's image marks missing samples, until Temporal: by the sign bits of all its components (of the first four). Light has no
/// such pixels, as its luminance is not negative. The value that stands in for the sample has the signs of its components in the last bit
/// that memory keeps of each; of one component it has none. Where not even that value is known, the mark has the largest number in place of
/// it: a hole.
/// @tparam exact whether memory keeps floats as they are; else it must keep as much as half does
template <bool exact> struct MissingMark {
    /// Whether the sample is missing.
    /// @tparam marks whether there are marks; without them, no sample is
    template <bool marks = true, class V> QUELL_KERNEL static auto of(V const& stored) {
        if constexpr (!marks) return real_of<V>(0.f) != real_of<V>(0.f);
        auto all = bits(component<0>(stored));
        for_each_telling<V>([&](auto c) QUELL_INLINED { all = all & bits(component<c>(stored)); });
        return less_index(all, decltype(all)(0));
    }
    /// Whether nothing stands in for the sample.
    template <class V> QUELL_KERNEL static auto hole(V const& stored) {
        return both(of(stored), abs(component<0>(stored)) > real_of<V>(hole_from));
    }
    /// The value without the mark; 0 for a hole.
    template <bool marks = true, class V> QUELL_KERNEL static V value(V const& stored) {
        if constexpr (!marks) return stored;
        auto const missing = of(stored);
        return any(missing) ? select(missing, masked_out(hole(stored), decoded(stored)), stored) : stored;
    }
    /// A value as memory holds it.
    template <class V> QUELL_KERNEL static V marked(V const& value, auto missing) {
        // Rounding may have taken a little too much from all components of a sample.
        auto const light = make_value<components_of<V>, real_of<V>>([&](auto c) QUELL_INLINED {
            if constexpr (c == 0)
                return select(of(value), real_of<V>(0.f), component<0>(value));
            else
                return component<c>(value);
        });
        return any(missing) ? select(missing, encoded(value), light) : light;
    }
    /// What to mark where there is no value. Marked, it is a hole.
    template <class V> QUELL_KERNEL static V no_value() { return splat<V>(real_of<V>(-nothing)); }

private:
    static constexpr int bit = exact ? 0 : 13; ///< where the sign is
    static constexpr float nothing = std::numeric_limits<float>::max(), largest = exact ? 1e38f : 65408.f,
                           hole_from = exact ? 2e38f : 65450.f;
    static constexpr float subnormal = 0x1p-14f, smallest_step = 0x1p-24f; ///< of halves: below this the last bit is always the same step
    static constexpr std::int32_t sign_here = 1 << bit, magnitude = std::numeric_limits<std::int32_t>::max();
    template <class V> static constexpr int telling = components_of<V> < 4 ? components_of<V> : 4;

    template <class V> QUELL_KERNEL static void for_each_telling(auto&& visit) {
        [&]<int... c>(std::integer_sequence<int, c...>) QUELL_INLINED { (visit(std::integral_constant<int, c>{}), ...); }
        (std::make_integer_sequence<int, telling<V>>{});
    }
    template <class V> QUELL_KERNEL static V masked_out(auto mask, V const& v) { return select(mask, zero<V>(), v); }
    template <class V> QUELL_KERNEL static V each_telling(V const& v, auto&& change) {
        return make_value<components_of<V>, real_of<V>>([&](auto c) QUELL_INLINED {
            if constexpr (c < telling<V>)
                return change(component<c>(v));
            else
                return component<c>(v);
        });
    }
    template <class V> QUELL_KERNEL static V encoded(V const& v) {
        using Bits = Index<real_of<V>>;
        return each_telling(v, [](auto a) QUELL_INLINED {
            using Real = decltype(a);
            auto const given = without_sign_bit(a), size = min(given, Real(largest));
            auto const none = given >= Real(nothing);
            if constexpr (components_of<V> == 1) return with_sign_bit(select(none, given, size));
            // Rounds to where the last bit is free.
            auto const rounded = (bits(size) + Bits(sign_here)) & Bits(-2 * sign_here);
            auto signed_size = from_bits(select_index(sign_bit(a), rounded | Bits(sign_here), rounded));
            if constexpr (!exact) {
                auto const steps = floor(size * (0.5f / smallest_step) + 0.5f) * 2.f;
                signed_size = select(size < Real(subnormal), (steps + masked(sign_bit(a), Real(1.f))) * smallest_step, signed_size);
            }
            return with_sign_bit(select(none, given, signed_size));
        });
    }
    template <class V> QUELL_KERNEL static V decoded(V const& v) {
        using Bits = Index<real_of<V>>;
        return each_telling(v, [](auto a) QUELL_INLINED {
            if constexpr (components_of<V> == 1) return without_sign_bit(a);
            auto const size = bits(a) & Bits(magnitude - sign_here), sign = (bits(a) & Bits(sign_here)) << (31 - bit);
            if constexpr (exact)
                return from_bits(size | sign);
            else {
                auto const pairs = without_sign_bit(a) * (0.5f / smallest_step), whole = floor(pairs), even = whole * (2.f * smallest_step);
                auto const below_normal = select(pairs - whole > decltype(a)(0.25f), -even, even);
                return select(without_sign_bit(a) < decltype(a)(subnormal), below_normal, from_bits(size | sign));
            }
        });
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

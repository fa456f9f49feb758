#pragma once

#include <quell/core/recording.hpp>
#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline constexpr int max_strata = 8;
/// A number for each stratum.
template <class Real> struct Strata { Real at[max_strata]; };
/// Unrolled under any flags: a loop would make its constants anew each time.
template <int n, class Visit> QUELL_KERNEL void for_each_stratum(Visit&& visit) {
    [&]<int... i>(std::integer_sequence<int, i...>) QUELL_INLINED { (visit(std::integral_constant<int, i>{}), ...); }
    (std::make_integer_sequence<int, n>{});
}

/// Samples of strata, kept until the weights of all strata are known.
/// @tparam V the values, times their weights
/// @tparam max_samples kept per pixel: no more may be added
template <class V, int max_samples> struct StrataSamples {
    using Real = real_of<V>;
    static constexpr int components = components_of<V>;

    /// Starts over for other pixels of the pack, which reuse the slots.
    QUELL_KERNEL void restart() { next = 0; }
    /// Adds a sample where `counts`.
    QUELL_KERNEL void add(V const& weighted, Real w, Real part, auto counts) {
        auto& place = held[next];
        if (next++ == size) {
            ++size;
            for_each_stratum<components>([&](auto c) QUELL_INLINED { place.value[c] = component<c>(weighted); });
            place.weight = w, place.part = part;
        } else {
            for_each_stratum<components>([&](auto c)
                                             QUELL_INLINED { place.value[c] = select(counts, component<c>(weighted), place.value[c]); });
            place.weight = select(counts, w, place.weight), place.part = select(counts, part, place.part);
        }
    }
    QUELL_KERNEL Strata<Real> weights() const {
        return sums([](auto const& sample) QUELL_INLINED { return sample.weight; });
    }
    /// Sums of the last component.
    QUELL_KERNEL Strata<Real> last_sums() const {
        return sums([](auto const& sample) QUELL_INLINED { return sample.value[components - 1]; });
    }
    /// The sum of all samples, each times its stratum's share.
    QUELL_KERNEL V sum_with(Strata<Real> const& share) const {
        auto sum = zero<V>();
        for (int k = 0; k < size; ++k) {
            auto const& one = held[k];
            auto const value = make_value<components, Real>([&](auto c) QUELL_INLINED { return one.value[c]; });
            sum = add_scaled(sum, value, looked_up<0, max_strata>(share.at, one.part));
        }
        return sum;
    }

private:
    struct Held {
        Real value[std::size_t{components}], weight, part; ///< value times weight; index of the stratum
    };
    Held held[std::size_t{max_samples}];
    int size = 0, next = 0;

    /// Sums over the samples of each stratum. The sums stay in registers, which is why samples keep their weights.
    template <class Of> QUELL_KERNEL Strata<Real> sums(Of&& of) const {
        Strata<Real> sum;
        for_each_stratum<max_strata>([&](auto i) QUELL_INLINED { sum.at[i] = Real(0.f); });
        for (int k = 0; k < size; ++k) {
            auto const part = held[k].part, one = of(held[k]);
            for_each_stratum<max_strata>([&](auto i)
                                             QUELL_INLINED { sum.at[i] = sum.at[i] + masked(part == Real(static_cast<float>(i)), one); });
        }
        return sum;
    }
    /// Binary search for a stratum's entry.
    template <int first, int size> QUELL_KERNEL static Real looked_up(Real const (&entries)[max_strata], Real part) {
        if constexpr (size == 1)
            return entries[first];
        else
            return select(part < Real(static_cast<float>(first + size / 2)), looked_up<first, size / 2>(entries, part),
                          looked_up<first + size / 2, size / 2>(entries, part));
    }
};

/// Whether sums of each stratum are kept in place of samples: on a device, and where a kernel is recorded for one.
template <class Real> inline constexpr bool keeps_sums = on_device || records<Real>;

/// The same on a device: sums of each stratum, in a thread's registers. Of one pixel only.
template <class V> struct StrataSums {
    using Real = real_of<V>;

    QUELL_KERNEL StrataSums() {
        for_each_stratum<max_strata>([&](auto i) QUELL_INLINED { value[i] = zero<V>(), weight.at[i] = Real(0.f); });
    }
    QUELL_KERNEL void restart() {}
    QUELL_KERNEL void add(V const& weighted, Real w, Real part, auto) {
        for_each_stratum<max_strata>([&](auto i) QUELL_INLINED {
            auto const here = part == Real(static_cast<float>(i));
            if constexpr (records<Real>)
                add_to<i>(map([&](auto a) { return masked(here, a); }, weighted), masked(here, w));
            else if (here)
                add_to<i>(weighted, w);
        });
    }
    QUELL_KERNEL Strata<Real> weights() const { return weight; }
    QUELL_KERNEL Strata<Real> last_sums() const {
        Strata<Real> sum;
        for_each_stratum<max_strata>([&](auto i) QUELL_INLINED { sum.at[i] = component<components_of<V> - 1>(value[i]); });
        return sum;
    }
    QUELL_KERNEL V sum_with(Strata<Real> const& share) const {
        auto sum = zero<V>();
        for_each_stratum<max_strata>([&](auto i) QUELL_INLINED { sum = add_scaled(sum, value[i], share.at[i]); });
        return sum;
    }

private:
    V value[max_strata]; ///< sum of values times weights
    Strata<Real> weight;

    template <int i> QUELL_KERNEL void add_to(V const& weighted, Real w) {
        value[i] = map([](auto sum, auto a) QUELL_INLINED { return sum + a; }, value[i], weighted);
        weight.at[i] = weight.at[i] + w;
    }
};

/// Stratified mean over the open shutter: samples are averaged within equal time strata, then the strata are averaged. An empty stratum
/// takes the mean of the next filled ones before and after it. Random times cluster, so this has much less noise than the mean of all
/// samples.
/// @tparam V the values, times their weights
/// @tparam max_samples per pixel: no more may be added
template <class V, int max_samples> struct StratifiedMean {
    using Real = real_of<V>;
    static constexpr int max_parts = max_strata; ///< each is at least as long as it takes to cross `pixels_a_part`
    static constexpr float pixels_a_part = 0.5f;
    static constexpr float pixels_for_all = max_parts * pixels_a_part; ///< length of a sweep from which on there are `max_parts` strata
    using Strata = detail::Strata<Real>;

    QUELL_KERNEL explicit StratifiedMean(Real pixels)
        : count(floor(clamp(pixels * (1.f / pixels_a_part), Real(1.f), Real(static_cast<float>(max_parts))))) {}
    /// Starts over for other pixels of the pack.
    QUELL_KERNEL void restart() { samples.restart(); }
    /// @param weighted the value times its weight
    /// @param w the weight
    /// @param when fraction of the open shutter; clamped to [0, 1]
    QUELL_KERNEL void add(V const& weighted, Real w, Real when) {
        auto const counts = w > Real(0.f);
        if (!any(counts)) return;
        auto const part = clamp(floor(when * count), Real(0.f), count - 1.f);
        samples.add(weighted, w, part, counts);
    }
    /// 0 without samples.
    QUELL_KERNEL V mean() const {
        Strata all;
        for_each_stratum<max_parts>([&](auto i) QUELL_INLINED { all.at[i] = masked(in_use<i>(), Real(1.f)); });
        return mean_with(shares(all), count);
    }
    /// The mean over a part of the time.
    /// @param exposed how much of each stratum counts, in [0, 1]; where it is hardly anything, all strata count the same
    QUELL_KERNEL V mean(Strata exposed) const {
        Real total(0.f);
        for_each_stratum<max_parts>([&](auto i) QUELL_INLINED {
            constexpr float hardly = 1e-3f;
            exposed.at[i] = masked(in_use<i>(), max(exposed.at[i], Real(hardly)));
            total = total + exposed.at[i];
        });
        return mean_with(shares(exposed), total);
    }
    /// Mean of the last component in each stratum.
    QUELL_KERNEL Strata last_component() const {
        auto const weight = samples.weights();
        auto mean = samples.last_sums();
        Filled const filled(weight);
        Real nearest(0.f);
        Strata before;
        QUELL_UNROLL_ON_DEVICE
        for (int i = 0; i < max_parts; ++i) {
            mean.at[i] = mean.at[i] / max(weight.at[i], Real(1e-12f));
            before.at[i] = nearest = select(filled.is[i], mean.at[i], nearest);
        }
        nearest = Real(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int i = max_parts - 1; i >= 0; --i) {
            nearest = select(filled.is[i], mean.at[i], nearest);
            mean.at[i] = select(filled.is[i], mean.at[i], fma(before.at[i], filled.to_previous(i), nearest * filled.to_next(i)));
        }
        return mean;
    }

private:
    Real count; ///< number of strata, from 1
    std::conditional_t<keeps_sums<Real>, StrataSums<V>, StrataSamples<V, max_samples>> samples;

    template <int i> QUELL_KERNEL auto in_use() const { return Real(static_cast<float>(i)) < count; }
    /// Which strata have samples, and to which filled ones an empty one belongs.
    struct Filled {
        decltype(Real(0.f) < Real(0.f)) is[max_parts];
        Real before[max_parts], after[max_parts]; ///< 1 where one of the strata up to here, or from here on, is filled; otherwise 0
        QUELL_KERNEL explicit Filled(Strata const& weight) {
            Real some(0.f);
            QUELL_UNROLL_ON_DEVICE
            for (int i = 0; i < max_parts; ++i) {
                is[i] = weight.at[i] > Real(0.f);
                before[i] = some = select(is[i], Real(1.f), some);
            }
            some = Real(0.f);
            QUELL_UNROLL_ON_DEVICE
            for (int i = max_parts - 1; i >= 0; --i) after[i] = some = select(is[i], Real(1.f), some);
        }
        /// Share of an empty stratum that belongs to the next filled one before it; the rest belongs to the one after it.
        QUELL_KERNEL Real to_previous(int i) const { return fma(after[i], Real(-0.5f), Real(1.f)) * before[i]; }
        QUELL_KERNEL Real to_next(int i) const { return fma(before[i], Real(-0.5f), Real(1.f)) * after[i]; }
    };
    /// What a sample of each stratum counts for, per weight: how much of its own stratum is exposed, and of the empty ones that belong to
    /// it.
    QUELL_KERNEL Strata shares(Strata const& exposed) const {
        auto const weight = samples.weights();
        Filled const filled(weight);
        Strata share;
        Real carried(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int i = 0; i < max_parts; ++i) {
            share.at[i] = exposed.at[i] + carried;
            carried = masked(invert(filled.is[i]), fma(exposed.at[i], filled.to_next(i), carried));
        }
        carried = Real(0.f);
        QUELL_UNROLL_ON_DEVICE
        for (int i = max_parts - 1; i >= 0; --i) {
            share.at[i] = masked(filled.is[i], (share.at[i] + carried) / max(weight.at[i], Real(1e-30f)));
            carried = masked(invert(filled.is[i]), fma(exposed.at[i], filled.to_previous(i), carried));
        }
        return share;
    }
    QUELL_KERNEL V mean_with(Strata const& share, Real total) const { return scale(samples.sum_with(share), 1.f / total); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

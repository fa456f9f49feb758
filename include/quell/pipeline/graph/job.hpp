#pragma once

#include <quell/core/recording.hpp>
#include <quell/execute/executor.hpp>
#include <quell/pipeline/graph/counts.hpp>
#include <quell/pipeline/ingest.hpp>
#include <quell/pipeline/stage.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// End of the last pass: demodulates, stores the output, and copies the guides that the history remembers.
template <class Form, class Scope, class Output, class RememberedViews> struct Finish {
    Form modulation;
    Scope scope; ///< of the channels that the modulation and the history read
    Output output;
    RememberedViews remembered;

    template <class Real, class V> QUELL_KERNEL void store_output(Coordinate<Real> x, Coordinate<Real> y, int count, V const& value) const {
        store_pixels<Real>(output, x, y, modulation.outward(Pixel<Real, Scope>{scope, x, y}, value), count);
    }
    template <class Real, class... Cs>
    QUELL_KERNEL void remember(Coordinate<Real> x, Coordinate<Real> y, [[maybe_unused]] int count, Channels<Cs...>) const {
        [[maybe_unused]] Pixel<Real, Scope> const px{scope, x, y};
        (store_pixels<Real>(remembered.view(typename Remembered<Cs>::Stored{}), x, y, Remembered<Cs>::pack(px[Cs{}]), count), ...);
    }
};

/// Whether a pass makes a new signal: it has no emit_channels(px).
template <class Pass, class Scope> inline constexpr bool makes_signal_of = !requires(Pass const p, Pixel<float, Scope> px) {
    p.emit_channels(px);
};

template <int fraction, class... Cs> constexpr bool all_of_fraction(Channels<Cs...>) { return ((Cs::fraction == fraction) && ...); }

/// One pass over one region: what an executor runs. Trivially copyable, so that it can be copied to a device.
/// @tparam keeps_marks whether the new signal keeps the marks of missing samples
template <class Pass, class Scope, class SignalView, class MadeViews, class FinishWork, class RememberedSet, bool keeps_marks>
struct PassJob {
    static constexpr auto name = pass_name<Pass>;
    static constexpr bool makes_signal = makes_signal_of<Pass, Scope>;
    static constexpr int max_lanes = max_lanes_of<Pass>;
    static constexpr bool two_rows = takes_two_rows<Pass>;
    /// Whether neighbouring pixels look at places in various directions, so that a device should run squares of them.
    static constexpr bool in_squares = two_rows || is_temporal<Pass>;
    static_assert(!two_rows || !makes_signal, "a pass of `two_rows` makes the signal: give it emit_channels(px)");
    static_assert(Scope::fraction == 1 || !makes_signal,
                  "a pass of a fraction of the frame's size makes the signal, which is of the frame's size: give it emit_channels(px)");
    static_assert(all_of_fraction<Scope::fraction>(typename MadeViews::channels{}),
                  "a pass makes a channel of another size than its own: give the pass and what it `emits` the same `fraction`");

    Pass pass;
    Scope scope;
    SignalView signal;
    MadeViews made;
    FinishWork finish;
    bool store_signal, store_output, store_remembered;
    unsigned stored_channels; ///< a bit for each channel of MadeViews: whether anything reads it
    Counts* counts = nullptr; ///< of the ingest; else null

    template <class Real, int rows>
    QUELL_FLATTENED QUELL_KERNEL void operator()(AtOnce<Real, rows>, Coordinate<Real> x, Coordinate<Real> y, int count) const {
        at_pixels<Real, rows>(x, y, count);
    }
    /// The same for who runs it once, and had better not have everything inlined.
    template <class Real, int rows> QUELL_KERNEL void at_pixels(Coordinate<Real> x, Coordinate<Real> y, int count) const {
        auto const result = result_of([&]() QUELL_INLINED { return evaluate(Pixel<Real, Scope, rows>{scope, x, y}); });
        static_assert(contained_in<typename decltype(result.more)::channels,
                                   decltype(typename MadeViews::channels{} | Channels<Suppressed, ImpossibleGuides>{})>,
                      "a policy returns a channel that it does not list: add the channel to its `emits` or `keeps`");
        if constexpr (makes_signal) {
            if (store_signal) store_pixels<Real>(signal, x, y, marked(Pixel<Real, Scope>{scope, x, y}, result.value), count);
            if (store_output) finish.template store_output<Real>(x, y, count, result.value);
            if constexpr (!records<Real>) count_all<Real>(result, count);
        }
        unsigned channel = 1;
        for_each_channel(typename MadeViews::channels{}, [&](auto c) QUELL_INLINED {
            static_assert(decltype(result.more)::channels::template has<decltype(c)>,
                          "a policy does not return a channel that it `keeps` or `emits`: add .with(channel, value) to its result");
            if ((stored_channels & channel) != 0) store_rows<Real, rows>(made.view(c), x, y, in_memory(c, result.more[c]), count);
            channel <<= 1;
        });
        if constexpr (rows == 1) // else it is not the last pass
            if (store_remembered) finish.template remember<Real>(x, y, count, RememberedSet{});
    }

private:
    /// A channel's value, or what it says that memory holds of it.
    QUELL_KERNEL static auto in_memory(auto c, auto const& value) {
        if constexpr (requires { c.in_memory(value); })
            return c.in_memory(value);
        else {
            static_assert(!NamesInMemory<decltype(c)>, "`in_memory` of a channel must be `static auto in_memory(auto const& value)`");
            return value;
        }
    }
    template <class Px, class V> QUELL_KERNEL static V marked(Px const& px, V const& value) {
        if constexpr (!keeps_marks)
            return value;
        else
            return Scope::mark::marked(value, px.missing());
    }
    QUELL_KERNEL auto evaluate(auto px) const {
        if constexpr (requires { pass.filter(px); })
            return pass.filter(px);
        else if constexpr (makes_signal)
            return pass(px);
        else
            return pass.emit_channels(px);
    }
    template <class Real> QUELL_KERNEL void count_all(auto const& result, int count) const {
        using More = typename decltype(result.more)::channels;
        if (counts) count_missing<Real>(result.value, count);
        if constexpr (More::template has<Suppressed>) count_suppressed(result.more[Suppressed{}], count);
        if constexpr (More::template has<ImpossibleGuides>) count_guides(result.more[ImpossibleGuides{}], count);
    }
    template <class Real> QUELL_KERNEL void count_missing(auto const& marked, int count) const {
        auto const missing = Scope::mark::of(marked);
        if (!any(missing)) return;
        add_together(counts->missing, count_of<Real>(missing, count));
        add_together(counts->holes, count_of<Real>(Scope::mark::hole(marked), count));
    }
    /// How many of the first lanes of a mask are true.
    template <class Real> QUELL_KERNEL static long long count_of(auto mask, int count) {
        auto const ones = masked(mask, Real(1.f));
        long long n = 0;
        for (int i = 0; i < count; ++i) n += lane(ones, i) > 0.f;
        return n;
    }
    template <class Real> QUELL_KERNEL void count_guides(Real const& impossible, int count) const {
        if (!any(impossible > Real(0.f))) return;
        for (int i = 0; i < count; ++i) counts->guides.add(lane(impossible, i));
    }
    template <class Real> QUELL_KERNEL void count_suppressed(Real const& taken, int count) const {
        if (!any(taken > Real(0.f))) return;
        for (int i = 0; i < count; ++i)
            if (lane(taken, i) > 0.f) counts->suppressed.add(lane(taken, i));
    }
};

/// Stores the signal as it is. The last pass where no other one makes a signal.
struct PassThrough {
    static constexpr auto name = "pass through";
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const { return px.signal(); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

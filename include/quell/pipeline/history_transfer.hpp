#pragma once

#include <quell/frame/kept_channels.hpp>
#include <quell/pipeline/history.hpp>

#include <algorithm>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {

void for_each_number(ImageView auto const& view, auto&& visit) {
    for (int c = 0; c < std::remove_cvref_t<decltype(view)>::components; ++c)
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x) visit(c, x, y);
}

/// Access to what histories hold.
struct HistoryTransfer {
    template <class H> static bool has_past(H const& history) { return !history.empty && history.then.signal; }
    /// Whether both have a past that ends with the same frame.
    template <class H> static bool end_together(H const& a, H const& b) {
        return has_past(a) && has_past(b) && a.size == b.size && a.then.number == b.then.number;
    }

    template <class P, class Storage> static void copy(History<P, Storage>& to, History<P, Storage> const& from) {
        to.restart(from.size);
        auto const copied = [&]<class Image>(PooledImage<Image> const& image) {
            if (!image) return PooledImage<Image>{};
            auto result = to.pool->template take<Image>();
            auto const view = result.view();
            for_each_number(view, [&, seen = image.view()](int c, int x, int y) { view.set(c, x, y, seen.get(c, x, y)); });
            return result;
        };
        to.then.signal = copied(from.then.signal);
        for_each_channel(typename P::keeps{}, [&](auto c) { to.then.kept[c] = copied(slot<decltype(c)>(from.then.kept)); });
        for_each_channel(typename FrameState<P, Storage>::Guides{},
                         [&](auto c) { to.then.guides[c] = copied(slot<decltype(c)>(from.then.guides)); });
        to.then.camera = from.then.camera, to.then.shutter = from.then.shutter, to.then.number = from.then.number;
        to.empty = false;
    }

    template <class H> static auto signal(H& history) { return history.then.signal.view(); }
};

/// What a kept channel becomes where the signal is multiplied by a number.
template <ChannelTag C> float scaled_kept(float value, float factor) {
    if constexpr (std::is_same_v<C, LuminanceMean>)
        return value * factor;
    else if constexpr (std::is_same_v<C, LuminanceVariance>)
        return value * factor * factor;
    else
        return value;
}
/// What it is for the sum of two signals.
template <ChannelTag C> float added_kept(float a, float b) {
    if constexpr (std::is_same_v<C, LuminanceMean> || std::is_same_v<C, LuminanceVariance>)
        return a + b;
    else if constexpr (std::is_same_v<C, HistoryLength>)
        return std::min(a, b);
    else
        return a;
}

/// Luminance of a factor of P's signal at a pixel, as the mean of its components where it is no colour.
template <class P> float luminance_of(auto const& factor, int x, int y) {
    return luminance(make_value<P::Signal::components, float>([&](auto c) { return factor(int{c}, x, y); }));
}

} // namespace detail

/// Multiplies what a history has accumulated, such as after its signal has changed its unit: by factor(c, x, y) at a pixel and component of
/// the last frame. Does nothing where there is no past.
template <class P, class Storage> void scale_history(History<P, Storage>& history, auto const& factor) {
    if (!detail::HistoryTransfer::has_past(history)) return;
    auto const signal = detail::HistoryTransfer::signal(history);
    detail::for_each_number(signal, [&](int c, int x, int y) { signal.set(c, x, y, signal.get(c, x, y) * factor(c, x, y)); });
    for_each_channel(typename P::keeps{}, [&]<class C>(C channel) {
        auto const kept = history[channel];
        detail::for_each_number(kept, [&](int c, int x, int y) {
            kept.set(c, x, y, detail::scaled_kept<C>(kept.get(c, x, y), detail::luminance_of<P>(factor, x, y)));
        });
    });
}

/// Adds what `from` has accumulated, times factor(c, x, y), to what `to` has accumulated up to the same frame: where two signals are
/// denoised as one from now on, or a part of one by itself. A history without a past of that frame takes over the other's guides and
/// lengths.
template <class P, class Storage> void add_history(History<P, Storage>& to, History<P, Storage> const& from, auto const& factor) {
    using detail::HistoryTransfer;
    if (!HistoryTransfer::has_past(from)) return;
    if (!HistoryTransfer::end_together(to, from)) {
        HistoryTransfer::copy(to, from);
        return scale_history(to, factor);
    }
    auto const sum = HistoryTransfer::signal(to), more = HistoryTransfer::signal(from);
    detail::for_each_number(sum, [&](int c, int x, int y) { sum.set(c, x, y, sum.get(c, x, y) + more.get(c, x, y) * factor(c, x, y)); });
    for_each_channel(typename P::keeps{}, [&]<class C>(C channel) {
        auto const kept = to[channel], other = from[channel];
        detail::for_each_number(kept, [&](int c, int x, int y) {
            auto const scaled = detail::scaled_kept<C>(other.get(c, x, y), detail::luminance_of<P>(factor, x, y));
            kept.set(c, x, y, detail::added_kept<C>(kept.get(c, x, y), scaled));
        });
    });
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/blend/blend_policy.hpp>
#include <quell/filter/filter_kernel.hpp>
#include <quell/motion/history_fetch.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
struct Missing {}; ///< stands for a policy that was forgotten

/// Whether a kept channel is of guides, which a pixel has where its sample is missing.
template <class C> inline constexpr bool is_of_guides = false;
template <class C>
    requires is_constant<decltype(&C::of_guides), bool>
inline constexpr bool is_of_guides<C> = C::of_guides;
} // namespace detail

/// The temporal stage: a motion source finds the history, a fetch interpolates it, a blend policy blends it with the new sample.
///
///     Temporal{SurfaceMotion{}, Clamped{RunningMean{.cap = 16}}}
///
/// @tparam M     a MotionSource; FirstValid combines several
/// @tparam B     a BlendPolicy
/// @tparam Fetch how history is interpolated: Bilinear, CatmullRom, ConeFetch, ...
template <class M, class B, class Fetch = Bilinear> struct Temporal {
    static_assert(std::is_trivially_copyable_v<M> && std::is_trivially_copyable_v<B>,
                  "Temporal{motion, blend}: a policy must be trivially copyable, so that it can be sent to a device: plain numbers only");
    static_assert(detail::check_hooks<M>() && detail::check_hooks<B>() && detail::check_hooks<Fetch>());
    static_assert(MotionSource<M>, "Temporal{motion, blend}: `motion` must have previous(px), see quell/motion/motion_source.hpp");
    static_assert(std::is_class_v<Fetch> && std::is_trivially_copyable_v<Fetch>,
                  "Temporal{motion, blend, fetch}: `fetch` must have fetch(px, found), see quell/motion/history_fetch.hpp");
    static_assert(BlendPolicy<B>, "Temporal{motion, blend}: `blend` must have blend(px, past), see quell/blend/blend_policy.hpp");

    using parts = Parts<M, B, Fetch>;
    static constexpr auto name = "temporal";
    static constexpr int farthest_tap = 0;

    M motion{};    ///< finds the history
    B blending{};  ///< blends it with the new sample
    Fetch fetch{}; ///< interpolates it

    /// The accumulated value of a pixel. Where the sample is missing, the history is kept.
    QUELL_KERNEL auto operator()(auto px) const {
        using Px = decltype(px);
        auto const past = px.has_past() ? find(px, motion) : detail::no_past<Px>();
        auto result = result_of([&]() QUELL_INLINED { return blending.blend(px, past); });
        if (auto const missing = px.missing(); any(missing)) keep_past(missing, px, past, result);
        return result;
    }

private:
    /// With several sources: the first whose history is valid.
    QUELL_KERNEL auto find(auto const& px, auto const& source) const {
        if constexpr (detail::is_chain<decltype(source)>) {
            auto past = find(px, source.first);
            auto const lost = past.validity <= decltype(past.validity)(0.f);
            if (any(lost)) past.replace(lost, find(px, source.rest));
            return past;
        } else {
            auto const found = source.previous(px);
            if constexpr (requires { fetch.fetch(px, found); })
                return fetch.fetch(px, found);
            else {
                static_assert(sizeof(found) == 0,
                              "Temporal{motion, blend, fetch}: `fetch` must have fetch(px, found), see quell/motion/history_fetch.hpp");
                return detail::no_past<std::remove_cvref_t<decltype(px)>>();
            }
        }
    }
    /// Missing samples: the history goes on, as far as it is valid. Without a history the neighbours' mean stands in, and what is kept
    /// becomes 0, so that the next sample counts fully. (Exponential keeps no length: it blends the next sample with alpha as ever.) What
    /// has only the history of pixels around has no length either: then the next frame looks around again, and a pixel that never gets a
    /// sample follows those that do. What is kept of guides is there without a sample.
    template <class R> QUELL_KERNEL static void keep_past(auto missing, auto const& px, auto const& past, R& result) {
        auto const present = past.validity > decltype(past.validity)(0.f);
        result.value = select(missing, select(present, past.signal, px.signal()), result.value);
        for_each_channel(typename decltype(past.kept)::channels{}, [&](auto c) QUELL_INLINED {
            if constexpr (!decltype(result.more)::channels::template has<decltype(c)>)
                return;
            else if constexpr (detail::is_of_guides<decltype(c)>)
                result.more.set(c, select(both(missing, present), past[c], result.more[c]));
            else
                result.more.set(c, select(missing, select(present, gone_on(c, past), zero<decltype(past[c])>()), result.more[c]));
        });
    }
    template <ChannelTag C> QUELL_KERNEL static auto gone_on(C c, auto const& past) {
        if constexpr (std::is_same_v<C, HistoryLength>)
            return past[c] * past.validity * (1.f - past.from_around);
        else
            return past[c];
    }
};
/// @cond
template <class M> Temporal(M) -> Temporal<M, detail::Missing>; // which says what is missing
/// @endcond
template <class M, class B> Temporal(M, B) -> Temporal<M, B>;
template <class M, class B, class F> Temporal(M, B, F) -> Temporal<M, B, F>;

/// A spatial stage: `Spatial{Atrous{}}`.
/// @tparam F a FilterKernel
template <class F> struct Spatial {
    static_assert(std::is_trivially_copyable_v<F>,
                  "Spatial{kernel}: a policy must be trivially copyable, so that it can be sent to a device: plain numbers only");
    static_assert(detail::check_hooks<F>());
    static_assert(FilterKernel<F>,
                  "Spatial{kernel}: `kernel` must have filter(px) or for_each_pass(pass), see quell/filter/filter_kernel.hpp");
    static_assert(OnePassFilter<F> + EmittingKernel<F> + detail::HasPasses<F> <= 1,
                  "Spatial{kernel}: `kernel` must have one of filter(px), emit_channels(px) and for_each_pass(pass), not several");
    static_assert(!(OnePassFilter<F> && detail::says_leaves_signal<F>),
                  "Spatial{kernel}: a kernel with filter(px) makes the signal: it cannot say `leaves_signal`");
    using parts = Parts<F>;
    F kernel{}; ///< the filter
};
template <class F> Spatial(F) -> Spatial<F>;
/// @cond
Spatial()->Spatial<detail::Missing>; // which says what is missing
/// @endcond

namespace detail {
template <class T> inline constexpr bool is_temporal = false;
template <class M, class B, class F> inline constexpr bool is_temporal<Temporal<M, B, F>> = true;
template <class T> inline constexpr bool is_spatial = false;
template <class F> inline constexpr bool is_spatial<Spatial<F>> = true;

/// Whether no pass of a stage makes a new signal: FilterKernel::leaves_signal, or its only pass makes channels.
template <class Stage> inline constexpr bool leaves_signal = false;
template <class F> inline constexpr bool leaves_signal<Spatial<F>> = EmittingKernel<F> || says_leaves_signal<F>;

/// Whether a stage is a filter of several passes.
template <class Stage> inline constexpr bool has_passes = false;
template <class F> inline constexpr bool has_passes<Spatial<F>> = HasPasses<F>;

/// Calls `visit(pass)` for each pass of a stage.
template <class Stage, class Visit> constexpr void for_each_pass(Stage const& stage, Visit&& visit) {
    if constexpr (!is_spatial<Stage>)
        visit(stage);
    else if constexpr (has_passes<Stage>)
        stage.kernel.for_each_pass(visit);
    else
        visit(stage.kernel);
}

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

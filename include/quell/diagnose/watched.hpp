#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/blend/with_clean_up.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/diagnose/debug_channels.hpp>
#include <quell/filter/change/light_change.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/radiance/with_cones.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
template <class Real> QUELL_KERNEL Real code_of(Rejection rejection) { return Real(static_cast<float>(rejection)); }

/// The guide that a surface test compares.
template <class Test> constexpr Rejection rejection_by() {
    if constexpr (remembers_of<Test>::template has<Depth>)
        return Rejection::depth_test;
    else if constexpr (remembers_of<Test>::template has<Normal>)
        return Rejection::normal_test;
    else if constexpr (remembers_of<Test>::template has<Instance>)
        return Rejection::instance_test;
    else
        return Rejection::other_test;
}

/// Whether a test rejects all four past pixels around a place.
template <class Px, class Test> QUELL_KERNEL auto refuses(Px const& px, vec2<typename Px::Real> where, Test const& test) {
    using Real = typename Px::Real;
    TestedReprojection<Real, decltype(test.around(px))> const found{where, Real(1.f), test.around(px)};
    PixelCoordinates<Real> const place(floor(where.x - 0.5f), floor(where.y - 0.5f));
    auto accepted = Real(0.f) > Real(0.f);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) accepted = either(accepted, counts<Real>(px.past(place, i, j), found));
    return invert(accepted);
}
template <class Px, class Test> QUELL_KERNEL auto refusal(Px const& px, vec2<typename Px::Real> where, Test const& test) {
    using Real = typename Px::Real;
    return select(refuses(px, where, test), code_of<Real>(rejection_by<Test>()), code_of<Real>(Rejection::other_test));
}
template <class Px, class... Tests> QUELL_KERNEL auto refusal(Px const& px, vec2<typename Px::Real> where, AllOf<Tests...> const& all) {
    using Real = typename Px::Real;
    Real reason = code_of<Real>(Rejection::other_test);
    auto const unless_earlier = [&]<class Test>(Test const& test) QUELL_INLINED {
        auto const open = reason > code_of<Real>(Rejection::instance_test);
        reason = select(both(open, refuses(px, where, test)), code_of<Real>(rejection_by<Test>()), reason);
    };
    (unless_earlier(static_cast<Tests const&>(all)), ...);
    return reason;
}

/// Why a source's place has no past, if it has none.
template <class Px, class Source> QUELL_KERNEL auto rejection_of(Px const& px, Source const& source) {
    using Real = typename Px::Real;
    auto const found = source.previous(px);
    auto const place = sane(px, found);
    auto reason = code_of<Real>(Rejection::other_test);
    if constexpr (requires {
                      requires is_part<Source, decltype(Source::test)>;
                      requires is_surface_test<std::remove_cvref_t<decltype(Source::test)>>;
                  })
        reason = refusal(px, place.where, source.test);
    auto const says = both(is_finite(found.where.x), is_finite(found.where.y), found.validity > Real(0.f));
    reason = select(place.validity > Real(0.f), reason, code_of<Real>(Rejection::outside));
    return select(says, reason, code_of<Real>(Rejection::no_motion));
}

/// Index of the first source that finds a past, counted from `index`; 0 for none.
template <class Px, class Source, class Fetch>
QUELL_KERNEL auto source_of(Px const& px, Source const& source, Fetch const& fetch, float index) {
    using Real = typename Px::Real;
    if constexpr (is_chain<Source>) {
        auto const here = fetch.fetch(px, source.first.previous(px)).validity > Real(0.f);
        return select(here, Real(index), source_of(px, source.rest, fetch, index + 1.f));
    } else
        return masked(fetch.fetch(px, source.previous(px)).validity > Real(0.f), Real(index));
}
template <class Source> QUELL_KERNEL auto const& first_of(Source const& source) {
    if constexpr (is_chain<Source>)
        return source.first;
    else
        return source;
}
} // namespace detail

/// Blend policy inside a clamp that keeps DebugClamp, how far the clamp moved the past.
/// @tparam Inner the wrapped blend policy
template <class Inner> struct WatchedClamp {
    using parts = Parts<Inner>;
    using keeps = Channels<DebugClamp>;
    Inner inner{}; ///< the wrapped blend policy

    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        return result.with(debug_clamp, select(past.validity > decltype(past.validity)(0.f), past.clamped, decltype(past.clamped)(0.f)));
    }
};

/// Blend policy that does what `Inner` does and keeps DebugLength, DebugSource and DebugRejection.
/// @tparam M the stage's motion source
/// @tparam Inner the wrapped blend policy
/// @tparam Fetch the stage's history fetch
template <class M, class Inner, class Fetch> struct Watched {
    using parts = Parts<M, Inner, Fetch>;
    using keeps = Channels<DebugLength, DebugSource, DebugRejection>;
    M motion{};    ///< the stage's motion source
    Inner inner{}; ///< the wrapped blend policy
    Fetch fetch{}; ///< the stage's history fetch

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });
        auto const source = px.has_past() ? detail::source_of(px, motion, fetch, 1.f) : Real(0.f);
        auto const refused =
            px.has_past() ? detail::rejection_of(px, detail::first_of(motion)) : detail::code_of<Real>(Rejection::no_frame);
        auto const length = masked(past.validity > Real(0.f), past[debug_length]) + 1.f;
        auto const first = both(source > Real(0.5f), source < Real(1.5f));
        return result.with(debug_length, length).with(debug_source, source).with(debug_rejection, select(first, Real(0.f), refused));
    }
};

namespace detail {
// A blend policy with its clamps watched, also inside decorators.
template <class B> constexpr auto with_watched_clamps(B const& blend) { return blend; }
template <class B, class R, class A, int radius> constexpr auto with_watched_clamps(Clamped<B, R, A, radius> const& clamped) {
    return Clamped<WatchedClamp<B>, R, A, radius>{{clamped.inner}, clamped.range, clamped.axes};
}
template <class B> constexpr auto with_watched_clamps(WithMoments<B> const& around) {
    return WithMoments<decltype(with_watched_clamps(around.inner))>{with_watched_clamps(around.inner)};
}
template <class B> constexpr auto with_watched_clamps(WithCones<B> const& around) {
    return WithCones<decltype(with_watched_clamps(around.inner))>{with_watched_clamps(around.inner)};
}
template <class B> constexpr auto with_watched_clamps(ForgetChanged<B> const& around) {
    return ForgetChanged<decltype(with_watched_clamps(around.inner))>{with_watched_clamps(around.inner), around.noise_threshold,
                                                                      around.sharpness};
}

template <class Stage> constexpr auto watched_stage(Stage const& stage) { return stage; }
template <class M, class B, class F> constexpr auto watched_stage(Temporal<M, B, F> const& stage) {
    auto const blending = with_watched_clamps(stage.blending);
    using Blend = Watched<M, std::remove_const_t<decltype(blending)>, F>;
    return Temporal<M, Blend, F>{stage.motion, Blend{stage.motion, blending, stage.fetch}, stage.fetch};
}
} // namespace detail

/// The same pipeline, which keeps DebugChannels in its history for debug_images(): `constexpr auto debug = watched(denoise);` It costs
/// about three times as much. Frames need the same channels.
template <ChannelTag S, class... Parts> constexpr auto watched(Pipeline<S, Parts...> const& pipeline) {
    return std::apply(
        [&](auto const&... stages) {
            constexpr Supplied<Pipeline<S, Parts...>::motion_convention> supplied;
            if constexpr (std::is_same_v<typename Pipeline<S, Parts...>::Suppression, NoSuppression>)
                return Pipeline{S{}, supplied, pipeline.ingest.modulation, detail::watched_stage(stages)...};
            else
                return Pipeline{S{}, supplied, pipeline.ingest.modulation, pipeline.ingest.suppression, detail::watched_stage(stages)...};
        },
        pipeline.stages);
}
/// Watches each pipeline of a composite.
template <class... Ps> constexpr auto watched(Composite<Ps...> const& composite) {
    return std::apply([](auto const&... pipelines) { return Composite{watched(pipelines)...}; }, composite.pipelines);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

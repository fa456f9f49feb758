#pragma once

#include <quell/frame/earlier.hpp>
#include <quell/pipeline/ingest.hpp>
#include <quell/pipeline/stage.hpp>

#include <tuple>

namespace quell::inline QUELL_INSTRUCTION_SET {

template <ChannelTag S, class... Elements> struct Pipeline;

namespace detail {
template <class T> inline constexpr bool begins_no_pipeline = !ChannelTag<T>;
template <class S, class... Elements> inline constexpr bool begins_no_pipeline<Pipeline<S, Elements...>> = false;
template <class T> inline constexpr bool is_stage = is_temporal<T> || is_spatial<T>;
template <class T>
inline constexpr bool is_input_option =
    Modulation<T> || std::is_same_v<T, SuppressFireflies> || std::is_same_v<T, KnownSamples> || is_supplied<T>;

/// The convention of the Supplied<> among the options, or quell's own.
template <class... Elements> struct ConventionOf { static constexpr MotionConvention value{}; };
template <MotionConvention convention, class... Elements> struct ConventionOf<Supplied<convention>, Elements...> {
    static constexpr MotionConvention value = convention;
};
template <class First, class... Elements> struct ConventionOf<First, Elements...> : ConventionOf<Elements...> {};

/// The option of type `Wanted`, or `Nothing`.
template <class Wanted, class Nothing, class... Elements> constexpr auto option_of(Elements const&... elements) {
    if constexpr ((std::is_same_v<Wanted, Elements> || ...))
        return std::get<Wanted>(std::tuple<Elements...>(elements...));
    else
        return Nothing{};
}
template <class... Rest> constexpr auto modulation_of(Rest const&...) { return NoModulation{}; }
template <class First, class... Rest> constexpr auto modulation_of(First const& first, Rest const&... rest) {
    if constexpr (Modulation<First>)
        return first;
    else
        return modulation_of(rest...);
}
template <class C> inline constexpr bool is_made_by_stages = false;
template <class C>
    requires is_constant<decltype(&C::made_by_stages), bool>
inline constexpr bool is_made_by_stages<C> = C::made_by_stages;
template <class... Cs> constexpr bool any_made_by_stages(Channels<Cs...>) { return (is_made_by_stages<Cs> || ...); }
template <class... Cs> constexpr bool all_of_frame_size(Channels<Cs...>) { return ((Cs::fraction == 1) && ...); }
/// Whether no stage reads what only a later one makes. A filter's own passes may read what earlier ones make.
template <class Before, class All, class... Stages> inline constexpr bool in_order = true;
template <class Before, class All, class S, class... Later>
inline constexpr bool in_order<Before, All, S, Later...> =
    contained_in<common_to<reads_of<S>, All>,
                 std::conditional_t<is_temporal<S>, Before, decltype(Before{} | keeps_of<S>{} | emits_of<S>{})>>&&
        in_order<decltype(Before{} | keeps_of<S>{} | emits_of<S>{}), All, Later...>;

template <class Element> constexpr auto stage_or_nothing(Element const& element) {
    if constexpr (is_stage<Element>)
        return std::tuple<Element>(element);
    else
        return std::tuple<>();
}
} // namespace detail

/// How one signal is denoised: a constant description that holds no images.
///
///     constexpr auto denoise = Pipeline{radiance, Demodulate{}, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous{}}};
///
/// The signal's channel comes first. Options follow: a modulation such as Demodulate{}, SuppressFireflies{}, KnownSamples{}, Supplied<>{}.
/// Then come the stages in order, with at most one Temporal. Mistakes are compile-time errors.
/// @tparam S     the channel of the signal
/// @tparam Elements options and stages
template <ChannelTag S, class... Elements> struct Pipeline {
    static_assert((detail::check_hooks<Elements>() && ...));
    static_assert(((detail::is_stage<Elements> || detail::is_input_option<Elements>)&&...),
                  "Pipeline{channel, options..., stages...}: each must be Temporal{...}, Spatial{...}, Demodulate{}, SuppressFireflies{}, "
                  "KnownSamples{} or Supplied<...>{}, see quell/pipeline/stage.hpp");
    static_assert((0 + ... + int(detail::is_temporal<Elements>)) <= 1,
                  "Pipeline{channel, options..., stages...}: one Temporal at most, since there is one history; use FirstValid to combine "
                  "motion sources");

    static_assert((0 + ... + int(Modulation<Elements>)) <= 1, "Pipeline{channel, options..., stages...}: one modulation at most");
    static_assert((0 + ... + int(detail::is_supplied<Elements>)) <= 1, "Pipeline{channel, options..., stages...}: one Supplied<> at most");
    static_assert((0 + ... + int(std::is_same_v<Elements, SuppressFireflies>)) <= 1,
                  "Pipeline{channel, options..., stages...}: one SuppressFireflies{}");
    static_assert(detail::in_order<Channels<>, decltype(keeps_of<Elements...>{} | emits_of<Elements...>{}), Elements...>,
                  "Pipeline{channel, options..., stages...}: a stage reads what only a later one makes: detectors and splats go before "
                  "Temporal, filters "
                  "of what Temporal makes (VarianceGuidedAtrous, CleanUp) behind it");

    using Output = S;                                                          ///< channel of the input and the output
    using Form = decltype(detail::modulation_of(std::declval<Elements>()...)); ///< the modulation, or NoModulation
    static_assert(detail::Converts<Form>, "Pipeline{channel, options..., stages...}: a modulation must have inward(px, sample) and "
                                          "outward(px, value), see quell/frame/modulation.hpp");
    using Signal = typename Form::template Signal<S>; ///< channel of the signal between modulation and demodulation
    using Suppression =
        decltype(detail::option_of<SuppressFireflies, NoSuppression>(std::declval<Elements>()...)); ///< SuppressFireflies or NoSuppression
    using keeps = keeps_of<Elements...>;                      ///< channels that policies make and keep for the next frame
    using made = decltype(keeps{} | emits_of<Elements...>{}); ///< all channels that stages make
    using remembers = remembers_of<Elements...>;              ///< channels of the host that the history copies for the next frame
    using reads = decltype(Channels<S>{} | without<reads_of<Elements...>, made>{} | remembers{}); ///< channels that the host must supply
    static_assert(
        !detail::any_made_by_stages(reads{}),
        "Pipeline{channel, options..., stages...}: a stage reads what none of them makes: history_length wants RunningMean or Adaptive, "
        "luminance_variance WithMoments, clean_up_deviation WithCleanUp, light_change ChangeDetector, a shadow's track "
        "ShadowSplat, cones WithCones, blur's channels its guides");
    using carries = decltype(detail::carried(reads_kept_of<Elements...>{})); ///< of channels that it keeps, what they were in frames before
    static_assert(contained_in<decltype(detail::kept_as(reads_kept_of<Elements...>{})), keeps>,
                  "Pipeline{channel, options..., stages...}: a stage looks at what no "
                  "blend policy keeps: a BiasEstimate wants WithVariance{ForgetBiased{"
                  "RunningMean{}}}");
    static_assert(
        detail::all_of_frame_size(decltype(keeps{} | remembers{}){}),
        "Pipeline{channel, options..., stages...}: what is kept or remembered for the next frame must be of the frame's size (fraction 1)");
    /// Channels of KnownSamples{}, where it is among the options.
    using known_samples = std::conditional_t<(std::is_same_v<KnownSamples, Elements> || ...), KnownSamples::reads, Channels<>>;
    /// What the host's motion vectors mean: see Supplied.
    static constexpr MotionConvention motion_convention = detail::ConventionOf<Elements...>::value;
    static constexpr bool has_temporal = (detail::is_temporal<Elements> || ...); ///< whether there is a Temporal
    /// Whether frames depend on the one before.
    static constexpr bool has_past = has_temporal || keeps::size > 0 || remembers::size > 0;
    static constexpr bool needs_camera = (needs_camera_of<Elements> || ...);   ///< whether frame.camera must be set
    static constexpr bool checks_jitter = (checks_jitter_of<Elements> || ...); ///< whether frame.camera.jitter must be in range

    /// The first pass.
    detail::Ingest<S, Form, Suppression, common_to<without<detail::CheckedGuides, Channels<S>>, reads>> ingest;
    /// The stages, in order.
    decltype(std::tuple_cat(detail::stage_or_nothing(std::declval<Elements>())...)) stages;

    /// @param elements options and stages
    constexpr explicit Pipeline(S, Elements const&... elements)
        : ingest{detail::modulation_of(elements...), detail::option_of<SuppressFireflies, NoSuppression>(elements...)},
          stages(std::tuple_cat(detail::stage_or_nothing(elements)...)) {}

    /// @cond
    template <class First, class... Rest>
        requires detail::begins_no_pipeline<First>
    constexpr explicit Pipeline(First const&, Rest const&...) {
        static_assert(sizeof(First) == 0,
                      "Pipeline{channel, options..., stages...}: the channel of the signal comes first, such as quell::radiance");
    }
    /// @endcond

    /// Calls `visit(pass)` for each pass after the ingest, in order.
    constexpr void for_each_pass(auto&& visit) const {
        std::apply([&](auto const&... stage) { (detail::for_each_pass(stage, visit), ...); }, stages);
    }
};
/// @cond
template <class First, class... Rest>
    requires detail::begins_no_pipeline<First> Pipeline(First const&, Rest const&...)
->Pipeline<Radiance>;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/pipeline/ingest.hpp>
#include <quell/pipeline/stage.hpp>

#include <tuple>

namespace quell::inline QUELL_INSTRUCTION_SET {

template <ChannelTag S, class... Parts> struct Pipeline;

namespace detail {
template <class T> inline constexpr bool begins_no_pipeline = !ChannelTag<T>;
template <class S, class... Parts> inline constexpr bool begins_no_pipeline<Pipeline<S, Parts...>> = false;
template <class T> inline constexpr bool is_stage = is_temporal<T> || is_spatial<T>;
template <class T>
inline constexpr bool is_input_option =
    Modulation<T> || std::is_same_v<T, SuppressFireflies> || std::is_same_v<T, KnownSamples> || is_supplied<T>;

/// The convention of the Supplied<> among the parts, or quell's own.
template <class... Parts> struct ConventionOf { static constexpr MotionConvention value{}; };
template <MotionConvention convention, class... Parts> struct ConventionOf<Supplied<convention>, Parts...> {
    static constexpr MotionConvention value = convention;
};
template <class First, class... Parts> struct ConventionOf<First, Parts...> : ConventionOf<Parts...> {};

/// The part of type `Wanted`, or `Nothing`.
template <class Wanted, class Nothing, class... Parts> constexpr auto option_of(Parts const&... parts) {
    if constexpr ((std::is_same_v<Wanted, Parts> || ...))
        return std::get<Wanted>(std::tuple<Parts...>(parts...));
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
    contained_in<common_to<reads_of<S>, All>, std::conditional_t<is_temporal<S>, Before, decltype(Before{} | emits_of<S>{})>>&&
        in_order<decltype(Before{} | keeps_of<S>{} | emits_of<S>{}), All, Later...>;

template <class Part> constexpr auto stage_or_nothing(Part const& part) {
    if constexpr (is_stage<Part>)
        return std::tuple<Part>(part);
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
/// @tparam Parts options and stages
template <ChannelTag S, class... Parts> struct Pipeline {
    static_assert((detail::check_hooks<Parts>() && ...));
    static_assert(((detail::is_stage<Parts> || detail::is_input_option<Parts>)&&...),
                  "Pipeline{channel, parts...}: each part must be Temporal{...}, Spatial{...}, Demodulate{}, Cones{}, SuppressFireflies{}, "
                  "KnownSamples{} or Supplied<...>{}, see "
                  "quell/pipeline/stage.hpp");
    static_assert(
        (0 + ... + int(detail::is_temporal<Parts>)) <= 1,
        "Pipeline{channel, parts...}: one Temporal at most, since there is one history; use FirstValid to combine motion sources");

    static_assert((0 + ... + int(Modulation<Parts>)) <= 1, "Pipeline{channel, parts...}: one modulation at most");
    static_assert((0 + ... + int(detail::is_supplied<Parts>)) <= 1, "Pipeline{channel, parts...}: one Supplied<> at most");
    static_assert((0 + ... + int(std::is_same_v<Parts, SuppressFireflies>)) <= 1, "Pipeline{channel, parts...}: one SuppressFireflies{}");
    static_assert(
        detail::in_order<Channels<>, decltype(keeps_of<Parts...>{} | emits_of<Parts...>{}), Parts...>,
        "Pipeline{channel, parts...}: a stage reads what only a later one makes: detectors and splats go before Temporal, filters "
        "of what Temporal makes (VarianceGuidedAtrous, CleanUp) behind it");

    using Output = S;                                                       ///< channel of the input and the output
    using Form = decltype(detail::modulation_of(std::declval<Parts>()...)); ///< the modulation, or NoModulation
    static_assert(
        detail::Converts<Form>,
        "Pipeline{channel, parts...}: a modulation must have inward(px, sample) and outward(px, value), see quell/frame/modulation.hpp");
    using Signal = typename Form::template Signal<S>; ///< channel of the signal between modulation and demodulation
    using Suppression =
        decltype(detail::option_of<SuppressFireflies, NoSuppression>(std::declval<Parts>()...)); ///< SuppressFireflies or NoSuppression
    using keeps = keeps_of<Parts...>;                      ///< channels that policies make and keep for the next frame
    using made = decltype(keeps{} | emits_of<Parts...>{}); ///< all channels that stages make
    using remembers = remembers_of<Parts...>;              ///< channels of the host that the history copies for the next frame
    using reads = decltype(Channels<S>{} | without<reads_of<Parts...>, made>{} | remembers{}); ///< channels that the host must supply
    static_assert(!detail::any_made_by_stages(reads{}),
                  "Pipeline{channel, parts...}: a stage reads what none of them makes: history_length wants RunningMean or Adaptive, "
                  "luminance_variance WithMoments, clean_up_deviation WithCleanUp, light_change ChangeDetector, a shadow's track "
                  "ShadowSplat, a gradient TemporalGradient, cones WithCones or Cones, blur's channels its guides");
    static_assert(
        contained_in<reads_kept_of<Parts...>, keeps>,
        "Pipeline{channel, parts...}: a stage looks at what no blend policy keeps: a BiasEstimate wants WithVariance{ForgetBiased{"
        "RunningMean{}}}");
    static_assert(detail::all_of_frame_size(decltype(keeps{} | remembers{}){}),
                  "Pipeline{channel, parts...}: what is kept or remembered for the next frame must be of the frame's size (fraction 1)");
    /// Channels of KnownSamples{}, where it is among the parts.
    using known_samples = std::conditional_t<(std::is_same_v<KnownSamples, Parts> || ...), KnownSamples::reads, Channels<>>;
    /// What the host's motion vectors mean: see Supplied.
    static constexpr MotionConvention motion_convention = detail::ConventionOf<Parts...>::value;
    static constexpr bool has_past = (detail::is_temporal<Parts> || ...); ///< whether there is a Temporal
    static constexpr bool needs_camera = (needs_camera_of<Parts> || ...); ///< whether frame.camera must be set

    /// The first pass.
    detail::Ingest<S, Form, Suppression, common_to<without<detail::CheckedGuides, Channels<S>>, reads>> ingest;
    /// The stages, in order.
    decltype(std::tuple_cat(detail::stage_or_nothing(std::declval<Parts>())...)) stages;

    /// @param parts options and stages
    constexpr explicit Pipeline(S, Parts const&... parts)
        : ingest{detail::modulation_of(parts...), detail::option_of<SuppressFireflies, NoSuppression>(parts...)},
          stages(std::tuple_cat(detail::stage_or_nothing(parts)...)) {}

    /// @cond
    template <class First, class... Rest>
        requires detail::begins_no_pipeline<First>
    constexpr explicit Pipeline(First const&, Rest const&...) {
        static_assert(sizeof(First) == 0, "Pipeline{channel, parts...}: the channel of the signal comes first, such as quell::radiance");
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

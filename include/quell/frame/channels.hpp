#pragma once

#include <quell/core/policy.hpp>

#include <array>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

// The channels that a renderer can supply. A pipeline needs only those that its policies read. The names are those of layers in EXR files.

/// Base of linear colours.
struct Colour : Channel<3> {
    static constexpr std::string_view component_names = "RGB"; ///< in files
};
/// Base of points in world space.
struct WorldPoint : Channel<3> {
    static constexpr bool full_precision = true; ///< never half
};
/// Base of points in world space that a ray hit; not finite where it hit nothing.
struct HitPoint : WorldPoint {};
/// Base of ways on the screen, in pixels, y down.
struct ScreenVector : Channel<2> {
    static constexpr bool full_precision = true; ///< never half
};

/// Linear, scene-referred radiance: the whole image, or any other signal that is to be denoised as one colour.
struct Radiance : Colour {
    static constexpr auto name = "radiance"; ///< EXR layer
};
/// Radiance and alpha of a film that is transparent where nothing was hit: premultiplied, as renderers write them. Both are filtered by the
/// same weights, those of the colour.
struct RadianceAlpha : Channel<4> {
    static constexpr auto name = "radiance_alpha";              ///< EXR layer
    static constexpr std::string_view component_names = "RGBA"; ///< in files
};
/// Diffuse reflectance in [0, 1], by which the signal is demodulated. 1 for a miss and on emitters.
struct Albedo : Colour {
    static constexpr auto name = "albedo";           ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
    static constexpr bool is_guide = true;           ///< every pixel must have it
};
/// Surface normal in world space, unit length.
struct Normal : Channel<3> {
    static constexpr auto name = "normal";           ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
    static constexpr bool is_guide = true;           ///< every pixel must have it
};
/// Linear depth along the view axis in world units: > 0, +infinity for a miss.
struct Depth : Channel<1> {
    static constexpr auto name = "depth";                    ///< EXR layer
    static constexpr bool full_precision = true;             ///< never half
    static constexpr std::string_view component_names = "Z"; ///< in files
    static constexpr bool is_guide = true;                   ///< every pixel must have it
};
/// World-space position of the surface point.
struct Position : WorldPoint {
    static constexpr auto name = "position";         ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
};
/// Object id: any number that is exact in float and the same in every frame.
struct Instance : Channel<1> {
    static constexpr auto name = "instance";                  ///< EXR layer
    static constexpr bool full_precision = true;              ///< never half
    static constexpr std::string_view component_names = "ID"; ///< in files
    static constexpr bool finite_on_surfaces = true;          ///< else diagnose() says so
};
/// Perceptual GGX roughness in [0, 1]; alpha = roughness^2.
struct Roughness : Channel<1> {
    static constexpr auto name = "roughness";                ///< EXR layer
    static constexpr std::string_view component_names = "R"; ///< in files
    static constexpr bool finite_on_surfaces = true;         ///< else diagnose() says so
};
/// Motion vector to the previous frame, in pixels, y down: previous position = current position + motion.
struct Motion : ScreenVector {
    static constexpr auto name = "motion";           ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
    static constexpr bool is_guide = true;           ///< every pixel must have it
};

/// Motion vector to the next frame, in pixels, y down: next position = current position + motion_next. For two-sided accumulation
/// (pipeline/two_sided.hpp).
struct MotionNext : ScreenVector {
    static constexpr auto name = "motion_next"; ///< EXR layer
    static constexpr bool is_guide = true;      ///< every pixel must have it
};
/// The number of samples that the signal's value is the mean of: positive, in any unit that is the same in all frames. Read with
/// KnownSamples{}.
struct SampleCount : Channel<1> {
    static constexpr auto name = "sample_count"; ///< EXR layer
    static constexpr bool full_precision = true; ///< never half
};
/// The variance of the luminance of one such sample at this pixel; of the demodulated signal where the pipeline demodulates. 0: unknown.
/// Read with KnownSamples{}.
struct SampleVariance : Channel<1> {
    static constexpr auto name = "sample_variance"; ///< EXR layer
    static constexpr bool full_precision = true;    ///< never half
};

/// Direct light without shadows, noise-free: linear radiance.
struct Direct : Colour {
    static constexpr auto name = "direct";           ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
};
/// Visibility of the light sample: 1 visible, 0 blocked.
struct Visibility : Channel<1> {
    static constexpr auto name = "visibility"; ///< EXR layer
};
/// World-space position of the light sample.
struct Light : WorldPoint {
    static constexpr auto name = "light"; ///< EXR layer
};
/// World-space position of the same point of the light in the previous frame.
struct LightPrevious : WorldPoint {
    static constexpr auto name = "light_previous"; ///< EXR layer
};
/// World-space point that the shadow ray hit; not finite where it hit nothing.
struct Blocker : HitPoint {
    static constexpr auto name = "blocker"; ///< EXR layer
};
/// World-space position of that point in the previous frame.
struct BlockerPrevious : HitPoint {
    static constexpr auto name = "blocker_previous"; ///< EXR layer
};
/// World-space position, in the previous frame, of the surface point seen in the pixel.
struct ReceiverPrevious : WorldPoint {
    static constexpr auto name = "receiver_previous"; ///< EXR layer
    static constexpr bool finite_on_surfaces = true;  ///< else diagnose() says so
};

/// Glossy reflection: reflected radiance times specular reflectance.
struct Glossy : Colour {
    static constexpr auto name = "glossy"; ///< EXR layer
};
/// World-space point that the reflected ray hit; not finite for a miss.
struct GlossyHit : HitPoint {
    static constexpr auto name = "glossy_hit"; ///< EXR layer
};
/// World-space position of that point in the previous frame.
struct GlossyHitPrevious : HitPoint {
    static constexpr auto name = "glossy_hit_previous"; ///< EXR layer
};

/// Incident radiance of one indirect sample, drawn by the cosine over the hemisphere.
struct Indirect : Colour {
    static constexpr auto name = "indirect"; ///< EXR layer
};
/// World-space unit direction that the indirect sample came from.
struct IndirectDirection : Channel<3> {
    static constexpr auto name = "indirect_direction"; ///< EXR layer
    static constexpr bool finite_on_surfaces = true;   ///< else diagnose() says so
};

/// Displacement on the screen while the shutter is open, in pixels, y down: position(t = 1) - position(t = 0).
struct Sweep : ScreenVector {
    static constexpr auto name = "sweep";            ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
};
/// Curvature of the trajectory over the open shutter, in pixels, y down: position(0.5) minus the mean of position(0) and position(1). To
/// second order, position(t) = position(0) + sweep t + 4 bend t (1 - t). 0 for straight motion at constant speed.
struct SweepBend : ScreenVector {
    static constexpr auto name = "sweep_bend";       ///< EXR layer
    static constexpr bool finite_on_surfaces = true; ///< else diagnose() says so
};
/// Time of the sample, in [0, 1]: 0 when the shutter opens, 1 when it closes.
struct Time : Channel<1> {
    static constexpr auto name = "time";                     ///< EXR layer
    static constexpr bool full_precision = true;             ///< never half
    static constexpr std::string_view component_names = "T"; ///< in files
    static constexpr bool finite_on_surfaces = true;         ///< else diagnose() says so
};

namespace detail {
/// The channel's name between a prefix and a suffix, without a terminating zero.
template <ChannelTag C, std::size_t Before, std::size_t Behind>
constexpr auto extended_name(char const (&before)[Before], char const (&behind)[Behind]) {
    constexpr std::string_view name = C::name;
    std::array<char, Before - 1 + name.size() + Behind - 1> letters{};
    std::size_t count = 0;
    for (std::string_view part : {std::string_view(before), name, std::string_view(behind)})
        for (char letter : part) letters[count++] = letter;
    return letters;
}
template <ChannelTag C> inline constexpr auto gradient_name = extended_name<C>("", "_gradient");
template <ChannelTag C> inline constexpr auto sweep_name = extended_name<C>("sweep_", "");
} // namespace detail

/// Temporal gradient of a signal (A-SVGF, Schied et al. 2018). One pixel of each 3x3 shades its surface point with the same random numbers
/// in the previous and in this frame. Component 0: luminance now minus luminance before. Component 1: the larger of the two. Both are 0 in
/// all other pixels, and where the point was not seen before.
/// @tparam Signal the channel that is denoised
template <ChannelTag Signal> struct GradientOf : Channel<2> {
    /// EXR layer.
    static constexpr std::string_view name{detail::gradient_name<Signal>.data(), detail::gradient_name<Signal>.size()};
};

/// Displacement over the open shutter of what a signal's sample saw, in pixels, y down. For Visibility: of the shadow on the receiver's
/// tangent plane (see ShadowMotion). For Glossy: of the virtual image in a flat mirror (see ImageMotion). Without a blocker or a reflected
/// hit it is the surface's own Sweep.
/// @tparam Signal Visibility or Glossy
template <ChannelTag Signal> struct SweepOf : ScreenVector {
    /// EXR layer.
    static constexpr std::string_view name{detail::sweep_name<Signal>.data(), detail::sweep_name<Signal>.size()};
    static constexpr bool full_precision = true; ///< never half
};

// What code indexes with: frame[radiance], px[radiance].
/// @cond
inline constexpr Radiance radiance;
inline constexpr RadianceAlpha radiance_alpha;
inline constexpr Albedo albedo;
inline constexpr Normal normal;
inline constexpr Depth depth;
inline constexpr Position position;
inline constexpr Instance instance;
inline constexpr Roughness roughness;
inline constexpr Motion motion;
inline constexpr MotionNext motion_next;
inline constexpr SampleCount sample_count;
inline constexpr SampleVariance sample_variance;
inline constexpr Direct direct;
inline constexpr Visibility visibility;
inline constexpr Light light;
inline constexpr LightPrevious light_previous;
inline constexpr Blocker blocker;
inline constexpr BlockerPrevious blocker_previous;
inline constexpr ReceiverPrevious receiver_previous;
inline constexpr Glossy glossy;
inline constexpr GlossyHit glossy_hit;
inline constexpr GlossyHitPrevious glossy_hit_previous;
inline constexpr Indirect indirect;
inline constexpr IndirectDirection indirect_direction;
inline constexpr Sweep sweep;
inline constexpr SweepBend sweep_bend;
inline constexpr Time time;
/// @endcond

/// All channels that a file can hold, from which programs, tests and diagnose() take theirs. RadianceAlpha is not among them: files hold it
/// as a radiance and an alpha.
using AllChannels =
    Channels<Radiance, Albedo, Normal, Depth, Position, Instance, Roughness, Motion, MotionNext, SampleCount, SampleVariance, Direct,
             ReceiverPrevious, Visibility, Light, LightPrevious, Blocker, BlockerPrevious, Glossy, GlossyHit, GlossyHitPrevious, Indirect,
             IndirectDirection, Sweep, SweepBend, Time, GradientOf<Radiance>, SweepOf<Visibility>, SweepOf<Glossy>>;

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/core/policy.hpp>

#include <array>
#include <string_view>

namespace quell {

// What a renderer can hand over. A pipeline asks for only those that its policies read. Their names are those of the layers in EXR files.
// Units: radiance linear and scene-referred; positions in world space; Motion and Sweep in pixels, y down; Depth linear along the view
// axis, > 0, +inf for a miss; normals unit length, world space.

/// The whole image, or whatever signal the host wants denoised as one colour.
struct Radiance : Channel<3> {
    static constexpr auto name = "radiance";
};
/// Diffuse reflectance in [0, 1] that the signal is divided by before filtering; 1 where there is no surface and on emitters.
struct Albedo : Channel<3> {
    static constexpr auto name = "albedo";
};
struct Normal : Channel<3> {
    static constexpr auto name = "normal";
};
struct Depth : Channel<1> {
    static constexpr auto name = "depth";
    static constexpr bool full_precision = true;
};
struct Position : Channel<3> {
    static constexpr auto name = "position";
    static constexpr bool full_precision = true;
};
/// Which object: any number that is exact in float and the same in every frame.
struct Instance : Channel<1> {
    static constexpr auto name = "instance";
    static constexpr bool full_precision = true;
};
/// GGX roughness as artists give it (alpha = roughness squared), in [0, 1].
struct Roughness : Channel<1> {
    static constexpr auto name = "roughness";
};
/// Where this surface point was: previous position = current position + motion.
struct Motion : Channel<2> {
    static constexpr auto name = "motion";
    static constexpr bool full_precision = true;
};

/// Where this surface point will be: next position = current position + motion_next. For two-sided accumulation (pipeline/two_sided.hpp).
struct MotionNext : Channel<2> {
    static constexpr auto name = "motion_next";
    static constexpr bool full_precision = true;
};
/// How many samples the signal's value is the mean of, in any unit that is the same in all frames; positive. Hosts whose frames or pixels
/// differ in it say so with KnownSamples{}.
struct SampleCount : Channel<1> {
    static constexpr auto name = "sample_count";
    static constexpr bool full_precision = true;
};
/// The variance of the luminance of one such sample, at the pixel, in the form in which the signal is denoised (demodulated where the
/// pipeline demodulates); 0 where it isn't known.
struct SampleVariance : Channel<1> {
    static constexpr auto name = "sample_variance";
    static constexpr bool full_precision = true;
};

/// Direct light without shadows, noise-free.
struct Direct : Channel<3> {
    static constexpr auto name = "direct";
};
/// 1 where the light sample is seen, 0 where it is blocked.
struct Visibility : Channel<1> {
    static constexpr auto name = "visibility";
};
/// The light sample's position, and where that point of the light was in the previous frame.
struct Light : Channel<3> {
    static constexpr auto name = "light";
    static constexpr bool full_precision = true;
};
struct LightPrevious : Channel<3> {
    static constexpr auto name = "light_previous";
    static constexpr bool full_precision = true;
};
/// What the shadow ray hit (non-finite where it hit nothing), and where that point was.
struct Blocker : Channel<3> {
    static constexpr auto name = "blocker";
    static constexpr bool full_precision = true;
};
struct BlockerPrevious : Channel<3> {
    static constexpr auto name = "blocker_previous";
    static constexpr bool full_precision = true;
};
/// Where the point seen in the pixel was in the previous frame.
struct ReceiverPrevious : Channel<3> {
    static constexpr auto name = "receiver_previous";
    static constexpr bool full_precision = true;
};

/// Reflected radiance times the specular reflectance.
struct Glossy : Channel<3> {
    static constexpr auto name = "glossy";
};
/// What the reflected ray hit (non-finite for a miss), and where that point was.
struct GlossyHit : Channel<3> {
    static constexpr auto name = "glossy_hit";
    static constexpr bool full_precision = true;
};
struct GlossyHitPrevious : Channel<3> {
    static constexpr auto name = "glossy_hit_previous";
    static constexpr bool full_precision = true;
};

/// Incident radiance of the one indirect sample, cosine-weighted over the hemisphere, and the direction that it came from.
struct Indirect : Channel<3> {
    static constexpr auto name = "indirect";
};
struct IndirectDirection : Channel<3> {
    static constexpr auto name = "indirect_direction";
};

/// Displacement over the open shutter, position(t = 1) - position(t = 0).
struct Sweep : Channel<2> {
    static constexpr auto name = "sweep";
    static constexpr bool full_precision = true;
};
/// How far the way over the open shutter bends: to second order, position(t) = position(0) + sweep t + bend 4 t (1 - t), so that it is
/// position(0.5) less the mean of both ends. 0 for straight motion at an even speed.
struct SweepBend : Channel<2> {
    static constexpr auto name = "sweep_bend";
    static constexpr bool full_precision = true;
};
/// The sample's time in [0, 1] over the open shutter.
struct Time : Channel<1> {
    static constexpr auto name = "time";
    static constexpr bool full_precision = true;
};

namespace detail {
/// The channel's name between two other words, without a terminating zero.
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

/// How much a signal changed by itself from the last frame to this one (A-SVGF, Schied 2018): one pixel of each 3x3 shades its surface
/// point with the same random numbers in both frames. First the luminance now less the luminance before, then the larger of the two; both
/// 0 in all other pixels, and where the point was not seen before.
template <ChannelTag Signal> struct GradientOf : Channel<2> {
    static constexpr std::string_view name{detail::gradient_name<Signal>.data(), detail::gradient_name<Signal>.size()};
};

/// How far that moves over the open shutter which a signal's sample saw, in pixels like Sweep: for Visibility the shadow that falls on the
/// pixel, along the receiver's tangent plane (see ShadowMotion); for Glossy the virtual image of what is reflected, in a flat mirror (see
/// ImageMotion). Where the sample saw no blocker, or reflected nothing, it is the surface's own sweep.
template <ChannelTag Signal> struct SweepOf : Channel<2> {
    static constexpr std::string_view name{detail::sweep_name<Signal>.data(), detail::sweep_name<Signal>.size()};
    static constexpr bool full_precision = true;
};

inline constexpr Radiance radiance;
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

/// Every channel that files may hold, in the order in which they list them.
using AllChannels =
    Channels<Radiance, Albedo, Normal, Depth, Position, Instance, Roughness, Motion, Direct, Visibility, Light, LightPrevious, Blocker,
             BlockerPrevious, ReceiverPrevious, Glossy, GlossyHit, GlossyHitPrevious, Indirect, IndirectDirection, Sweep, Time>;

} // namespace quell

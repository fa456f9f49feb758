#pragma once

#include <quell/blend/clamped.hpp>
#include <quell/core/real.hpp>
#include <quell/resolve/sharpening.hpp>

#include <concepts>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How much a sample tells about an output pixel: a Gaussian of the distance between the two. Kernels of a Resolve have weight(d2).
struct GaussianKernel {
    float deviation = 0.45f; ///< in output pixels, > 0

    /// 1 at the pixel's centre. The namespace is named, since xsimd has an exp for packs with other bits.
    /// @param squared_distance in output pixels
    template <class Real> QUELL_KERNEL Real weight(Real squared_distance) const {
        return quell::exp(squared_distance * (-0.5f / (deviation * deviation)));
    }
};

namespace detail {
template <class K>
concept WeighsDistance = requires(K const& kernel) {
    { kernel.weight(1.f) } -> std::same_as<float>;
};
/// What a Resolve clamps to unless it is told otherwise. Samples of other places differ more than noise does.
template <class Range> inline constexpr Range range_of_resolve{};
template <> inline constexpr MeanDeviation range_of_resolve<MeanDeviation>{.sigmas = 1.5f};
} // namespace detail

/// Temporal anti-aliasing and upsampling. Samples of the last frames are moved along their motion to where they are now. Each output pixel
/// takes a mean of them, in which a sample weighs by how near it lies to the pixel's centre. With jitter, or with any motion, samples of
/// many places meet at each pixel: edges become smooth, and an output that is larger than the input becomes sharp.
///
/// Usual temporal anti-aliasing (Yang, Liu and Salvi 2020, "A Survey of Temporal Antialiasing Techniques") keeps one picture and moves it
/// from frame to frame, which blurs it a little each time. Here the frames themselves are kept, at the input's size. As there, the past is
/// sought along the motion of the nearest surface in the 3x3 around, so that edges move with what they belong to, and clamped to the range
/// of the 3x3 around. A sample whose depth is none of those around counts nothing.
/// @tparam Kernel     how a sample's distance weighs: GaussianKernel, or another one with weight(squared distance)
/// @tparam Range      MinMax, MeanDeviation, or another one with `low` and `high` (blend/clamped.hpp)
/// @tparam Axes       the colour space in which the past is clamped: YCoCg or Rgb
/// @tparam Sharpening what happens to the output: NoSharpening or Sharpen
/// @tparam frames     how many frames of the past are kept, 1 to 15
template <class Kernel = GaussianKernel, class Range = MeanDeviation, class Axes = YCoCg, class Sharpening = NoSharpening, int frames = 6>
struct Resolve {
    static_assert(detail::WeighsDistance<Kernel>,
                  "Resolve{kernel, range, axes, sharpening}: `kernel` must have weight(squared distance), such as GaussianKernel{}");
    static_assert(detail::MeasuresRange<Range>, "Resolve{kernel, range, axes, sharpening}: `range` must have a Gatherer with add(value, "
                                                "weight, dx, dy), finish(range), `low` and `high`, see quell/blend/clamped.hpp");
    static_assert(detail::IsAxes<Axes>,
                  "Resolve{kernel, range, axes, sharpening}: `axes` must have from(value) and to(value), such as YCoCg{}");
    static_assert(frames >= 1 && frames <= 15, "Resolve<..., frames>: it keeps 1 to 15 frames");
    static constexpr int past_frames = frames; ///< that are kept

    Kernel kernel{};                               ///< how a sample's distance weighs
    Range range = detail::range_of_resolve<Range>; ///< what the past is clamped to
    Axes axes{};                                   ///< where that is a box
    Sharpening sharpening{};                       ///< of the output
    float depth_tolerance = 0.03f;                 ///< how far a past sample's depth may lie outside those around, as a part of them
};
/// @cond
Resolve()->Resolve<>;
template <class Kernel> Resolve(Kernel) -> Resolve<Kernel>;
template <class Kernel, class Range> Resolve(Kernel, Range) -> Resolve<Kernel, Range>;
template <class Kernel, class Range, class Axes> Resolve(Kernel, Range, Axes) -> Resolve<Kernel, Range, Axes>;
template <class Kernel, class Range, class Axes, class Sharpening>
Resolve(Kernel, Range, Axes, Sharpening) -> Resolve<Kernel, Range, Axes, Sharpening>;
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/metrics/picture.hpp>

#include <limits>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// Flicker of a sequence: the mean over pixels of the temporal standard deviation of (output - reference). Motion in the reference and
/// constant errors do not count. Frames are added one by one and not kept.
struct Flicker {
    Extent size;                     ///< of the frames
    int frames = 0;                  ///< number of frames added
    std::vector<glm::dvec3> average; ///< mean of (output - reference), per pixel and component
    std::vector<glm::dvec3> spread;  ///< sum of squared differences from the mean

    /// Adds the next frame of both sequences: displayed pictures.
    /// @throws Error where sizes differ or a component is outside [0, 1]
    void add(Picture const& reference, Picture const& output);
    /// Mean over the selected pixels. A pixel's deviation is the root of its three components' mean variance.
    /// @throws Error with fewer than two frames, or where the mask does not fit or selects nothing
    [[nodiscard]] double mean(Mask const& mask = {}) const;
};

/// Running mean and variance: Welford 1962, "Note on a method for calculating corrected sums of squares and products".
inline void Flicker::add(Picture const& reference, Picture const& output) {
    detail::check_pair(reference, output);
    if (frames > 0 && !(size == reference.size))
        raise_error<Failure>("flicker",
                             "frame " + std::to_string(frames) + " has size " + to_string(reference.size) + " but those before it " +
                                 to_string(size),
                             "add frames of one size");
    size = reference.size;
    average.resize(reference.pixels.size());
    spread.resize(reference.pixels.size());
    ++frames;
    for (std::size_t i = 0; i < average.size(); ++i) {
        auto const difference = glm::dvec3(output.pixels[i]) - glm::dvec3(reference.pixels[i]);
        auto const step = difference - average[i];
        average[i] += step / static_cast<double>(frames);
        spread[i] += step * (difference - average[i]);
    }
}

inline double Flicker::mean(Mask const& mask) const {
    if (frames < 2) raise_error<Failure>("flicker", "it has " + std::to_string(frames) + " frames", "add at least 2");
    return detail::mean_over(size, mask, [&](std::size_t i) {
        auto const& s = spread[i];
        return std::sqrt((s.x + s.y + s.z) / (3. * frames));
    });
}

/// Flicker of a whole sequence in memory.
/// @throws Error where the sequences differ in length, and as Flicker does
[[nodiscard]] inline double flicker(std::span<Picture const> references, std::span<Picture const> outputs, Mask const& mask = {}) {
    if (references.size() != outputs.size())
        raise_error<Failure>("flicker",
                             std::to_string(outputs.size()) + " outputs for " + std::to_string(references.size()) + " references",
                             "give one reference per output");
    Flicker sequence;
    for (std::size_t i = 0; i < outputs.size(); ++i) sequence.add(references[i], outputs[i]);
    return sequence.mean(mask);
}

namespace detail {
inline void check_event(std::span<double const> errors, std::size_t event) {
    if (event >= errors.size())
        raise_error<Failure>("lag", "the event is at frame " + std::to_string(event) + " of " + std::to_string(errors.size()),
                             "give an event within the sequence");
    constexpr auto infinity = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
    for (std::size_t i = event; i < errors.size(); ++i)
        if ((std::bit_cast<std::uint64_t>(errors[i]) & infinity) == infinity) // infinite or NaN: all bits of the exponent are set
            raise_error<Failure>("lag", "the error of frame " + std::to_string(i) + " is " + std::to_string(errors[i]),
                                 "give finite errors");
}
} // namespace detail

/// Settled error after an event: the median (the upper one of an even number) of the last quarter of the frames from the event on.
/// @param errors one per frame, finite
/// @param event index of the frame at which the scene changes
/// @throws Error where the event is not a frame or an error is not finite
[[nodiscard]] inline double settled_error(std::span<double const> errors, std::size_t event) {
    detail::check_event(errors, event);
    auto const after = errors.subspan(event);
    std::vector<double> last(after.end() - static_cast<std::ptrdiff_t>((after.size() + 3) / 4), after.end());
    auto const middle = last.begin() + static_cast<std::ptrdiff_t>(last.size() / 2);
    std::ranges::nth_element(last, middle);
    return *middle;
}

/// Lag: frames from the event until the error has fallen to 1.5 times its settled value; empty if it never does. The search begins at the
/// largest error after the event, as an error may rise over several frames.
/// @param errors one per frame, finite
/// @param event index of the frame at which the scene changes
/// @param settled see settled_error
/// @throws Error where the event is not a frame or an error is not finite
[[nodiscard]] inline std::optional<std::size_t> lag(std::span<double const> errors, std::size_t event, double settled) {
    detail::check_event(errors, event);
    auto const after = errors.subspan(event);
    auto const worst = std::ranges::max_element(after);
    auto const fallen = std::find_if(worst, after.end(), [&](double error) { return error <= 1.5 * settled; });
    if (fallen == after.end()) return std::nullopt;
    return fallen == worst ? 0 : static_cast<std::size_t>(fallen - after.begin()); // at the largest already: it never rose
}
/// The same with the settled error of this sequence.
[[nodiscard]] inline std::optional<std::size_t> lag(std::span<double const> errors, std::size_t event) {
    return lag(errors, event, settled_error(errors, event));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics

#pragma once

#include <quell/io/exr_image.hpp>
#include <quell/metrics/picture.hpp>
#include <tracer/mask.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quell::stability {

/// Which part of the picture a sequence is about.
enum class Signal { whole, shadow, glossy, indirect };

/// What to trace.
struct Shot {
    std::string scene;
    Signal signal = Signal::whole;
    int first = 0, scored_from = 0, last = 0; ///< frames; references and masks from `scored_from` on
    std::optional<tracer::Effect> effect{};   ///< whose mask is wanted
    float shutter = 0;
    int guide_samples = 0; ///< of guides that are means, where samples of a pixel see different things; 0: those of the signal
    std::function<void(tracer::SceneDescription&)> change{}; ///< made to the scene first
};

/// Frames as a renderer hands them over, and the truth about them. The channels `radiance` and `albedo` hold the signal's share of the
/// picture and what it is divided by before filtering, so that a method for any signal works on the same as those for this one.
struct ScoredSequence {
    Extent size;
    int first = 0, scored_from = 0;
    std::vector<io::ExrImage> frames;
    std::vector<metrics::Picture> references; ///< linear, of the share; from `scored_from` on, as are the masks
    std::vector<metrics::Mask> masks;

    [[nodiscard]] int last() const { return first + static_cast<int>(frames.size()) - 1; }
    [[nodiscard]] io::ExrImage const& frame(int number) const { return frames[static_cast<std::size_t>(number - first)]; }
    [[nodiscard]] metrics::Picture const& reference(int number) const { return references[static_cast<std::size_t>(number - scored_from)]; }
    /// The pixels that count in a frame; empty for all.
    [[nodiscard]] metrics::Mask mask(int number) const {
        return masks.empty() ? metrics::Mask{} : masks[static_cast<std::size_t>(number - scored_from)];
    }
};

/// How sequences are made.
struct Making {
    Extent size{160, 90};
    int threads = 0;           ///< 0: all
    double tolerance = 0.015;  ///< of references: mean FLIP between two independent halves
    int max_samples = 1024;    ///< of references, per pixel
    std::uint32_t seed = 0;    ///< of the noise
    int long_run = 10000;      ///< frames of the case drift
    int broken_frames = 10000; ///< of the case bounds
};

[[nodiscard]] ScoredSequence traced(Shot const& shot, Making const& making);

/// A channel's components in an image, which must have them.
[[nodiscard]] std::vector<float>& plane(io::ExrImage& image, std::string const& name);

} // namespace quell::stability

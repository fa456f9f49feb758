#pragma once

#include <quell/metrics/picture.hpp>
#include <tracer/render.hpp>

#include <memory>
#include <string>
#include <vector>

namespace quell::examples {

/// What is shown of a scene, frame after frame.
class DemoMethod {
public:
    /// A sort of picture: one word, which files are named by, and a line about it.
    struct Kind {
        std::string name, description;
    };
    virtual ~DemoMethod() = default;
    /// The noisy picture, the denoised one, then those that it is compared with.
    [[nodiscard]] virtual std::vector<Kind> kinds() const = 0;
    /// Traces and denoises the next frame. Pictures are linear, in the order of the kinds.
    [[nodiscard]] virtual std::vector<metrics::Picture> frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) = 0;
    /// What denoising takes: of the last frame, and of history and scratch.
    [[nodiscard]] virtual double milliseconds() const = 0;
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;
};

/// Shadows, reflections and indirect light, each by its own pipeline.
[[nodiscard]] std::unique_ptr<DemoMethod> all_effects(Extent size, int threads);
/// Motion blur, beside what post-processes make of a picture of the middle of the open shutter.
[[nodiscard]] std::unique_ptr<DemoMethod> motion_blur(Extent size, int threads);

} // namespace quell::examples

#pragma once

#include <quell/frame/camera.hpp>
#include <quell/io/exr_image.hpp>

#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// Camera from an image's attributes `quell:view`, `quell:projection` and `quell:jitter`, with an optional suffix: "_previous" is the last
/// frame's camera. Empty if a matrix is missing.
[[nodiscard]] inline std::optional<Camera> camera_of(ExrImage const& image, std::string const& suffix = "") {
    auto const* const view = image.attribute<glm::mat4>("quell:view" + suffix);
    auto const* const projection = image.attribute<glm::mat4>("quell:projection" + suffix);
    if (!view || !projection) return std::nullopt;
    auto const* const jitter = image.attribute<glm::vec2>("quell:jitter" + suffix);
    return Camera{*view, *projection, jitter ? *jitter : glm::vec2(0.f)};
}

inline void put_camera(ExrImage& image, Camera const& camera, std::string const& suffix = "") {
    image.attributes["quell:view" + suffix] = camera.view;
    image.attributes["quell:projection" + suffix] = camera.projection;
    image.attributes["quell:jitter" + suffix] = camera.jitter;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io

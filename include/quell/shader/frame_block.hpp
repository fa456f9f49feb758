#pragma once

#include <quell/frame/pixel_rays.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What differs from frame to frame, as shaders get it: a block of uniforms. `_then` means of the previous frame; in the first one it is
/// the same as of this frame.
struct FrameBlock {
    Extent size{};                ///< of the frame, in pixels
    std::int32_t frame_index = 0; ///< seed of random numbers: the frame's number
    Camera camera{},              ///< of this frame
        camera_then{};            ///< of the previous frame
    float shutter = 0.f,          ///< of this frame, as a part of the time between frames
        shutter_then = 0.f;       ///< of the previous frame
    /// Whether cameras are looked at: those of a pipeline that `needs_camera` must be invertible.
    bool needs_camera = false;

    static constexpr int words = 76; ///< 32-bit words of the block

    /// A member of the block, as std140 and WGSL lay it out.
    struct Member {
        std::string_view name, ///< in shaders
            type,              ///< mat4, vec4 or ivec4
            meaning;           ///< of its components
        int word;              ///< where it begins
    };
    /// All members, in order.
    static constexpr std::array<Member, 13> members{{
        {"clip_from_world", "mat4", "world space to clip space, without jitter, column by column", 0},
        {"clip_from_world_then", "mat4", "of the previous frame", 16},
        {"eye", "vec4", "position of the camera in world space; w: side of a pixel at depth 1", 32},
        {"forward", "vec4", "from the eye to the image's top left corner at depth 1", 36},
        {"right", "vec4", "from a pixel to the one on the right, at depth 1", 40},
        {"down", "vec4", "from a pixel to the one below, at depth 1", 44},
        {"eye_then", "vec4", "of the previous frame", 48},
        {"forward_then", "vec4", "of the previous frame", 52},
        {"right_then", "vec4", "of the previous frame", 56},
        {"down_then", "vec4", "of the previous frame", 60},
        {"jitter", "vec4", "x, y: of this frame, in pixels, y down; z, w: of the previous frame", 64},
        {"shutter", "vec4", "x: of this frame, as a part of the time between frames; y: of the previous frame", 68},
        {"size", "ivec4", "x, y: width and height in pixels; z: the frame's number", 72},
    }};
    /// @cond
    static constexpr int clip_word = 0, clip_then_word = 16, rays_word = 32, rays_then_word = 48, jitter_word = 64, jitter_then_word = 66,
                         shutter_word = 68, shutter_then_word = 69, width_word = 72, height_word = 73, index_word = 74;
    /// @endcond

    /// The block, as a host copies it to a device.
    [[nodiscard]] std::array<std::uint32_t, std::size_t{words}> as_words() const {
        std::array<std::uint32_t, std::size_t{words}> all{};
        auto const put = [&](int word, auto number) { all[static_cast<std::size_t>(word)] = std::bit_cast<std::uint32_t>(number); };
        auto const put_matrix = [&](int word, glm::mat4 const& m) {
            for (int i = 0; i < 16; ++i) put(word + i, m[i / 4][i % 4]);
        };
        auto const put_vector = [&](int word, glm::vec3 const& v) { put(word, v.x), put(word + 1, v.y), put(word + 2, v.z); };
        auto const put_rays = [&](int word, PixelRays const& r) {
            put_vector(word, r.eye), put(word + 3, r.pixel_size);
            put_vector(word + 4, r.forward), put_vector(word + 8, r.right), put_vector(word + 12, r.down);
        };
        put_matrix(clip_word, camera.clip_from_world()), put_matrix(clip_then_word, camera_then.clip_from_world());
        put_rays(rays_word, needs_camera ? PixelRays(camera, size) : PixelRays());
        put_rays(rays_then_word, needs_camera ? PixelRays(camera_then, size) : PixelRays());
        put(jitter_word, camera.jitter.x), put(jitter_word + 1, camera.jitter.y);
        put(jitter_then_word, camera_then.jitter.x), put(jitter_then_word + 1, camera_then.jitter.y);
        put(shutter_word, shutter), put(shutter_then_word, shutter_then);
        put(width_word, size.width), put(height_word, size.height), put(index_word, frame_index);
        return all;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

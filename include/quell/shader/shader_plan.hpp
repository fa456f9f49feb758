#pragma once

#include <quell/shader/frame_block.hpp>
#include <quell/shader/pass_graph.hpp>

#include <array>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A plane of one of a plan's buffers that a host fills or takes.
struct HostPlane {
    std::string channel; ///< its name
    int component = 0;   ///< of the channel, from 0
    int fraction = 1;    ///< its size = frame size / fraction, rounded up
};

/// A pass of a plan.
struct ShaderPass {
    PassGraph graph;                ///< of every frame after the first
    std::optional<PassGraph> first; ///< of a frame without a past, if it is another
};

/// What a pipeline does with a frame, as shaders: the passes in order, and where everything lies. Each of five buffers has a number of
/// slots, and each slot room for one float of each pixel of the frame: row by row, without padding. Component (x, y) of slot s lies at
/// s * width * height + y * w + x, where w is the width of the plane: (width + fraction - 1) / fraction.
struct ShaderPlan {
    std::string name;               ///< of the preset or pipeline
    std::vector<ShaderPass> passes; ///< in order
    std::vector<HostPlane> inputs,  ///< what the host fills, slot by slot
        output;                     ///< what it gets
    int history_slots = 0,          ///< of each of the two buffers of the history, which change places from frame to frame
        scratch_slots = 0;          ///< of the scratch
    bool needs_camera = false;      ///< whether FrameBlock's matrices and rays are looked at

    /// Slots of a buffer.
    [[nodiscard]] int slot_count(ShaderBuffer buffer) const {
        switch (buffer) {
        case ShaderBuffer::inputs:
            return static_cast<int>(inputs.size());
        case ShaderBuffer::output:
            return static_cast<int>(output.size());
        case ShaderBuffer::scratch:
            return scratch_slots;
        case ShaderBuffer::history_then:
        case ShaderBuffer::history_now:
            break;
        }
        return history_slots;
    }
};

/// Names of the buffers, in order; their bindings are their numbers + 1, behind the block of uniforms.
inline constexpr std::array<std::string_view, 5> shader_buffer_names{"inputs", "history_then", "history_now", "scratch", "picture"};
/// The name of a buffer in shaders.
constexpr std::string_view name_of(ShaderBuffer buffer) { return shader_buffer_names[static_cast<std::size_t>(buffer)]; }

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/shader/frame_block.hpp>
#include <quell/shader/pass_graph.hpp>

#include <array>
#include <optional>
#include <span>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A plane of one of a plan's buffers that a host fills or takes.
struct HostPlane {
    std::string channel; ///< its name
    int component = 0;   ///< of the channel, from 0
    int fraction = 1;    ///< its size = frame size / fraction, rounded up
};

/// What a plan counts: sums of squares of 64x64 pixels, which a host adds up. They lie in the buffer of the picture, in a slot behind it.
/// Number (x, y) of block b lies at slot * width * height + (b * h + y) * w + x, where w and h are width and height / 64, rounded up.
struct ShaderCount {
    std::string what, ///< missing samples; impossible guides: pixels with one or more; impossible albedo, ...; suppressed light
        signal;       ///< of which
    int slot = 0,     ///< of the buffer
        block = 0;    ///< in it
    /// Equal in every member.
    friend bool operator==(ShaderCount const&, ShaderCount const&) = default;
};

/// A pass of a plan.
struct ShaderPass {
    PassGraph graph;                ///< of every frame after the first
    std::optional<PassGraph> first; ///< of a frame without a past, if it is another
};

/// The side of the squares of ShaderCount.
inline constexpr int counted_square = 64;

/// Names of the buffers, in order.
inline constexpr std::array<std::string_view, 5> shader_buffer_names{"inputs", "history_then", "history_now", "scratch", "picture"};
/// The name of a buffer in shaders.
constexpr std::string_view name_of(ShaderBuffer buffer) { return shader_buffer_names[static_cast<std::size_t>(buffer)]; }

/// Whether a buffer is one of unsigned integers in shaders. What quell keeps for itself may be no number, and a device may flush or change
/// floats that it loads and stores.
constexpr bool holds_words(ShaderBuffer buffer) { return buffer != ShaderBuffer::inputs && buffer != ShaderBuffer::output; }

/// A buffer as it is bound: one of ShaderBuffer, or a part of one.
struct BoundBuffer {
    ShaderBuffer buffer = ShaderBuffer::inputs; ///< whose
    int part = 0,                               ///< from 0
        slot_count = 0;                         ///< how many it has
    /// Of the same name.
    [[nodiscard]] bool is(BoundBuffer const& other) const { return buffer == other.buffer && part == other.part; }
    /// In shaders: inputs, inputs_2, ...
    [[nodiscard]] std::string name() const {
        return std::string(name_of(buffer)) + (part > 0 ? "_" + std::to_string(part + 1) : std::string());
    }
    /// Whether no pass writes it.
    [[nodiscard]] bool is_read_only() const { return buffer == ShaderBuffer::inputs || buffer == ShaderBuffer::history_then; }
};
/// A place for a plane.
struct ShaderSlot {
    BoundBuffer buffer; ///< in which
    int number = 0;     ///< in this buffer
};

/// What a pipeline does with a frame, as shaders: the passes in order, and where everything lies. Each of five buffers has a number of
/// slots, and each slot room for one float of each pixel of the frame: row by row, without padding. Component (x, y) of slot s lies at
/// s * width * height + y * w + x, where w is the width of the plane: (width + fraction - 1) / fraction.
struct ShaderPlan {
    std::string name;                  ///< of the preset or pipeline
    std::vector<ShaderPass> passes;    ///< in order
    std::vector<HostPlane> inputs,     ///< what the host fills, slot by slot
        output;                        ///< what it gets
    std::vector<ShaderCount> counts{}; ///< what is counted, if that was asked for
    int history_slots = 0,             ///< of each of the two buffers of the history, which change places from frame to frame
        scratch_slots = 0;             ///< of the scratch
    bool needs_camera = false;         ///< whether FrameBlock's matrices and rays are looked at
    int most_slots = 0;                ///< of a buffer: what has more lies in several; 0: without a limit
    bool texel_loads = false;          ///< whether GLSL loads of views of the buffers
    Extent workgroup{8, 8};            ///< threads of one

    /// Slots of a buffer.
    [[nodiscard]] int slot_count(ShaderBuffer buffer) const {
        switch (buffer) {
        case ShaderBuffer::inputs:
            return static_cast<int>(inputs.size());
        case ShaderBuffer::output:
            return counts.empty() ? static_cast<int>(output.size()) : counts.back().slot + 1;
        case ShaderBuffer::scratch:
            return scratch_slots;
        case ShaderBuffer::history_then:
        case ShaderBuffer::history_now:
            break;
        }
        return history_slots;
    }
    /// Where a slot lies.
    [[nodiscard]] ShaderSlot slot(ShaderBuffer buffer, int number) const {
        return most_slots > 0 ? ShaderSlot{{buffer, number / most_slots}, number % most_slots} : ShaderSlot{{buffer, 0}, number};
    }
    /// All buffers that are bound, in order. Their bindings are their numbers + 1, behind the block of uniforms.
    [[nodiscard]] std::vector<BoundBuffer> bound_buffers() const {
        std::vector<BoundBuffer> all;
        for (std::size_t i = 0; i < shader_buffer_names.size(); ++i)
            for (int part = 0, rest = slot_count(static_cast<ShaderBuffer>(i)); part == 0 || rest > 0; ++part) {
                int const here = most_slots > 0 && rest > most_slots ? most_slots : rest;
                all.push_back({static_cast<ShaderBuffer>(i), part, here}), rest -= here;
            }
        return all;
    }
    /// Whether shaders load of a view of a buffer too, as of a buffer of texels. Its binding is that of the buffer, and the number of all
    /// buffers more.
    [[nodiscard]] bool has_view(BoundBuffer const& buffer) const { return texel_loads && buffer.buffer != ShaderBuffer::output; }
    /// The sum of a count over a frame.
    /// @param count one of `counts`
    /// @param size  of the frame
    /// @param slot  the floats of its slot
    [[nodiscard]] static double total(ShaderCount const& count, Extent size, std::span<float const> slot) {
        auto const squares = static_cast<std::size_t>(divided(size, counted_square).pixels());
        double sum = 0;
        for (float const square : slot.subspan(static_cast<std::size_t>(count.block) * squares, squares))
            sum += static_cast<double>(square);
        return sum;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/core/half.hpp>
#include <quell/shader/shader_plan.hpp>

#include <span>

/// @file
/// Runs a plan on the CPU, slowly: what shaders are tested against.

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A value of a node. Masks are integers 0 and 1.
union Word {
    std::int32_t integer;
    float real;
};

/// Evaluates the nodes of a pass, pixel by pixel.
class PassInterpreter {
    PassGraph const& graph;
    std::array<std::uint32_t, std::size_t{FrameBlock::words}> block;
    Extent size; ///< of the frame
    bool joins;  ///< whether products and sums are joined
    std::vector<std::span<float>> planes;
    std::vector<Word> values;
    int column = 0, row = 0;

public:
    PassInterpreter(PassGraph const& g, FrameBlock const& frame, bool joins_them, std::vector<std::span<float>> of_planes)
        : graph(g), block(frame.as_words()), size(frame.size), joins(joins_them), planes(std::move(of_planes)), values(g.nodes.size()) {}

    void run() {
        auto const extent = divided(size, graph.fraction);
        for (row = 0; row < extent.height; ++row)
            for (column = 0; column < extent.width; ++column)
                for (std::size_t i = 0; i < graph.nodes.size(); i = follower(i)) evaluate(graph.nodes[i], values[i]);
    }

private:
    /// The node behind a node.
    [[nodiscard]] std::size_t follower(std::size_t i) {
        auto const& node = graph.nodes[i];
        auto const goes_on = [&](std::size_t loop) { return values[loop].real < operand(graph.nodes[loop], 0).real; };
        if (node.operation == Operation::loop && !goes_on(i)) return i + node.payload + 1;
        if (node.operation == Operation::end_loop) {
            auto const loop = static_cast<std::size_t>(node.of[0]);
            values[loop].real += 1.f;
            if (goes_on(loop)) return loop + 1;
        }
        return i + 1;
    }
    [[nodiscard]] Word operand(Node const& node, std::size_t k) const { return values[static_cast<std::size_t>(node.of[k])]; }
    void evaluate(Node const& node, Word& to) {
        switch (node.type()) {
        case NodeType::real:
            to.real = real_of_node(node);
            break;
        case NodeType::integer:
            to.integer = integer_of_node(node);
            break;
        case NodeType::mask:
            to.integer = mask_of_node(node);
            break;
        case NodeType::none:
            if (node.operation == Operation::store) planes[node.payload][place(node, 1)] = operand(node, 0).real;
            if (node.operation == Operation::next) values[static_cast<std::size_t>(node.of[0])] = operand(node, 1);
            break;
        }
    }
    [[nodiscard]] std::size_t place(Node const& node, std::size_t k) const { return static_cast<std::size_t>(operand(node, k).integer); }
    [[nodiscard]] float real_of_node(Node const& node) const {
        float const a = operand(node, 0).real, b = operand(node, 1).real, c = operand(node, 2).real;
        using enum Operation;
        switch (node.operation) {
        case constant:
            return std::bit_cast<float>(node.payload);
        case uniform:
            return std::bit_cast<float>(block[node.payload]);
        case add:
            return a + b;
        case subtract:
            return a - b;
        case multiply:
            return a * b;
        case divide:
            return a / b;
        case negate:
            return -a;
        case minimum:
            return min(a, b);
        case maximum:
            return max(a, b);
        case absolute:
            return abs(a);
        case square_root:
            return quell::sqrt(a);
        case Operation::floor:
            return quell::floor(a);
        case fused:
            return joins ? quell::fma(a, b, c) : a * b + c;
        case Operation::select:
            return operand(node, 0).integer != 0 ? b : c;
        case Operation::to_real:
            return quell::to_real(operand(node, 0).integer);
        case load:
            return planes[node.payload][place(node, 0)];
        case round_to_half:
            return float_from_half(half_from_float(a));
        case lower_half:
            return float_from_half(static_cast<std::uint16_t>(operand(node, 0).integer));
        case upper_half:
            return float_from_half(static_cast<std::uint16_t>(static_cast<std::uint32_t>(operand(node, 0).integer) >> 16));
        case loop:
            return 0.f;
        default:
            return a; // bits; what is carried
        }
    }
    [[nodiscard]] std::int32_t integer_of_node(Node const& node) const {
        auto const a = operand(node, 0).integer, b = operand(node, 1).integer, c = operand(node, 2).integer;
        auto const i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b);
        auto const extent = divided(size, static_cast<int>(node.payload > 0 ? node.payload : 1));
        auto const wrapped = [](std::uint32_t all) { return static_cast<std::int32_t>(all); };
        using enum Operation;
        switch (node.operation) {
        case constant_integer:
            return wrapped(node.payload);
        case uniform_integer:
            return wrapped(block[node.payload]);
        case this_column:
            return column;
        case this_row:
            return row;
        case width:
            return extent.width;
        case height:
            return extent.height;
        case add_integer:
            return wrapped(i + j);
        case subtract_integer:
            return wrapped(i - j);
        case multiply_integer:
            return wrapped(i * j);
        case and_integer:
            return wrapped(i & j);
        case or_integer:
            return wrapped(i | j);
        case xor_integer:
            return wrapped(i ^ j);
        case shift_left:
            return wrapped(i << j);
        case shift_right:
            return a >> b;
        case clamp_integer:
            return a < b ? b : a > c ? c : a;
        case Operation::truncate:
            return quell::truncate(operand(node, 0).real);
        case select_integer:
            return a != 0 ? b : c;
        case pack_halves: {
            auto const upper = static_cast<std::uint32_t>(half_from_float(operand(node, 1).real)) << 16;
            return wrapped(upper | half_from_float(operand(node, 0).real));
        }
        default:
            return a; // bits
        }
    }
    [[nodiscard]] bool mask_of_node(Node const& node) const {
        float const a = operand(node, 0).real, b = operand(node, 1).real;
        auto const i = operand(node, 0).integer, j = operand(node, 1).integer;
        using enum Operation;
        switch (node.operation) {
        case constant_mask:
            return node.payload != 0;
        case less:
            return a < b;
        case less_equal:
            return a <= b;
        case greater:
            return a > b;
        case greater_equal:
            return a >= b;
        case equal:
            return a == b;
        case not_equal:
            return a != b;
        case less_integer:
            return i < j;
        case equal_integer:
            return i == j;
        case Operation::both:
            return (i & j) != 0;
        case Operation::either:
            return (i | j) != 0;
        case Operation::invert:
            return i == 0;
        case Operation::is_finite:
            return quell::is_finite(a);
        default:
            return quell::sign_bit(a);
        }
    }
};
} // namespace detail

/// Runs a plan's passes on the CPU, frame by frame, as a host runs its shaders. Slow: it is what shaders are tested against.
class PlanInterpreter {
    ShaderPlan const& plan;
    std::size_t pixels;
    std::array<std::vector<float>, shader_buffer_names.size()> buffers;
    bool has_past = false, joins;

public:
    /// @param of         must outlive it
    /// @param size       of the frames
    /// @param joins_them whether a product and the sum behind it are rounded as one, as Serial does and devices may
    PlanInterpreter(ShaderPlan const& of, Extent size, bool joins_them = true)
        : plan(of), pixels(static_cast<std::size_t>(size.pixels())), joins(joins_them) {
        for (std::size_t i = 0; i < buffers.size(); ++i)
            buffers[i].resize(pixels * static_cast<std::size_t>(plan.slot_count(static_cast<ShaderBuffer>(i))));
    }
    /// A slot of a buffer: a float for each pixel.
    [[nodiscard]] std::span<float> plane(ShaderBuffer buffer, int slot) {
        return std::span(buffers[static_cast<std::size_t>(buffer)]).subspan(static_cast<std::size_t>(slot) * pixels, pixels);
    }
    /// The next frame has no past: for cuts.
    void forget() { has_past = false; }
    /// Runs all passes over the inputs that are there now.
    void run(FrameBlock const& frame) {
        for (auto const& pass : plan.passes) {
            auto const& graph = pass.first && !has_past ? *pass.first : pass.graph;
            std::vector<std::span<float>> planes;
            for (auto const& each : graph.planes) planes.push_back(plane(each.buffer, each.slot));
            detail::PassInterpreter(graph, frame, joins, std::move(planes)).run();
        }
        std::swap(buffers[static_cast<std::size_t>(ShaderBuffer::history_then)],
                  buffers[static_cast<std::size_t>(ShaderBuffer::history_now)]);
        has_past = true;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

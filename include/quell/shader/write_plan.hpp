#pragma once

#include <quell/shader/write_shader.hpp>

#include <cctype>

/// @file
/// Writes a plan as JSON, and graphs for people.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The name of a pass's file, such as "06-temporal-first.wgsl".
inline std::string shader_file_name(ShaderPlan const& plan, std::size_t pass, bool is_first, std::string_view extension) {
    auto name = std::to_string(pass);
    if (name.size() < 2) name = "0" + name;
    name += "-";
    for (char const letter : plan.passes[pass].graph.name) name += std::isalnum(static_cast<unsigned char>(letter)) ? letter : '-';
    return name + (is_first ? "-first." : ".") + std::string(extension);
}

namespace detail {
inline std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }
/// "a, b, c" of what `each` makes of the members of a list.
inline std::string joined(auto const& list, std::string_view between, auto const& each) {
    std::string all;
    for (auto const& member : list) (all += all.empty() ? "" : between) += each(member);
    return all;
}
inline std::string slot_text(ShaderPlan const& plan, ShaderBuffer buffer, int number) {
    auto const slot = plan.slot(buffer, number);
    return "\"buffer\": " + in_quotes(slot.buffer.name()) + ", \"slot\": " + std::to_string(slot.number);
}
inline std::string host_planes(ShaderPlan const& plan, ShaderBuffer buffer, std::vector<HostPlane> const& planes) {
    int slot = 0;
    return joined(planes, ",\n    ", [&](HostPlane const& plane) {
        return "{\"channel\": " + in_quotes(plane.channel) + ", \"component\": " + std::to_string(plane.component) +
               ", \"fraction\": " + std::to_string(plane.fraction) + ", " + slot_text(plan, buffer, slot++) + "}";
    });
}
inline std::string counts_text(ShaderPlan const& plan) {
    if (plan.counts.empty()) return {};
    auto const count = [&](ShaderCount const& each) {
        return "{\"what\": " + in_quotes(each.what) + ", \"signal\": " + in_quotes(each.signal) +
               ", \"fraction\": " + std::to_string(counted_square) + ", " + slot_text(plan, ShaderBuffer::output, each.slot) +
               ", \"block\": " + std::to_string(each.block) + "}";
    };
    return "  \"counts\": [\n    " + joined(plan.counts, ",\n    ", count) + "],\n";
}
/// The buffers that a pass uses, in the first frame or later.
/// @param operation load or store; any for both
inline std::vector<BoundBuffer> buffers_of(ShaderPlan const& plan, ShaderPass const& pass, std::optional<Operation> operation = {}) {
    auto const uses = [&](PassGraph const& graph, BoundBuffer const& buffer) {
        return std::ranges::any_of(graph.nodes, [&](Node const& node) {
            if (node.operation != Operation::load && node.operation != Operation::store) return false;
            auto const& plane = graph.planes[node.payload];
            return (!operation || node.operation == *operation) && plan.slot(plane.buffer, plane.slot).buffer.is(buffer);
        });
    };
    std::vector<BoundBuffer> used;
    for (auto const& buffer : plan.bound_buffers())
        if (uses(pass.graph, buffer) || (pass.first && uses(*pass.first, buffer))) used.push_back(buffer);
    return used;
}
inline std::string buffer_names(std::vector<BoundBuffer> const& buffers) {
    return "[" + joined(buffers, ", ", [](BoundBuffer const& buffer) { return in_quotes(buffer.name()); }) + "]";
}
/// The binding of a block or buffer, and in HLSL also the register, in which constants, what is read and what is written count apart.
inline std::string binding_text(std::size_t binding, char kind, std::string_view extension) {
    auto const number = std::to_string(binding);
    return "\"binding\": " + number + (extension == "hlsl" ? ", \"register\": " + in_quotes(kind + number) : "");
}
inline std::string buffer_text(ShaderPlan const& plan, BoundBuffer const& buffer, std::size_t binding, std::string_view extension) {
    bool const then = buffer.buffer == ShaderBuffer::history_then, now = buffer.buffer == ShaderBuffer::history_now;
    auto other = buffer;
    other.buffer = then ? ShaderBuffer::history_now : ShaderBuffer::history_then;
    auto const view = std::to_string(binding + plan.bound_buffers().size());
    auto const format = in_quotes(holds_words(buffer.buffer) ? "R32_UINT" : "R32_SFLOAT");
    return "{\"name\": " + in_quotes(buffer.name()) + ", " + binding_text(binding, buffer.is_read_only() ? 't' : 'u', extension) +
           ", \"access\": " + in_quotes(buffer.is_read_only() ? "read" : "read_write") +
           ", \"slots\": " + std::to_string(buffer.slot_count) + (then || now ? ", \"becomes\": " + in_quotes(other.name()) : "") +
           (plan.has_view(buffer) ? ", \"view\": {\"binding\": " + view + ", \"format\": " + format + "}" : "") + "}";
}
} // namespace detail

/// A plan as JSON: all that a host must know to run its shaders. docs/shaders.md says what stands where.
/// @param plan      what to write
/// @param extension of the shaders' files
inline std::string to_json(ShaderPlan const& plan, std::string_view extension) {
    using namespace detail;
    auto const members = joined(FrameBlock::members, ",\n      ", [](FrameBlock::Member const& member) {
        return "{\"name\": " + in_quotes(member.name) + ", \"type\": " + in_quotes(member.type) +
               ", \"offset\": " + std::to_string(4 * member.word) + ", \"meaning\": " + in_quotes(member.meaning) + "}";
    });
    std::size_t binding = 1, number = 0, most = 0;
    auto const buffers =
        joined(plan.bound_buffers(), ",\n    ", [&](BoundBuffer const& buffer) { return buffer_text(plan, buffer, binding++, extension); });
    for (auto const& pass : plan.passes) most = std::max(most, buffers_of(plan, pass).size());
    auto const passes = joined(plan.passes, ",\n    ", [&](ShaderPass const& pass) {
        auto const n = number++;
        auto const first = pass.first ? ", \"first\": " + in_quotes(shader_file_name(plan, n, true, extension)) : std::string();
        return "{\"name\": " + in_quotes(pass.graph.name) + ", \"shader\": " + in_quotes(shader_file_name(plan, n, false, extension)) +
               first + ", \"fraction\": " + std::to_string(pass.graph.fraction) +
               ", \"reads\": " + buffer_names(buffers_of(plan, pass, Operation::load)) +
               ", \"writes\": " + buffer_names(buffers_of(plan, pass, Operation::store)) +
               ", \"steps\": " + std::to_string(pass.graph.nodes.size()) + "}";
    });
    // In Metal's language no function may be named `main`: spirv-cross writes `main0`.
    return "{\n  \"format\": 1,\n  \"name\": " + in_quotes(plan.name) +
           ",\n  \"entry_point\": " + in_quotes(extension == "metal" ? "main0" : "main") + ",\n" + "  \"workgroup\": [" +
           std::to_string(plan.workgroup.width) + ", " + std::to_string(plan.workgroup.height) +
           "],\n  \"needs_camera\": " + (plan.needs_camera ? "true" : "false") + ",\n" + "  \"uniforms\": {\"name\": \"frame\", " +
           binding_text(0, 'b', extension) + ", \"bytes\": " + std::to_string(4 * FrameBlock::words) + ", \"members\": [\n      " +
           members + "]},\n  \"buffers_of_a_pass\": " + std::to_string(most) + ",\n  \"buffers\": [\n    " + buffers +
           "],\n  \"inputs\": [\n    " + host_planes(plan, ShaderBuffer::inputs, plan.inputs) + "],\n  \"picture\": [\n    " +
           host_planes(plan, ShaderBuffer::output, plan.output) + "],\n" + counts_text(plan) + "  \"passes\": [\n    " + passes + "]\n}\n";
}

/// A shader as a file.
struct ShaderFile {
    std::string name; ///< as to_json() says it
    std::string text; ///< what is in it
};
/// All shaders of a plan.
/// @param plan      what to write
/// @param language  of the texts
/// @param extension of the files
inline std::vector<ShaderFile> shader_files(ShaderPlan const& plan, ShaderLanguage language, std::string_view extension) {
    std::vector<ShaderFile> files;
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        for (bool const is_first : {false, true})
            if (!is_first || plan.passes[pass].first)
                files.push_back({shader_file_name(plan, pass, is_first, extension), shader_text(plan, pass, is_first, language)});
    return files;
}

/// A recorded pass for people: a line for each step.
inline std::string to_string(PassGraph const& graph) {
    std::string text = graph.name + ": " + std::to_string(graph.nodes.size()) + " steps, " + std::to_string(graph.planes.size()) +
                       " planes" + (graph.fraction > 1 ? ", at 1/" + std::to_string(graph.fraction) + " of the size" : "") + "\n";
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        auto const& node = graph.nodes[i];
        text += "  " + std::to_string(i) + " = " + std::string(info_of(node.operation).name);
        for (int k = 0; k < node.operands(); ++k) text += " " + std::to_string(node.of[static_cast<std::size_t>(k)]);
        char number[32];
        switch (node.operation) {
        case Operation::constant:
            std::snprintf(number, sizeof number, " %g", static_cast<double>(std::bit_cast<float>(node.payload)));
            text += number;
            break;
        case Operation::load:
        case Operation::store: {
            auto const& plane = graph.planes[node.payload];
            text += " " + std::string(name_of(plane.buffer)) + " " + std::to_string(plane.slot) + ": " + plane.label();
            break;
        }
        case Operation::uniform:
        case Operation::uniform_integer:
            text += " word " + std::to_string(node.payload);
            break;
        default:
            if (node.is_constant()) text += " " + std::to_string(static_cast<std::int32_t>(node.payload));
        }
        text += "\n";
    }
    return text;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

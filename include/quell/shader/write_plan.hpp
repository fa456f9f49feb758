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
inline std::string host_planes(std::vector<HostPlane> const& planes) {
    int slot = 0;
    return joined(planes, ",\n    ", [&](HostPlane const& plane) {
        return "{\"channel\": " + in_quotes(plane.channel) + ", \"component\": " + std::to_string(plane.component) +
               ", \"fraction\": " + std::to_string(plane.fraction) + ", \"slot\": " + std::to_string(slot++) + "}";
    });
}
/// Names of the buffers that a pass loads from, or stores to.
inline std::string buffers_of(PassGraph const& graph, Operation operation) {
    std::array<bool, shader_buffer_names.size()> used{};
    for (auto const& node : graph.nodes)
        if (node.operation == operation) used[static_cast<std::size_t>(graph.planes[node.payload].buffer)] = true;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) names.push_back(shader_buffer_names[i]);
    return "[" + joined(names, ", ", in_quotes) + "]";
}
/// The binding of a block or buffer, and in HLSL also the register, in which constants, what is read and what is written count apart.
inline std::string binding_text(std::size_t binding, char kind, std::string_view extension) {
    auto const number = std::to_string(binding);
    return "\"binding\": " + number + (extension == "hlsl" ? ", \"register\": " + in_quotes(kind + number) : "");
}
inline std::string buffer_text(ShaderPlan const& plan, std::size_t number, std::string_view extension) {
    auto const buffer = static_cast<ShaderBuffer>(number);
    bool const then = buffer == ShaderBuffer::history_then, now = buffer == ShaderBuffer::history_now;
    return "{\"name\": " + in_quotes(name_of(buffer)) + ", " + binding_text(number + 1, number < 2 ? 't' : 'u', extension) +
           ", \"access\": " + in_quotes(number < 2 ? "read" : "read_write") + ", \"slots\": " + std::to_string(plan.slot_count(buffer)) +
           (then || now ? ", \"becomes\": " + in_quotes(name_of(then ? ShaderBuffer::history_now : ShaderBuffer::history_then)) : "") + "}";
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
    std::size_t buffer = 0, number = 0;
    auto const buffers = joined(shader_buffer_names, ",\n    ", [&](std::string_view) { return buffer_text(plan, buffer++, extension); });
    auto const passes = joined(plan.passes, ",\n    ", [&](ShaderPass const& pass) {
        auto const n = number++;
        auto const first = pass.first ? ", \"first\": " + in_quotes(shader_file_name(plan, n, true, extension)) : std::string();
        return "{\"name\": " + in_quotes(pass.graph.name) + ", \"shader\": " + in_quotes(shader_file_name(plan, n, false, extension)) +
               first + ", \"fraction\": " + std::to_string(pass.graph.fraction) +
               ", \"reads\": " + buffers_of(pass.graph, Operation::load) + ", \"writes\": " + buffers_of(pass.graph, Operation::store) +
               ", \"steps\": " + std::to_string(pass.graph.nodes.size()) + "}";
    });
    auto const side = std::to_string(shader_workgroup);
    // In Metal's language no function may be named `main`: spirv-cross writes `main0`.
    return "{\n  \"format\": 1,\n  \"name\": " + in_quotes(plan.name) +
           ",\n  \"entry_point\": " + in_quotes(extension == "metal" ? "main0" : "main") + ",\n" + "  \"workgroup\": [" + side + ", " +
           side + "],\n  \"needs_camera\": " + (plan.needs_camera ? "true" : "false") + ",\n" + "  \"uniforms\": {\"name\": \"frame\", " +
           binding_text(0, 'b', extension) + ", \"bytes\": " + std::to_string(4 * FrameBlock::words) + ", \"members\": [\n      " +
           members + "]},\n  \"buffers\": [\n    " + buffers + "],\n  \"inputs\": [\n    " + host_planes(plan.inputs) +
           "],\n  \"picture\": [\n    " + host_planes(plan.output) + "],\n  \"passes\": [\n    " + passes + "]\n}\n";
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
            text += " " + std::string(name_of(plane.buffer)) + " " + std::to_string(plane.slot) + ": " + plane.channel + "[" +
                    std::to_string(plane.component) + "]";
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

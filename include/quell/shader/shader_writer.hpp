#pragma once

#include <quell/shader/shader_plan.hpp>

#include <algorithm>
#include <cstdio>

/// @file
/// What writes a recorded pass as a compute shader.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What a shader is written in.
enum class ShaderLanguage : std::uint8_t {
    wgsl, ///< WebGPU
    glsl  ///< GLSL 4.5 for Vulkan, from which glslangValidator makes SPIR-V
};

namespace detail {
inline std::string number_text(int a) { return std::to_string(a); }

/// Writes one pass.
class ShaderWriter {
    ShaderPlan const& plan;
    PassGraph const& graph;
    bool wgsl;
    std::vector<std::string> text; ///< of each node: its name, or itself where it is short
    std::vector<char> is_word;     ///< of each node: whether it is a load whose bits are taken or stored, as of a packed normal
    std::vector<char> is_stored;   ///< of each plane: whether the pass writes it
    std::string code{}, indent = "    ";

public:
    ShaderWriter(ShaderPlan const& p, PassGraph const& g, ShaderLanguage language)
        : plan(p), graph(g), wgsl(language == ShaderLanguage::wgsl), text(g.nodes.size()), is_word(g.nodes.size()),
          is_stored(g.planes.size()) {
        for (auto const& node : graph.nodes)
            if (node.operation == Operation::store)
                for (std::size_t i = 0; i < graph.planes.size(); ++i)
                    if (lies_with(graph.planes[i], graph.planes[node.payload])) is_stored[i] = true;
        auto const of_words = [&](Node const& node) { return holds_words(graph.planes[node.payload].buffer); };
        for (auto const& node : graph.nodes) {
            auto const of = static_cast<std::size_t>(node.of[0]);
            bool const takes_bits =
                node.operation == Operation::to_bits || node.operation == Operation::lower_half || node.operation == Operation::upper_half;
            if (!takes_bits && !(node.operation == Operation::store && of_words(node))) continue;
            if (graph.nodes[of].operation == Operation::load && of_words(graph.nodes[of])) is_word[of] = true;
        }
    }

    [[nodiscard]] std::string written() {
        code += wgsl ? head_of_wgsl() : head_of_glsl();
        auto const limit = [&](std::string const& axis) { return length(axis, graph.fraction); };
        line(wgsl ? "let x = i32(id.x);" : "int x = int(gl_GlobalInvocationID.x);");
        line(wgsl ? "let y = i32(id.y);" : "int y = int(gl_GlobalInvocationID.y);");
        line("if (x >= " + limit("x") + " || y >= " + limit("y") + ") { return; }");
        line(std::string(wgsl ? "let" : "int") + " pixels = frame.size.x * frame.size.y;");
        for (std::size_t i = 0; i < graph.nodes.size(); ++i) write(graph.nodes[i], i);
        return code + "}\n";
    }

private:
    static bool lies_with(GraphPlane const& a, GraphPlane const& b) { return a.buffer == b.buffer && a.slot == b.slot; }
    void line(std::string const& statement) { code += indent + statement + "\n"; }
    static std::string length(std::string const& axis, int fraction) {
        auto const whole = "frame.size." + axis;
        return fraction == 1 ? whole : "(" + whole + " + " + number_text(fraction - 1) + ") / " + number_text(fraction);
    }
    [[nodiscard]] bool packs_halves() const {
        return std::ranges::any_of(graph.nodes, [](Node const& node) { return node.operation == Operation::pack_halves; });
    }
    [[nodiscard]] std::string head_of_wgsl() const {
        std::string head = "struct Frame {\n";
        for (auto const& each : FrameBlock::members)
            head += "    " + std::string(each.name) + ": " +
                    (each.type == "mat4"   ? "mat4x4<f32>"
                     : each.type == "vec4" ? "vec4<f32>"
                                           : "vec4<i32>") +
                    ",\n";
        head += "}\n@group(0) @binding(0) var<uniform> frame: Frame;\n";
        for_each_buffer([&](BoundBuffer const& buffer, int number) {
            head += "@group(0) @binding(" + number_text(number) + ") var<storage, " + (buffer.is_read_only() ? "read" : "read_write") +
                    "> " + buffer.name() + ": array<" + (holds_words(buffer.buffer) ? "u32" : "f32") + ">;\n";
        });
        return head +
               "fn finite(a: f32) -> bool { return (bitcast<i32>(a) & 0x7fffffff) < 0x7f800000; }\n"
               "fn truncated(a: f32) -> i32 { return select(-2147483647 - 1, i32(a), abs(a) < 2147483648.0); }\n"
               "fn rounded_to_half(a: f32) -> f32 { return unpack2x16float(pack2x16float(vec2<f32>(clamp(a, -65504.0, 65504.0), "
               "0.0))).x; }\n"
               "fn of_bits(a: i32) -> f32 { return bitcast<f32>(a); }\n" +
               (packs_halves() ? "fn packed_halves(a: f32, b: f32) -> i32 { return bitcast<i32>(pack2x16float(clamp(vec2<f32>(a, b), "
                                 "vec2<f32>(-65504.0), vec2<f32>(65504.0)))); }\n"
                               : "") +
               "@compute @workgroup_size(" + number_text(plan.workgroup.width) + ", " + number_text(plan.workgroup.height) +
               ") fn main(@builtin(global_invocation_id) id: vec3<u32>) {\n";
    }
    [[nodiscard]] std::string head_of_glsl() const {
        std::string head = "#version 450\nlayout(local_size_x = " + number_text(plan.workgroup.width) +
                           ", local_size_y = " + number_text(plan.workgroup.height) + ") in;\n";
        head += "layout(std140, set = 0, binding = 0) uniform Frame {\n";
        for (auto const& each : FrameBlock::members) head += "    " + std::string(each.type) + " " + std::string(each.name) + ";\n";
        head += "} frame;\n";
        auto const buffer_count = static_cast<int>(plan.bound_buffers().size());
        for_each_buffer([&](BoundBuffer const& buffer, int number) {
            auto const binding = number_text(number);
            head += "layout(std430, set = 0, binding = " + binding + ") " + (buffer.is_read_only() ? "readonly " : "") + "buffer Buffer" +
                    binding + (holds_words(buffer.buffer) ? " { uint " : " { float ") + buffer.name() + "[]; };\n";
            if (plan.has_view(buffer))
                head += "layout(set = 0, binding = " + number_text(number + buffer_count) +
                        (holds_words(buffer.buffer) ? ") uniform usamplerBuffer " : ") uniform samplerBuffer ") + view_name(buffer) + ";\n";
        });
        return head +
               "bool finite(float a) { return (floatBitsToInt(a) & 0x7fffffff) < 0x7f800000; }\n"
               "int truncated(float a) { return abs(a) < 2147483648.0 ? int(a) : -2147483647 - 1; }\n"
               "float rounded_to_half(float a) { return unpackHalf2x16(packHalf2x16(vec2(clamp(a, -65504.0, 65504.0), 0.0))).x; }\n"
               "float of_bits(int a) { return intBitsToFloat(a); }\n" +
               (packs_halves() ? "int packed_halves(float a, float b) { return int(packHalf2x16(clamp(vec2(a, b), -65504.0, 65504.0))); }\n"
                               : "") +
               "void main() {\n";
    }

    /// Calls visit(buffer, its binding) for the buffers of the plan. Where they are in parts, for those alone that the pass uses: devices
    /// bind few at once.
    void for_each_buffer(auto const& visit) const {
        int binding = 1;
        for (auto const& buffer : plan.bound_buffers()) {
            if (plan.most_slots == 0 || std::ranges::any_of(graph.planes, [&](GraphPlane const& plane) {
                    return plan.slot(plane.buffer, plane.slot).buffer.is(buffer);
                }))
                visit(buffer, binding);
            ++binding;
        }
    }
    [[nodiscard]] std::string element(Node const& node, std::string const& place) const {
        auto const& plane = graph.planes[node.payload];
        auto const slot = plan.slot(plane.buffer, plane.slot);
        return slot.buffer.name() + "[" + number_text(slot.number) + " * pixels + " + place + "]";
    }
    static std::string view_name(BoundBuffer const& buffer) { return buffer.name() + "_texels"; }
    /// What a load takes: a float or a word. Of a view only what the pass does not write: what it has written need not be seen there.
    [[nodiscard]] std::string taken(Node const& node, std::string const& place) const {
        auto const& plane = graph.planes[node.payload];
        auto const slot = plan.slot(plane.buffer, plane.slot);
        if (wgsl || !plan.has_view(slot.buffer) || is_stored[node.payload]) return element(node, place);
        return "texelFetch(" + view_name(slot.buffer) + ", " + number_text(slot.number) + " * pixels + " + place + ").x";
    }
    /// What is stored of a value: its bits where the buffer is one of words.
    [[nodiscard]] std::string stored(Node const& node) const {
        auto const number = static_cast<std::size_t>(node.of[0]);
        if (!holds_words(graph.planes[node.payload].buffer)) return text[number];
        if (is_word[number]) return word_name(number);
        auto const& value = graph.nodes[number];
        if (value.operation == Operation::from_bits) return (wgsl ? "u32(" : "uint(") + text[static_cast<std::size_t>(value.of[0])] + ")";
        return (wgsl ? "bitcast<u32>(" : "floatBitsToUint(") + text[number] + ")";
    }
    [[nodiscard]] static std::string word_name(std::size_t number) { return "w" + std::to_string(number); }
    [[nodiscard]] std::string loaded(Node const& node) const {
        auto const at = taken(node, text[static_cast<std::size_t>(node.of[0])]);
        return holds_words(graph.planes[node.payload].buffer) ? float_of_word(at) : at;
    }
    [[nodiscard]] std::string float_of_word(std::string const& word) const {
        return (wgsl ? "bitcast<f32>(" : "uintBitsToFloat(") + word + ")";
    }
    [[nodiscard]] std::string channel(Node const& node) const { return graph.planes[node.payload].label(); }
    void write(Node const& node, std::size_t number) {
        auto const& a = text[static_cast<std::size_t>(node.of[0])];
        if (node.operation == Operation::store) {
            auto const& place = text[static_cast<std::size_t>(node.of[1])];
            return line(element(node, place) + " = " + stored(node) + "; // " + channel(node));
        }
        if (auto const leaf = short_text(node); !leaf.empty()) {
            text[number] = leaf;
            return;
        }
        if (is_word[number]) {
            line((wgsl ? "let " : "uint ") + word_name(number) + " = " + taken(node, a) + "; // " + channel(node));
            text[number] = float_of_word(word_name(number));
            return;
        }
        auto const name = "v" + std::to_string(number);
        if (node.operation == Operation::next) return line(a + " = " + text[static_cast<std::size_t>(node.of[1])] + ";");
        if (node.operation == Operation::end_loop) return end_loop();
        if (node.operation == Operation::loop) return text[number] = name, begin_loop(name, a);
        auto const type = node.type();
        auto const constant = node.operation == Operation::carried ? "var " : "let ";
        auto const declared = wgsl ? constant : type == NodeType::real ? "precise float " : type == NodeType::integer ? "int " : "bool ";
        line(declared + name + " = " + expression(node) + ";" + (node.operation == Operation::load ? " // " + channel(node) : ""));
        text[number] = name;
    }
    void begin_loop(std::string const& turn, std::string const& count) {
        line(std::string(wgsl ? "for (var " : "for (float ") + turn + " = 0.0; " + turn + " < " + count + "; " + turn + " += 1.0) {");
        indent.append(4, ' ');
    }
    void end_loop() {
        indent.erase(0, 4);
        line("}");
    }
    /// What is written where it is used; empty for what gets a name.
    [[nodiscard]] std::string short_text(Node const& node) const {
        switch (node.operation) {
        case Operation::constant:
            return real_text(node.payload);
        case Operation::constant_integer:
            return integer_text(static_cast<std::int32_t>(node.payload));
        case Operation::constant_mask:
            return node.payload != 0 ? "true" : "false";
        case Operation::uniform:
        case Operation::uniform_integer:
            return member_text(static_cast<int>(node.payload));
        case Operation::this_column:
            return "x";
        case Operation::this_row:
            return "y";
        case Operation::width:
            return node.payload == 1 ? length("x", 1) : std::string();
        case Operation::height:
            return node.payload == 1 ? length("y", 1) : std::string();
        default:
            return {};
        }
    }
    [[nodiscard]] std::string real_text(std::uint32_t bits) const {
        auto const number = std::bit_cast<float>(bits);
        // As a constant, WGSL takes neither infinity nor NaN.
        if (!quell::is_finite(number)) return "of_bits(" + integer_text(static_cast<std::int32_t>(bits)) + ")";
        char digits[32];
        // Rounded to nine digits, the largest float would be too large for one.
        std::snprintf(digits, sizeof digits, abs(number) > 3e38f ? "%.17g" : "%.9g", static_cast<double>(number));
        std::string text_of = digits;
        std::replace(text_of.begin(), text_of.end(), ',', '.'); // where the host's language has commas
        if (text_of.find_first_of(".e") == std::string::npos) text_of += ".0";
        return text_of[0] == '-' ? "(" + text_of + ")" : text_of;
    }
    [[nodiscard]] static std::string integer_text(std::int32_t a) {
        if (a == std::numeric_limits<std::int32_t>::min()) return "(-2147483647 - 1)";
        return a < 0 ? "(" + std::to_string(a) + ")" : std::to_string(a);
    }
    [[nodiscard]] static std::string member_text(int word) {
        auto member = FrameBlock::members.begin();
        while (member + 1 != FrameBlock::members.end() && (member + 1)->word <= word) ++member;
        int const at = word - member->word;
        auto const column = member->type == "mat4" ? "[" + number_text(at / 4) + "]" : std::string();
        return "frame." + std::string(member->name) + column + "." + "xyzw"[at % 4];
    }
    [[nodiscard]] std::string expression(Node const& node) const; // shader_expression.hpp
};

} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

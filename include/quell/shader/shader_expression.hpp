#pragma once

#include <quell/shader/shader_writer.hpp>

/// @file
/// What a step of a recorded pass is in the languages of shaders.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline std::string ShaderWriter::expression(Node const& node) const {
    auto const operand = [&](std::size_t k) -> std::string const& { return text[static_cast<std::size_t>(node.of[k])]; };
    auto const &a = operand(0), &b = operand(1), &c = operand(2);
    auto const infix = [&](char const* sign) { return a + " " + sign + " " + b; };
    auto const call = [&](char const* function) { return function + ("(" + a + ")"); };
    auto const choose = [&](std::string const& mask, std::string const& one, std::string const& other) {
        return wgsl ? "select(" + other + ", " + one + ", " + mask + ")" : mask + " ? " + one + " : " + other;
    };
    auto const shift = [&](char const* sign) { return a + " " + sign + (wgsl ? " u32(" + b + ")" : " " + b); };
    using enum Operation;
    switch (node.operation) {
    case add:
    case add_integer:
        return infix("+");
    case subtract:
    case subtract_integer:
        return infix("-");
    case multiply:
    case multiply_integer:
        return infix("*");
    case divide:
        return infix("/");
    case negate:
        return "-" + a;
    case minimum:
        return choose(a + " < " + b, a, b); // b where either is NaN
    case maximum:
        return choose(a + " > " + b, a, b);
    case absolute:
        return call("abs");
    case square_root:
        return call("sqrt");
    case Operation::floor:
        return call("floor");
    case fused:
        return "fma(" + a + ", " + b + ", " + c + ")";
    case Operation::select:
    case select_integer:
        return choose(a, b, c);
    case Operation::to_real:
        return call(wgsl ? "f32" : "float");
    case Operation::from_bits:
        return call("of_bits");
    case to_bits:
        if (auto const of = static_cast<std::size_t>(node.of[0]); is_word[of]) return (wgsl ? "i32(" : "int(") + word_name(of) + ")";
        return call(wgsl ? "bitcast<i32>" : "floatBitsToInt");
    case load:
        return loaded(node);
    case carried:
    case current:
        return a;
    case round_to_half:
        return call("rounded_to_half");
    case lower_half:
    case upper_half:
        return (wgsl ? "unpack2x16float(" : "unpackHalf2x16(") + word_name(static_cast<std::size_t>(node.of[0])) +
               (node.operation == lower_half ? ").x" : ").y");
    case pack_halves:
        return "packed_halves(" + a + ", " + b + ")";
    case width:
        return length("x", static_cast<int>(node.payload));
    case height:
        return length("y", static_cast<int>(node.payload));
    case and_integer:
        return infix("&");
    case or_integer:
        return infix("|");
    case xor_integer:
        return infix("^");
    case shift_left:
        return shift("<<");
    case shift_right:
        return shift(">>");
    case clamp_integer:
        return "clamp(" + a + ", " + b + ", " + c + ")";
    case Operation::truncate:
        return call("truncated");
    case less:
    case less_integer:
        return infix("<");
    case less_equal:
        return infix("<=");
    case greater:
        return infix(">");
    case greater_equal:
        return infix(">=");
    case equal:
    case equal_integer:
        return infix("==");
    case not_equal:
        return infix("!=");
    case Operation::both:
        return infix("&&");
    case Operation::either:
        return infix("||");
    case Operation::invert:
        return "!" + a;
    case Operation::is_finite:
        return call("finite");
    case Operation::sign_bit:
        return (wgsl ? "bitcast<i32>(" : "floatBitsToInt(") + a + ") < 0";
    default:
        return {}; // written in short
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

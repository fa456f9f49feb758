#pragma once

#include <quell/core/instruction_set.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What a node of a recorded pass is.
enum class NodeType : std::uint8_t {
    real,    ///< a 32-bit float
    integer, ///< a 32-bit integer that wraps
    mask,    ///< a truth value
    none     ///< what has no value: a store, or the steps that end a turn of a loop
};

/// What a node of a recorded pass does. A loop is the nodes from `loop` to `end_loop`. What its turns hand on are variables: before it
/// `carried` gives each its first value, in it `current` takes the value of this turn, `next` sets that of the next one, and `current`
/// behind it takes the last. Halves are 16-bit floats, of which a word has two.
enum class Operation : std::uint8_t {
    // clang-format off
    constant, uniform, add, subtract, multiply, divide, negate, minimum, maximum, absolute, square_root, floor, fused, select, to_real, from_bits, load, round_to_half, lower_half, upper_half, carried, loop, current,
    constant_integer, uniform_integer, this_column, this_row, width, height, add_integer, subtract_integer, multiply_integer, and_integer, or_integer, xor_integer, shift_left, shift_right, clamp_integer, truncate, to_bits, select_integer, pack_halves,
    constant_mask, less, less_equal, greater, greater_equal, equal, not_equal, less_integer, equal_integer, both, either, invert, is_finite, sign_bit,
    store, next, end_loop
    // clang-format on
};

/// What is to be known of an Operation.
struct OperationInfo {
    std::string_view name; ///< for people
    NodeType type;         ///< of its value
    int operands;          ///< how many nodes it takes
};
/// One for each Operation, in their order.
inline constexpr OperationInfo operation_infos[] = {
    {"constant", NodeType::real, 0},
    {"uniform", NodeType::real, 0},
    {"add", NodeType::real, 2},
    {"subtract", NodeType::real, 2},
    {"multiply", NodeType::real, 2},
    {"divide", NodeType::real, 2},
    {"negate", NodeType::real, 1},
    {"minimum", NodeType::real, 2},
    {"maximum", NodeType::real, 2},
    {"absolute", NodeType::real, 1},
    {"square root", NodeType::real, 1},
    {"floor", NodeType::real, 1},
    {"fused", NodeType::real, 3},
    {"select", NodeType::real, 3},
    {"to real", NodeType::real, 1},
    {"from bits", NodeType::real, 1},
    {"load", NodeType::real, 1},
    {"round to half", NodeType::real, 1},
    {"lower half", NodeType::real, 1},
    {"upper half", NodeType::real, 1},
    {"carried", NodeType::real, 1},
    {"loop", NodeType::real, 1},
    {"current", NodeType::real, 2},
    {"constant integer", NodeType::integer, 0},
    {"uniform integer", NodeType::integer, 0},
    {"column", NodeType::integer, 0},
    {"row", NodeType::integer, 0},
    {"width", NodeType::integer, 0},
    {"height", NodeType::integer, 0},
    {"add integer", NodeType::integer, 2},
    {"subtract integer", NodeType::integer, 2},
    {"multiply integer", NodeType::integer, 2},
    {"and integer", NodeType::integer, 2},
    {"or integer", NodeType::integer, 2},
    {"xor integer", NodeType::integer, 2},
    {"shift left", NodeType::integer, 2},
    {"shift right", NodeType::integer, 2},
    {"clamp integer", NodeType::integer, 3},
    {"truncate", NodeType::integer, 1},
    {"to bits", NodeType::integer, 1},
    {"select integer", NodeType::integer, 3},
    {"pack halves", NodeType::integer, 2},
    {"constant mask", NodeType::mask, 0},
    {"less", NodeType::mask, 2},
    {"less equal", NodeType::mask, 2},
    {"greater", NodeType::mask, 2},
    {"greater equal", NodeType::mask, 2},
    {"equal", NodeType::mask, 2},
    {"not equal", NodeType::mask, 2},
    {"less integer", NodeType::mask, 2},
    {"equal integer", NodeType::mask, 2},
    {"both", NodeType::mask, 2},
    {"either", NodeType::mask, 2},
    {"invert", NodeType::mask, 1},
    {"is finite", NodeType::mask, 1},
    {"sign bit", NodeType::mask, 1},
    {"store", NodeType::none, 2},
    {"next", NodeType::none, 3},
    {"end loop", NodeType::none, 1},
};
static_assert(std::size(operation_infos) == static_cast<std::size_t>(Operation::end_loop) + 1);

/// What is to be known of an Operation.
constexpr OperationInfo const& info_of(Operation operation) { return operation_infos[static_cast<std::size_t>(operation)]; }

/// One step of a recorded pass. The steps before it, of which it takes values, go by their numbers.
struct Node {
    Operation operation; ///< what it does
    /// The nodes that it takes. Of a load: the place; of a store: the value and the place. Of a loop, whose value is the turn's number from
    /// 0: the number of turns. Of `current`: what is carried, and the loop; of `next`: also the value between them.
    std::array<std::int32_t, 3> of{};
    /// Bits of a constant; the word of FrameBlock of a uniform; the fraction of a width or height; the plane of a load or store; how many
    /// nodes a loop has, with its end; of `current` 0 in the loop and 1 behind it.
    std::uint32_t payload = 0;

    /// Equal in all three.
    friend bool operator==(Node const&, Node const&) = default;
    /// How many nodes it takes.
    [[nodiscard]] int operands() const { return info_of(operation).operands; }
    /// The type of its value.
    [[nodiscard]] NodeType type() const { return info_of(operation).type; }
    /// Whether it is a constant of any type.
    [[nodiscard]] bool is_constant() const {
        return operation == Operation::constant || operation == Operation::constant_integer || operation == Operation::constant_mask;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/core/for_each_turn.hpp>
#include <quell/shader/recorded.hpp>

#include <array>
#include <cstring>

/// @file
/// Loops of a recorded kernel.

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Replaces each number of a value by f(number).
template <class State, class F> void replace_each(State& state, F&& f) {
    static_assert(std::is_trivially_copyable_v<State> && sizeof(State) % sizeof(Recorded) == 0,
                  "for_each_turn(count, body, state...): what turns hand on is a Real, or a struct of nothing but Reals");
    std::array<Recorded, sizeof(State) / sizeof(Recorded)> numbers;
    std::memcpy(numbers.data(), &state, sizeof state);
    for (auto& number : numbers) number = f(number);
    std::memcpy(static_cast<void*>(&state), numbers.data(), sizeof state);
}
} // namespace detail

/// @cond
template <std::same_as<Recorded> Real, class Body, class... State> void for_each_turn(Real count, Body&& body, State&... state) {
    using namespace detail;
    std::vector<std::int32_t> carried;
    auto const replace_all = [&](auto const& f) { (replace_each(state, f), ...); };
    replace_all([&](Recorded number) {
        if (node_at(number.node).type() != NodeType::real)
            raise_error<Failure>("recorded loop", "its turns hand on what is no Real", "give for_each_turn(count, body, state...) Reals");
        return carried.push_back(graph_builder->carry(number.node)), number;
    });
    Recorded turn;
    turn.node = graph_builder->begin_loop(count.node);
    std::size_t which = 0;
    auto const current = [&](std::uint32_t behind) {
        Recorded number;
        number.node = graph_builder->add({Operation::current, {carried[which++], turn.node}, behind});
        return number;
    };
    replace_all([&](Recorded) { return current(0); });
    body(turn);
    which = 0;
    replace_all([&](Recorded number) {
        graph_builder->add({Operation::next, {carried[which++], number.node, turn.node}});
        return number;
    });
    graph_builder->end_loop();
    which = 0;
    replace_all([&](Recorded) { return current(1); });
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

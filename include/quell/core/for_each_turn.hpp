#pragma once

#include <quell/core/real.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A loop whose length a pixel decides. Recorded, it is a loop of a shader. Calls body(turn) with turn = 0, 1, ... as long as any lane
/// wants it: a lane that wants no more must change nothing, so mask what it does by turn < count.
/// @param count of turns: the whole number that is not less
/// @param body  takes the turn's number, a Real
/// @param state all that one turn hands on to the next, or to what follows the loop: each is a Real, or a struct of nothing but Reals
template <class Real, class Body, class... State>
QUELL_KERNEL void for_each_turn(Real count, Body&& body, [[maybe_unused]] State&... state) {
    for (Real turn(0.f); any(turn < count); turn = turn + 1.f) body(turn);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

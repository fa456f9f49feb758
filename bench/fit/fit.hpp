#pragma once

#include "header.hpp"
#include "survey.hpp"

#include <ostream>
#include <stdexcept>

namespace quell::bench {

/// No composition keeps to the bounds; the message names the best one.
struct OutOfReach : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What was found, run once more as a whole.
struct Fitted {
    std::list<Trial> trials;
    Composition composition; ///< of these trials
    Origin origin;
};

/// Finds the smallest composition of contenders that keeps a sequence to the bounds: effects are split off one more at a time, until
/// something does. Writes to `out` what it looked at, what each costs, and how far it is from the reference.
/// @param contenders at least one for the rest; must outlive what is returned
/// @throws OutOfReach; Error where the sequence lacks what all contenders for the rest read
[[nodiscard]] Fitted fit(FitSequence& sequence, std::vector<Contender> const& contenders, FitOptions const& options, std::ostream& out);

} // namespace quell::bench

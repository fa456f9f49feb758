#pragma once

#include "bounds.hpp"
#include "trial.hpp"

#include <span>

namespace quell::bench {

/// Pipelines that make a picture together: one for each effect that is split off, and perhaps one for the rest.
struct Composition {
    Effects split;
    std::vector<Trial const*> parts; ///< all of one precision
    Figures figures{};

    [[nodiscard]] Precision memory() const { return parts.front()->memory; }
};

/// As in "shadow by shadow/radius=5, rest by svgf".
[[nodiscard]] std::string to_string(Composition const& composition);

/// Fills in the figures but FLIP. A composite is a sum, and so the picture is known without running them together.
void measure(Composition& composition, std::span<Converged const> wanted);
void measure_flip(Composition& composition, std::span<Converged const> wanted);

/// Whether this may stand in for another: smaller, within the bounds, and where those name no error, as accurate.
[[nodiscard]] bool stands_in_for(Composition const& smaller, Composition const& other, Bounds const& bounds);

/// The linear picture of a scored frame, by its place among them.
[[nodiscard]] metrics::Picture picture_of(Composition const& composition, std::size_t scored);

/// Those that none of the others is cheaper and more accurate (in RMSE) than, from cheap to dear.
[[nodiscard]] std::vector<Composition*> front_of(std::vector<Composition>& compositions);

/// Which to take of those that split off the same number of effects: the cheapest that keeps to the bounds; none where none does. Of FLIP
/// only the front is measured, from cheap to dear, and no more of it than it takes.
[[nodiscard]] Composition* smallest_within(std::vector<Composition>& compositions, Bounds const& bounds, std::span<Converged const> wanted);

/// Which to take where only time counts, of lists for 0, 1, ... effects split off: of those in time the first list's that comes within
/// 2% of the least RMSE, and there the cheapest. None where none is in time.
[[nodiscard]] Composition* most_accurate_in_time(std::span<std::vector<Composition>> levels, Bounds const& bounds);

} // namespace quell::bench

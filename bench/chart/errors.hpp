#pragma once

#include "row.hpp"

#include <quell/metrics/stability.hpp>

namespace quell::bench {

/// A scored frame: what its picture should be, as displayed, and where the effect is.
struct Wanted {
    long long frame = 0;
    metrics::Picture displayed;
    metrics::Mask mask;
    bool shows_flicker = false;
};

/// Marks the frames by which flicker is measured: the last four, or as many as there are, of the longest row of successive ones.
/// @param wanted in order
void mark_flicker(std::vector<Wanted>& wanted);

/// How far one method is off, over its scored frames.
class MethodErrors {
public:
    /// @param shown what the method made, as displayed
    void add(Wanted const& wanted, metrics::Picture const& shown);
    /// Writes the means into a row; what was never measured stays unknown there.
    void put(Row& row) const;

private:
    metrics::MeanErrors whole, masked; ///< masked: over those frames that have the effect
    double flip_medians = 0;           ///< their sum
    metrics::Flicker flicker;          ///< over those frames that show it
};

} // namespace quell::bench

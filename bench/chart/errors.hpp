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

/// Sums over the scored frames of one method.
class ErrorSums {
public:
    /// @param shown what the method made, as displayed
    void add(Wanted const& wanted, metrics::Picture const& shown);
    /// Writes the means into a row; what was never measured stays unknown there.
    void put(Row& row) const;

private:
    double rmse = 0, ssim = 0, flip = 0, flip_median = 0, mask_rmse = 0, mask_ssim = 0, mask_flip = 0;
    int frames = 0, masked_frames = 0;
    metrics::Flicker flicker; ///< over those frames that show it
};

} // namespace quell::bench

#pragma once

#include "row.hpp"

#include <quell/metrics/stability.hpp>

namespace quell::bench {

/// A scored frame: what its picture should be, as displayed, and where the effect is.
struct Wanted {
    int frame = 0;
    metrics::Picture displayed;
    metrics::Mask mask;
};

/// Sums over the scored frames of one method.
class Errors {
public:
    /// @param shown what the method made, as displayed
    void add(Wanted const& wanted, metrics::Picture const& shown);
    /// Writes the means into a row; what was never measured stays unknown there.
    void put(Row& row) const;

private:
    double rmse = 0, ssim = 0, flip = 0, flip_median = 0, mask_rmse = 0, mask_ssim = 0, mask_flip = 0;
    int frames = 0, masked_frames = 0;
    metrics::Flicker flicker; ///< over frames 31 to 34
};

} // namespace quell::bench

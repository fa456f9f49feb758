#pragma once

#include <quell/metrics/picture.hpp>

namespace quell::examples {

/// How far a picture is from its reference. Sums and means of several are of the same type.
struct ImageErrors {
    double rmse = 0, ssim = 0, flip = 0;

    ImageErrors& operator+=(ImageErrors const& other) {
        rmse += other.rmse, ssim += other.ssim, flip += other.flip;
        return *this;
    }
    friend ImageErrors operator/(ImageErrors const& sum, double n) { return {sum.rmse / n, sum.ssim / n, sum.flip / n}; }
};

/// @param reference, shown as displayed, of one size
[[nodiscard]] ImageErrors image_errors(metrics::Picture const& reference, metrics::Picture const& shown);

} // namespace quell::examples

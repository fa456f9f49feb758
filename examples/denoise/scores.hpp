#pragma once

#include <quell/metrics/picture.hpp>

#include <ostream>

namespace quell::examples {

/// The table of errors that quell-denoise prints: a row per frame that has a reference, and their mean.
class Scores {
public:
    /// Writes the header.
    explicit Scores(std::ostream& out);
    /// Compares two linear pictures as a screen shows them, and writes the row at once.
    void add(long long frame, metrics::Picture const& reference, metrics::Picture const& output);
    /// Writes the last row.
    void finish() const;

private:
    std::ostream& out;
    double rmse = 0, ssim = 0, flip = 0; ///< sums
    int frames = 0;

    void row(std::string const& name, double rmse_, double ssim_, double flip_) const;
};

} // namespace quell::examples

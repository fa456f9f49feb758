#pragma once

#include <quell/metrics/metric.hpp>

#include <ostream>
#include <string>

namespace quell::examples {

/// The table of errors that quell-denoise prints: a row per frame that has a reference, and their mean.
class Scores {
public:
    /// The columns: "frame", and the names of all metrics.
    [[nodiscard]] static std::string header();
    /// Writes the header.
    explicit Scores(std::ostream& out);
    /// Compares two linear pictures as a screen shows them.
    [[nodiscard]] static metrics::Errors compare(metrics::Picture const& reference, metrics::Picture const& output);
    /// Writes the row of a frame at once.
    void add(long long frame, metrics::Errors const& errors);
    /// Writes the last row.
    void finish() const;

private:
    std::ostream& out;
    metrics::MeanErrors mean;

    void row(std::string line, metrics::Errors const& errors) const;
};

} // namespace quell::examples

#pragma once

#include <quell/metrics/metric.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace quell::stability {

/// A method's promise in a case: a number that must not be beyond its limit.
struct Promise {
    std::string subject, method, metric; ///< `subject` is the case's name
    double value = 0, limit = 0;
    bool at_least = false; ///< the limit is the least that is allowed, and otherwise the most

    /// A value that isn't a number holds no promise.
    [[nodiscard]] bool held() const { return at_least ? value >= limit : value <= limit; }
};

/// The error of one frame, displayed, over the pixels that the case is about.
struct FrameError {
    std::string subject, method;
    int frame = 0;
    metrics::Errors errors{};
};

using FrameErrors = std::vector<FrameError>;

/// What all cases have found.
struct Results {
    std::vector<Promise> promises;
    FrameErrors frames;
};

/// Writes stability.csv and frames.csv, with columns that other tools rely on.
void write_tables(Results const& results, std::filesystem::path const& folder);
/// Writes index.html: the error over time of each case, every promise, and why some don't hold.
void write_page(Results const& results, std::filesystem::path const& folder);

} // namespace quell::stability

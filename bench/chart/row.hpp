#pragma once

#include <quell/metrics/metric.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace quell::bench {

/// One method on one scene and effect: a row of chart.csv, and what else is shown of it. NaN stands for what isn't known.
struct Row {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string scene, effect, method;
    Extent size;
    int frames = 0, threads = 0;
    double ms_per_frame = unknown;
    metrics::Errors errors = metrics::MeanErrors{}.mean(), mask_errors = errors; ///< of the image, and of where the effect is
    double flip_median = unknown, flicker = unknown, bytes_per_pixel = unknown;
    bool pareto = false;

    bool competes = true;               ///< false for inputs of more samples: what these cost to render isn't counted
    std::string picture{}, reference{}; ///< PNG files, from the chart's folder; empty for none
};

/// A number that a chart can show.
struct Measure {
    std::string name; ///< its column
    std::string description;
    std::function<double(Row const&)> of;
    bool higher_is_better = false;
    int digits = 6; ///< behind the point
};
/// All metrics of the image and of where the effect is, and what only charts have.
[[nodiscard]] std::vector<Measure> const& measures();

/// Marks the rows of one scene and effect that no other is both faster and more accurate (in RMSE) than.
void mark_pareto_front(std::vector<Row>& rows);

/// The header of chart.csv, and a row of it, without line ends. What isn't known is an empty cell.
[[nodiscard]] std::string csv_header();
[[nodiscard]] std::string csv_line(Row const& row);

} // namespace quell::bench

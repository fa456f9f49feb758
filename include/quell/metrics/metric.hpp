#pragma once

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// A displayed picture beside what it should be, and the FLIP between them: it takes longest, and serves more than one purpose.
/// @throws Error where sizes differ or a component is outside [0, 1]
struct Comparison {
    Picture const& reference;                ///< what it should be
    Picture const& test;                     ///< what is judged
    Flip difference = flip(reference, test); ///< by pixel
};

/// A number that says how far a picture is from its reference.
struct Metric {
    std::string_view name;                        ///< of columns and keys, as in "rmse"
    std::string_view title;                       ///< in reports, as in "RMSE"
    std::string_view meaning;                     ///< in words
    std::string_view remark;                      ///< what else there is to say where it is one of the whole picture
    double (*of)(Comparison const&, Mask const&); ///< over the selected pixels
    bool higher_is_better = false;                ///< as of SSIM; else lower is
};

/// All metrics, in the order in which programs show them. A new one is a line here: columns, keys, reports and charts go by this table.
inline constexpr std::array all_metrics{
    Metric{"rmse", "RMSE", "root mean square error", "displayed",
           [](Comparison const& c, Mask const& mask) { return rmse(c.reference, c.test, mask); }},
    Metric{"ssim", "SSIM", "structural similarity", "displayed",
           [](Comparison const& c, Mask const& mask) { return ssim(c.reference, c.test, mask); }, true},
    Metric{"flip", "FLIP", "FLIP", "mean over the image", [](Comparison const& c, Mask const& mask) { return c.difference.mean(mask); }},
};

/// A metric's place in the table, by its name. A name that isn't there does not compile.
struct MetricName {
    std::size_t place = 0; ///< in all_metrics
    /// @param name of a metric
    consteval MetricName(char const* name) {
        while (all_metrics[place].name != name) ++place;
    }
};

/// A number for each metric: of one picture, or means over several.
struct Errors {
    std::array<double, all_metrics.size()> values{}; ///< in the order of all_metrics

    /// That of a metric, as in errors["rmse"].
    double& operator[](MetricName name) { return values[name.place]; }
    /// The same to read.
    [[nodiscard]] double operator[](MetricName name) const { return values[name.place]; }
    /// Calls visit(metric, value) for each.
    void for_each(auto const& visit) const {
        for (std::size_t i = 0; i < values.size(); ++i) visit(all_metrics[i], values[i]);
    }
};

/// All metrics of a picture, over the selected pixels.
/// @throws Error where the mask does not fit or selects nothing
[[nodiscard]] inline Errors errors_of(Comparison const& compared, Mask const& mask = {}) {
    Errors errors;
    for (std::size_t i = 0; i < errors.values.size(); ++i) errors.values[i] = all_metrics[i].of(compared, mask);
    return errors;
}

/// Means of pictures' errors. Pictures are added one by one.
struct MeanErrors {
    Errors sum{};  ///< so far
    int count = 0; ///< of pictures

    /// Adds those of a picture.
    void add(Errors const& errors) {
        std::ranges::transform(sum.values, errors.values, sum.values.begin(), std::plus{});
        ++count;
    }
    /// NaN where nothing was added.
    [[nodiscard]] Errors mean() const {
        auto mean = sum;
        for (auto& value : mean.values) value = count > 0 ? value / count : std::numeric_limits<double>::quiet_NaN();
        return mean;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics

#include "report/report.hpp"

#include <algorithm>

namespace quell::examples {

namespace {

template <class Named> Named& find_or_append(std::vector<Named>& list, std::string const& name) {
    auto const found = std::ranges::find(list, name, &Named::name);
    return found != list.end() ? *found : list.emplace_back(Named{.name = name});
}

} // namespace

void Report::add_value(std::string const& metric, std::string const& series, int frame, double value) {
    find_or_append(find_or_append(metrics, metric).series, series).points.push_back({frame, value});
}

ColorScale flip_color_scale() {
    // Ten evenly spaced samples of magma: a gradient between them differs from the full map by less than the eye can tell.
    return {
        "FLIP error", 0, 1, {"#000004", "#180f3d", "#440f76", "#721f81", "#9e2f7f", "#cd4071", "#f1605d", "#fd9668", "#feca8d", "#fcfdbf"}};
}

} // namespace quell::examples

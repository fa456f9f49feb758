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

} // namespace quell::examples

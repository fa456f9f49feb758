#include "row.hpp"

#include <support/csv.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quell::bench {
namespace {

std::string cell(double value, int digits) { return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, digits); }

bool beats(Row const& other, Row const& row) {
    return other.competes && other.ms_per_frame < row.ms_per_frame && other.errors["rmse"] < row.errors["rmse"];
}

} // namespace

void mark_pareto_front(std::vector<Row>& rows) {
    for (auto& row : rows)
        row.pareto = row.competes && !std::isnan(row.errors["rmse"]) &&
                     std::ranges::none_of(rows, [&](Row const& other) { return beats(other, row); });
}

std::vector<Measure> const& measures() {
    static std::vector<Measure> const all = [] {
        std::vector<Measure> list;
        auto const add_metrics = [&](metrics::Errors Row::*errors, std::string const& name, std::string const& description) {
            for (std::size_t i = 0; i < metrics::all_metrics.size(); ++i) {
                auto const& m = metrics::all_metrics[i];
                list.push_back({fmt::format(fmt::runtime(name), m.name), fmt::format(fmt::runtime(description), m.meaning, m.remark),
                                [=](Row const& row) { return (row.*errors).values[i]; }, m.higher_is_better});
            }
        };
        add_metrics(&Row::errors, "{}", "{}, {}");
        list.push_back({"flip_median", "FLIP, weighted median", &Row::flip_median});
        add_metrics(&Row::mask_errors, "mask_{}", "{} where the effect is");
        list.push_back({"flicker", "deviation of the error over up to four successive frames", &Row::flicker});
        list.push_back(
            {.name = "bytes_per_pixel", .description = "bytes per pixel of history and scratch", .of = &Row::bytes_per_pixel, .digits = 1});
        return list;
    }();
    return all;
}

std::string csv_header() {
    std::string header = "scene,effect,method,width,height,frames,threads,ms_per_frame";
    for (auto const& measure : measures()) header += "," + measure.name;
    return header + ",pareto";
}

std::string csv_line(Row const& row) {
    std::string line = examples::csv_cell(row.scene) + "," + row.effect + "," + examples::csv_cell(row.method);
    for (int whole : {row.size.width, row.size.height, row.frames, row.threads}) line += "," + std::to_string(whole);
    line += "," + cell(row.ms_per_frame, 3);
    for (auto const& measure : measures()) line += "," + cell(measure.of(row), measure.digits);
    return line + (row.pareto ? ",1" : ",0");
}

} // namespace quell::bench

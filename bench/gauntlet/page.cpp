#include <files.hpp>
#include <gauntlet/page.hpp>

#include <report/report.hpp>
#include <support/csv.hpp>
#include <support/png.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace quell::gauntlet {

namespace {

constexpr std::size_t shown_rows = 40;
constexpr std::array picture_names{"input", "--quick", "default", "reference"};

double mean_of(Row const& row, Method method) {
    double sum = 0;
    for (auto const& frame : row.frames) sum += frame.error[method];
    return sum / static_cast<double>(std::max<std::size_t>(row.frames.size(), 1));
}

/// Rows, the worst first.
std::vector<std::size_t> by_badness(std::vector<Verdict> const& verdicts) {
    std::vector<std::size_t> order(verdicts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto const badness = [&](std::size_t i) { return std::max(verdicts[i].over_quick, verdicts[i].over_input); };
    std::ranges::stable_sort(order, [&](auto a, auto b) { return badness(a) > badness(b); });
    return order;
}

/// Pictures of a few dozen pixels are too small to look at.
metrics::Picture enlarged(metrics::Picture const& picture, int times) {
    metrics::Picture large{{picture.size.width * times, picture.size.height * times}, {}};
    for (int y = 0; y < large.size.height; ++y)
        for (int x = 0; x < large.size.width; ++x)
            large.pixels.push_back(picture.pixels[static_cast<std::size_t>(y / times * picture.size.width + x / times)]);
    return large;
}

} // namespace

std::string line_of(Row const& row, Verdict const& verdict) {
    return fmt::format("{},{},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.1f},{:.3f},{}", examples::csv_cell(row.situation->name), row.samples,
                       mean_of(row, by_none), mean_of(row, by_quick), mean_of(row, by_default), verdict.over_quick, verdict.over_input,
                       verdict.good_windows, verdict.right_over_before, verdict.broken.empty() ? 1 : 0);
}

void write_tables(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts, std::filesystem::path const& folder) {
    std::string lines = row_columns + std::string("\n"), frames = "situation,samples,frame,method,rmse,right_rmse\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        lines += line_of(rows[i], verdicts[i]) + '\n';
        for (auto const& frame : rows[i].frames)
            for (std::size_t m = 0; m < method_names.size(); ++m)
                frames += fmt::format("{},{},{},{},{:.6f},{:.6f}\n", rows[i].situation->name, rows[i].samples, frame.frame, method_names[m],
                                      frame.error[m], frame.right[m]);
    }
    bench::write_text(folder / "gauntlet.csv", lines);
    bench::write_text(folder / "frames.csv", frames);
}

void write_page(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts, std::filesystem::path const& folder) {
    auto const held = std::ranges::count_if(verdicts, [](auto const& verdict) { return verdict.broken.empty(); });
    examples::Report report{.title = "quell: where assumptions do not hold",
                            .subtitle = fmt::format("{} of {} rows hold every limit; the worst rows first", held, rows.size())};
    for (auto const* const name : picture_names) report.kinds.push_back({.name = name});
    examples::ReportTable table{.caption = "RMSE of linear colour, mean over the frames; ratios of the worst frame",
                                .columns = {"", "situation", "samples", "what is broken", "stage", "input", "--quick", "default",
                                            "over --quick", "over input", "good windows, %", "right part over before", "broken limits",
                                            "remarks"},
                                .rows = {}};
    int number = 0;
    for (auto const i : by_badness(verdicts)) {
        auto const& row = rows[i];
        auto const& verdict = verdicts[i];
        auto const three = [](double a) { return fmt::format("{:.3f}", a); };
        table.rows.push_back({std::to_string(++number), row.situation->name, std::to_string(row.samples), row.situation->about,
                              row.situation->stage, fmt::format("{:.4f}", mean_of(row, by_none)),
                              fmt::format("{:.4f}", mean_of(row, by_quick)), fmt::format("{:.4f}", mean_of(row, by_default)),
                              three(verdict.over_quick), three(verdict.over_input), fmt::format("{:.1f}", verdict.good_windows),
                              three(verdict.right_over_before), fmt::format("{}", fmt::join(verdict.broken, "; ")),
                              fmt::format("{}", fmt::join(row.remarks, "; "))});
        if (static_cast<std::size_t>(number) > shown_rows || row.pictures[0].pixels.empty()) continue;
        examples::ReportFrame frame{.number = number};
        for (std::size_t m = 0; m < picture_names.size(); ++m)
            frame.pictures[picture_names[m]] = examples::encode_png(metrics::displayed(enlarged(row.pictures[m], 4)));
        report.frames.push_back(std::move(frame));
        for (std::size_t m = 0; m < method_names.size(); ++m) report.add_value("RMSE", method_names[m], number, mean_of(row, Method{m}));
    }
    report.tables.push_back(std::move(table));
    report.notes.push_back(
        {.label = "frames", .text = "Frame n of the viewer is row n of the table: the frame in which the default is worst."});
    examples::write_report(report, folder / "index.html");
}

} // namespace quell::gauntlet

#include "plot.hpp"

#include <quell/core/error.hpp>
#include <support/gnuplot.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace quell::bench {
namespace {

using examples::quoted_for_gnuplot;

constexpr int panel_width = 560, panel_height = 420;

/// A number with all its digits.
std::string number(double value) { return fmt::format("{:.9g}", value); }

/// Blocks of data and the elements that draw them. What is empty is left out, since gnuplot refuses to plot nothing.
class Drawing {
public:
    explicit Drawing(int panel) : prefix("$panel" + std::to_string(panel) + "_") {}

    /// Draws rows in several ways, one over the other. A row of data is: milliseconds, RMSE, method.
    void add(std::vector<Row> const& rows, std::initializer_list<std::string> looks) {
        if (rows.empty()) return;
        auto const name = prefix + std::to_string(blocks++);
        data += name + " << END\n";
        for (auto const& row : rows)
            data += number(row.ms_per_frame) + " " + number(row.errors["rmse"]) + " " + quoted_for_gnuplot(row.method) + "\n";
        data += "END\n";
        for (auto const& look : looks) elements += (elements.empty() ? "plot " : ", ") + name + " using " + look + " notitle";
    }
    [[nodiscard]] std::string script(std::string const& settings) const {
        return elements.empty() ? "" : data + settings + elements + "\n";
    }

private:
    std::string prefix, data, elements;
    int blocks = 0;
};

std::vector<Row> those(std::vector<Row> const& rows, auto const& condition) {
    std::vector<Row> chosen;
    std::ranges::copy_if(rows, std::back_inserter(chosen), condition);
    std::ranges::stable_sort(chosen, {}, &Row::ms_per_frame);
    return chosen;
}

/// 1, 2 and 5 times powers of ten.
std::string ticks() {
    std::string list;
    for (double power = 1e-3; power < 1e6; power *= 10)
        for (double const factor : {1., 2., 5.}) list += (list.empty() ? "" : ",") + number(factor * power);
    return list;
}

bool is_known(Row const& row) { return row.ms_per_frame > 0 && !std::isnan(row.errors["rmse"]); }

/// With room for names to both sides.
std::string x_range(std::vector<Row> const& rows) {
    if (rows.empty()) return "";
    auto const [least, most] = std::ranges::minmax(rows, {}, &Row::ms_per_frame);
    double const room = std::max(2., std::pow(most.ms_per_frame / least.ms_per_frame, 0.3));
    return "set xrange [" + number(least.ms_per_frame / room) + ":" + number(most.ms_per_frame * room) + "]\n";
}

/// One scene and effect.
std::string panel(std::vector<Row> const& all, int index) {
    auto const rows = those(all, is_known);
    // The front is the lower left border: its names stand there, where they cover no others.
    std::string const blue = "#1f66d1", grey = "#8a93a1";
    auto const inner = [](char const* lift) {
        return std::string("1:2:3 with labels left offset 0.8,") + lift + " font ',9' tc rgb '#5d6675'";
    };
    std::string const outer = "1:2:3 with labels right offset -0.8,-0.45 font ',9' tc rgb '" + blue + "'";
    Drawing drawing(index);
    for (auto const& curve : curves_of(rows)) drawing.add(curve.points, {"1:2 with linespoints lw 0.7 pt 7 ps 0.25 lc rgb '#b9a48a'"});
    auto const rest = those(rows, [](Row const& row) { return row.competes && !row.pareto && !row.variant; });
    // Neighbours' names stand above and below by turns.
    for (std::size_t const turn : {0u, 1u}) {
        std::vector<Row> some;
        for (std::size_t i = turn; i < rest.size(); i += 2) some.push_back(rest[i]);
        drawing.add(some, {"1:2 with points pt 7 ps 0.7 lc rgb '" + grey + "'", inner(turn == 0 ? "0.35" : "-0.45")});
    }
    drawing.add(those(rows, [](Row const& row) { return !row.competes; }),
                {"1:2 with points pt 6 ps 0.8 lc rgb '" + grey + "'", inner("0.35")});
    drawing.add(those(rows, [](Row const& row) { return row.pareto; }),
                {"1:2 with linespoints lw 2 pt 7 ps 0.9 lc rgb '" + blue + "'", outer});
    return drawing.script("set title " + quoted_for_gnuplot(all.front().scene + ", " + all.front().effect) + "\n" + x_range(rows));
}

} // namespace

void require_gnuplot() {
    if (!examples::has_gnuplot())
        throw Failure("gnuplot", "it can't be run, and chart.svg wants it", "install it (on Debian, apt-get install gnuplot-nox)");
}

std::string plot_script(std::vector<Row> const& rows, std::string const& svg) {
    auto const cases = by_case(rows);
    int const columns = std::clamp(static_cast<int>(cases.size()), 1, 3);
    int const lines = std::max(1, (static_cast<int>(cases.size()) + columns - 1) / columns);
    std::ostringstream script;
    script << "set encoding utf8\nset terminal svg noenhanced size " << columns * panel_width << "," << lines * panel_height
           << " font 'sans-serif,11' background rgb 'white'\nset output " << quoted_for_gnuplot(svg)
           << "\nset logscale x\nset grid lc rgb '#dde2e9'\n"
           << "set xlabel 'milliseconds per frame'\nset ylabel 'RMSE'\nset yrange [0:*]\nset offsets 0, 0, graph 0.08, 0\n"
           << "set xtics (" << ticks() << ")\n"
           << "set multiplot layout " << lines << "," << columns << "\n";
    for (std::size_t i = 0; i < cases.size(); ++i) script << panel(cases[i], static_cast<int>(i));
    script << "unset multiplot\n";
    return script.str();
}

void write_plot(std::vector<Row> const& rows, std::filesystem::path const& folder) {
    examples::draw_by_gnuplot(folder / "chart.gnuplot", plot_script(rows, "chart.svg"));
}

} // namespace quell::bench

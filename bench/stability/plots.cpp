#include "results.hpp"

#include <support/gnuplot.hpp>
#include <support/output_folder.hpp>

#include <map>
#include <sstream>

namespace quell::stability {
namespace {

using examples::quoted_for_gnuplot;

/// Points by method, and by case.
using Curves = std::map<std::string, std::string>;
std::map<std::string, Curves> curves_of(Results const& results) {
    std::map<std::string, Curves> cases;
    for (auto const& f : results.frames) {
        std::ostringstream line;
        line << f.frame << ' ' << f.errors["rmse"] << '\n';
        cases[f.subject][f.method] += line.str();
    }
    return cases;
}

/// The commands that draw one panel, its data within.
std::string panel(std::string const& name, Curves const& curves) {
    std::string data, plot;
    int i = 0;
    for (auto const& [method, points] : curves) {
        auto const block = "$m" + std::to_string(i++);
        data += block + " << END\n" + points + "END\n";
        plot += (plot.empty() ? "plot " : ", ") + block + " with linespoints pointsize 0.4 title " + quoted_for_gnuplot(method);
    }
    return data + "set title " + quoted_for_gnuplot(name) + "\n" + plot + "\n";
}

constexpr auto style =
    "set xlabel 'frame'\nset ylabel 'RMSE'\nset yrange [0:*]\nset key outside right noenhanced maxcols 1\nset title noenhanced\nset grid\n";

std::string script(std::map<std::string, Curves> const& cases) {
    constexpr int width = 720, height = 300;
    std::ostringstream all;
    all << "set terminal svg size " << width << ',' << height << " background 'white'\n" << style;
    for (auto const& [name, curves] : cases)
        all << "set output " << quoted_for_gnuplot("plots/" + name + ".svg") << '\n' << panel(name, curves);
    auto const rows = (cases.size() + 1) / 2;
    all << "set terminal svg size " << 2 * width << ',' << height * static_cast<int>(rows)
        << " background 'white'\nset output 'stability.svg'\nset multiplot layout " << rows << ",2\n";
    for (auto const& [name, curves] : cases) all << panel(name, curves);
    all << "unset multiplot\n";
    return all.str();
}

} // namespace

void draw_plots(Results const& results, std::filesystem::path const& folder) {
    auto const cases = curves_of(results);
    if (cases.empty()) return;
    examples::make_output_folder(folder / "plots");
    examples::draw_by_gnuplot(folder / "stability.gnuplot", script(cases));
}

} // namespace quell::stability

#include "plots.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace quell::stability {
namespace {

/// Points by method, and by case.
using Curves = std::map<std::string, std::string>;
std::map<std::string, Curves> curves_of(Results const& results) {
    std::map<std::string, Curves> cases;
    for (auto const& f : results.frames) {
        std::ostringstream line;
        line << f.frame << ' ' << f.rmse << '\n';
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
        plot += (plot.empty() ? "plot " : ", ") + block + " with linespoints pointsize 0.4 title '" + method + "'";
    }
    return data + "set title '" + name + "'\n" + plot + "\n";
}

constexpr auto style =
    "set xlabel 'frame'\nset ylabel 'RMSE'\nset yrange [0:*]\nset key outside right noenhanced maxcols 1\nset title noenhanced\nset grid\n";

std::string script(std::map<std::string, Curves> const& cases, std::filesystem::path const& folder) {
    constexpr int width = 720, height = 300;
    std::ostringstream all;
    all << "set terminal svg size " << width << ',' << height << " background 'white'\n" << style;
    for (auto const& [name, curves] : cases)
        all << "set output '" << (folder / "plots" / (name + ".svg")).string() << "'\n" << panel(name, curves);
    auto const rows = (cases.size() + 1) / 2;
    all << "set terminal svg size " << 2 * width << ',' << height * static_cast<int>(rows) << " background 'white'\nset output '"
        << (folder / "stability.svg").string() << "'\nset multiplot layout " << rows << ",2\n";
    for (auto const& [name, curves] : cases) all << panel(name, curves);
    all << "unset multiplot\n";
    return all.str();
}

} // namespace

bool draw_plots(Results const& results, std::filesystem::path const& folder) {
    auto const cases = curves_of(results);
    if (cases.empty()) return true;
    if (std::system("command -v gnuplot > /dev/null") != 0) return false;
    std::filesystem::create_directories(folder / "plots");
    auto* const gnuplot = popen("gnuplot", "w");
    if (gnuplot == nullptr) return false;
    auto const commands = script(cases, folder);
    std::fwrite(commands.data(), 1, commands.size(), gnuplot);
    return pclose(gnuplot) == 0;
}

} // namespace quell::stability

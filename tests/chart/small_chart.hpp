#pragma once

#include "../temporary_folder.hpp"
#include "chart/options.hpp"

#include <iterator>
#include <vector>

namespace quell::bench {

/// Charts two methods and an input that is looked at in scored frames only, on a scene, small and roughly; the references go to
/// the options' folder. Compiled by itself, since that takes long.
void chart_small(ChartOptions const& options);

/// The command line of a small chart.
inline ChartOptions small_options(std::filesystem::path const& out, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"quell-chart", "--scene",   "fence",    "--effect", "shadow",      "--size",
                                   "24x16",       "--few",     "--frames", "33",       "--tolerance", "1",
                                   "--quiet",     "--threads", "2",        "--out",    out.string()};
    words.insert(words.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    std::vector<char const*> arguments;
    for (auto const& word : words) arguments.push_back(word.c_str());
    return chart_options(static_cast<int>(arguments.size()), arguments.data());
}

} // namespace quell::bench

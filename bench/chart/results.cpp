#include "results.hpp"

#include "../files.hpp"
#include "page.hpp"

#include <support/output_folder.hpp>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <utility>

namespace quell::bench {

Results::Results(ChartOptions const& options_) : options(options_) {
    examples::make_output_folder(options.out);
    if (!options.quiet) std::cout << csv_header() << std::endl;
}

void Results::add(std::vector<Row> rows) {
    mark_pareto_front(rows);
    for (auto const& row : rows)
        if (!options.quiet) std::cout << csv_line(row) << std::endl;
    std::ranges::move(rows, std::back_inserter(all));
    auto lines = csv_header() + '\n';
    for (auto const& row : all) lines += csv_line(row) + '\n';
    write_text(options.out / "chart.csv", lines);
    if (!options.times) write_chart_page(all, options.out / "index.html");
}

} // namespace quell::bench

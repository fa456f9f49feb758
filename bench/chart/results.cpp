#include "results.hpp"

#include "page.hpp"

#include <quell/core/error.hpp>
#include <support/output_folder.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
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
    write_csv();
    if (!options.times) write_chart_page(all, options.out / "index.html");
}

void Results::write_csv() const {
    auto const file = options.out / "chart.csv";
    std::ofstream out(file, std::ios::binary);
    out << csv_header() << '\n';
    for (auto const& row : all) out << csv_line(row) << '\n';
    out.close();
    if (!out) throw Failure(file.string(), std::string("can't be written: ") + std::strerror(errno), "check that its folder has room");
}

} // namespace quell::bench

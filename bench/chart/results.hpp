#pragma once

#include "options.hpp"
#include "row.hpp"

namespace quell::bench {

/// The chart as it grows: all files are there after every case, so that a run that is cut short has not been in vain.
class Results {
public:
    /// @throws Error where the folder can't be made or written to
    explicit Results(ChartOptions const& options);

    /// Takes the rows of one scene and effect, marks their front, prints them on standard output, and writes chart.csv and index.html
    /// anew.
    void add(std::vector<Row> rows);

private:
    ChartOptions const& options;
    std::vector<Row> all;
};

} // namespace quell::bench

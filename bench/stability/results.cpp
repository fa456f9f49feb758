#include "results.hpp"

#include "../files.hpp"

#include <support/csv.hpp>

#include <fmt/format.h>

namespace quell::stability {
using examples::csv_cell;

void write_tables(Results const& results, std::filesystem::path const& folder) {
    std::string promises = "case,method,metric,value,limit,held\n", frames = "case,method,frame,rmse,flip\n";
    for (auto const& p : results.promises)
        promises += fmt::format("{},{},{},{:.6g},{:.6g},{:d}\n", csv_cell(p.subject), csv_cell(p.method), csv_cell(p.metric), p.value,
                                p.limit, p.held());
    for (auto const& f : results.frames)
        frames +=
            fmt::format("{},{},{},{:.6g},{:.6g}\n", csv_cell(f.subject), csv_cell(f.method), f.frame, f.errors["rmse"], f.errors["flip"]);
    bench::write_text(folder / "stability.csv", promises), bench::write_text(folder / "frames.csv", frames);
}

} // namespace quell::stability

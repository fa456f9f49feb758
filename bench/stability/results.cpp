#include "results.hpp"

#include <quell/core/error.hpp>
#include <support/csv.hpp>

#include <fmt/format.h>

#include <fstream>

namespace quell::stability {
namespace {

using examples::csv_cell;

/// Enough digits to be compared from run to run, and no more.
std::string number(double a) { return fmt::format("{:.6g}", a); }

std::ofstream file_for(std::filesystem::path const& path, char const* header) {
    std::ofstream file(path);
    file << header << '\n';
    return file;
}

void finish(std::ofstream& file, std::filesystem::path const& path) {
    if (!file.flush()) throw Failure(path.string(), "it can't be written", "check the folder and the space that is left");
}

} // namespace

void write_tables(Results const& results, std::filesystem::path const& folder) {
    auto const promises = folder / "stability.csv", frames = folder / "frames.csv";
    auto file = file_for(promises, "case,method,metric,value,limit,held");
    for (auto const& p : results.promises)
        file << csv_cell(p.subject) << ',' << csv_cell(p.method) << ',' << csv_cell(p.metric) << ',' << number(p.value) << ','
             << number(p.limit) << ',' << p.held() << '\n';
    finish(file, promises);
    file = file_for(frames, "case,method,frame,rmse,flip");
    for (auto const& f : results.frames)
        file << csv_cell(f.subject) << ',' << csv_cell(f.method) << ',' << f.frame << ',' << number(f.errors["rmse"]) << ','
             << number(f.errors["flip"]) << '\n';
    finish(file, frames);
}

} // namespace quell::stability

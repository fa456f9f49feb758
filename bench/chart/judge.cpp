#include "judge.hpp"

#include <quell/core/error.hpp>
#include <support/png.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace quell::bench {

std::string file_name(std::string name) {
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '_';
    return name;
}

Judge::Judge(ChartOptions const& options_, SceneEffect const& what, std::vector<Wanted> wanted_, long long pictured_)
    : options(options_), scene(what.scene), effect(what.effect), wanted(std::move(wanted_)), pictured(pictured_) {
    mark_flicker(wanted);
    for (auto const& one : wanted)
        if (one.frame == pictured) reference = write(reference_name, one.displayed);
}

void Judge::measure(long long frame, std::span<Entry> entries, std::span<metrics::Picture const> pictures) const {
    auto const found = std::ranges::find(wanted, frame, &Wanted::frame);
    tbb::parallel_for(std::size_t(0), entries.size(), [&](std::size_t i) {
        auto const shown = displayed(entries[i].method, frame, pictures[i]);
        entries[i].errors.add(*found, shown);
        if (frame == pictured) entries[i].picture = write(entries[i].method, shown);
    });
}

metrics::Picture Judge::displayed(std::string const& method, long long frame, metrics::Picture const& linear) const {
    try {
        return metrics::displayed(linear);
    } catch (Error const& error) {
        throw Failure(method + " on " + scene + ", " + effect, "in frame " + std::to_string(frame) + " " + error.found, error.remedy);
    }
}

Row Judge::row_of(Entry const& entry, double ms_per_frame, double bytes_per_pixel) const {
    Row row{.scene = scene, .effect = effect, .method = entry.method, .size = options.size, .frames = options.frames};
    row.threads = options.threads;
    row.ms_per_frame = ms_per_frame, row.bytes_per_pixel = bytes_per_pixel;
    row.competes = entry.competes;
    row.picture = entry.picture, row.reference = reference;
    entry.errors.put(row);
    return row;
}

std::string Judge::write(std::string const& method, metrics::Picture const& shown) const {
    auto const folder = std::filesystem::path("pictures") / file_name(scene + "-" + effect);
    std::error_code ignored; // the file says what is wrong
    std::filesystem::create_directories(options.out / folder, ignored);
    auto const path = folder / (file_name(method) + ".png");
    examples::write_png(options.out / path, shown);
    return path.generic_string();
}

} // namespace quell::bench

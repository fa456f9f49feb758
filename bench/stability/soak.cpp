#include "cases.hpp"
#include "watch.hpp"

#include <quell/core/real.hpp>
#include <support/progress.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <unistd.h>

namespace quell::stability {
namespace {

constexpr int loop = 40, round = 200;

/// Of this process, in MiB.
double resident_memory() {
    long long total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// A frame whose right and lower parts are gone.
io::ExrImage cropped(io::ExrImage const& image, Extent size) {
    io::ExrImage result{.name = image.name, .size = size, .attributes = image.attributes};
    for (auto const& from : image.planes) {
        io::Plane to{.name = from.name, .type = from.type, .values = {}};
        for (int y = 0; y < size.height; ++y) {
            auto const row = from.values.begin() + y * image.size.width;
            to.values.insert(to.values.end(), row, row + size.width);
        }
        result.planes.push_back(std::move(to));
    }
    return result;
}

/// Each round of 200 frames is five loops: a jump in time at the end of each is a cut that the motion vectors know nothing of. In the
/// third loop a few frames have no numbers in a tenth of all channels' pixels. In every tenth round the fourth loop has another size; in
/// between, history is never told to start afresh. The last loop's last frame is scored.
struct Round {
    int number, loop_number, place;
    explicit Round(int frame) : number(frame / round), loop_number(frame % round / loop), place(frame % loop) {}
    [[nodiscard]] bool has_burst() const { return loop_number == 2 && place % 10 == 3; }
    [[nodiscard]] bool changes_size() const { return number % 10 == 4; }
    [[nodiscard]] bool is_smaller() const { return loop_number == 3 && changes_size(); }
    [[nodiscard]] bool is_scored() const { return loop_number == 4 && place == loop - 1; }
};

io::ExrImage frame_at(int number, ScoredSequence const& sequence, std::mt19937& random) {
    Round const at(number);
    auto image = sequence.frame(at.place);
    if (at.is_smaller()) return cropped(image, {sequence.size.width - 37, sequence.size.height - 11});
    if (at.has_burst())
        for (auto& each : image.planes)
            for (auto& value : each.values)
                if (random() % 10 == 0)
                    value = random() % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    return image;
}

/// Of one method.
struct Log {
    FrameErrors errors;
    std::vector<double> memory;
    double broken = 0;
};

Log run(examples::Preset const& preset, ScoredSequence const& sequence, Making const& making, bool quiet) {
    auto const denoiser = examples::denoiser_of(preset, sequence.size, making.threads);
    std::mt19937 random(making.seed + 7);
    Log log;
    examples::Progress progress(preset.name, making.long_run, !quiet);
    for (int i = 0; i < making.long_run; ++i) {
        progress.show(i);
        auto const picture = denoiser->denoise(frame_at(i, sequence, random), {}, i);
        for (auto const& p : picture.pixels) log.broken += is_finite(p.x) && is_finite(p.y) && is_finite(p.z) ? 0 : 1;
        if (!Round(i).is_scored()) continue;
        record(log.errors, "soak", preset.name, i, sequence.reference(loop - 1), picture);
        log.memory.push_back(resident_memory());
    }
    return log;
}

} // namespace

void soak(Making const& making, bool quiet, Results& results) {
    auto const sequence = traced({.scene = "room", .scored_from = loop - 1, .last = loop - 1}, making);
    for (std::string const method : {"surface-clamp", "svgf", "trmv"}) {
        auto const log = run(examples::preset_of(method), sequence, making, quiet);
        results.frames.insert(results.frames.end(), log.errors.begin(), log.errors.end());
        results.promises.push_back({"soak", method, "broken_pixels", log.broken, 0});
        // The same frames have the same error, however many came before; both are far from a change of size.
        auto last = log.errors.size() - 1;
        if (Round(static_cast<int>(last) * round).changes_size()) --last;
        auto const rmse = [&](std::size_t i) { return log.errors[i].errors["rmse"]; };
        results.promises.push_back({"soak", method, "drift_of_error", std::abs(rmse(last) / rmse(3) - 1), 1e-3});
        // A leak goes on; that the allocator finds its final layout late does not.
        auto const half = log.memory.begin() + static_cast<std::ptrdiff_t>(log.memory.size() / 2);
        auto const more = *std::max_element(half, log.memory.end()) - *std::max_element(log.memory.begin(), half);
        results.promises.push_back({"soak", method, "MiB_more_in_second_half", more, 1});
    }
}

} // namespace quell::stability

#pragma once

#include "threads.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/frame/frame.hpp>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

namespace quell::live {

/// What the tracer gives every preset.
using TracedFrame = Frame<Channels<Radiance, Albedo, Normal, Depth, Motion>>;

/// The time that a pass took.
struct PassTime {
    char const* name = ""; ///< quell's
    double seconds = 0;    ///< in the last frame
};

/// The seconds since some moment; each program says where they come from.
double seconds_now();

/// Calls rows(first, the one after the last) for parts of [from, to), on all threads. Parts begin where pairs of rows do.
void share_rows(int from, int to, auto const& rows) {
    if (thread_count() == 1) return rows(from, to);
    constexpr int parts_of_thread = 8, most_rows = 16;
    int const fair = (to - from) / (parts_of_thread * thread_count()) / 2 * 2, height = std::clamp(fair, 2, most_rows);
    share((to - from + height - 1) / height, [&](int part) {
        int const first = from + part * height;
        rows(first, std::min(first + height, to));
    });
}

/// Runs what it is given on all threads, and notes the time of each pass.
struct Timed {
    std::vector<PassTime>* times; ///< one for each name

    /// See Executor.
    void for_each_pixel(Region region, auto const& job) const {
        double const start = seconds_now();
        share_rows(region.y0, region.y1, [&](int y0, int y1) { Outlined<>{}.for_each_pixel({region.x0, y0, region.x1, y1}, job); });
        double const taken = seconds_now() - start;
        for (auto& time : *times)
            if (std::string_view(time.name) == job.name) {
                time.seconds += taken;
                return;
            }
        times->push_back({job.name, taken});
    }
};

/// A preset with its history.
class Denoiser {
public:
    std::vector<PassTime> times; ///< of the last frame

    virtual ~Denoiser() = default;
    /// Writes the denoised frame into `out`.
    virtual void run(TracedFrame const& frame, Planar<>::Image<3>& out) = 0;
    /// Starts anew, as behind a cut.
    virtual void forget() = 0;
};

/// The preset of a number, for pictures of a size: general, svgf, surface-clamp; none for others.
std::unique_ptr<Denoiser> make_denoiser(int preset, Extent size);
/// Not a preset: takes what one has made, with depth and motion, and smooths its edges.
std::unique_ptr<Denoiser> make_anti_aliasing(Extent size);

} // namespace quell::live

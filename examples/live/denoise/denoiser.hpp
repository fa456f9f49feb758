#pragma once

#include <quell/execute/outlined.hpp>
#include <quell/frame/frame.hpp>

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

/// Runs what it is given, and notes the time of each pass.
struct Timed {
    std::vector<PassTime>* times; ///< one for each name

    /// See Executor.
    void for_each_pixel(Region region, auto const& job) const {
        double const start = seconds_now();
        Outlined<>{}.for_each_pixel(region, job);
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

/// A preset, for pictures of a size.
using MakeDenoiser = std::unique_ptr<Denoiser> (*)(Extent);
std::unique_ptr<Denoiser> make_general(Extent size);
std::unique_ptr<Denoiser> make_svgf(Extent size);
std::unique_ptr<Denoiser> make_surface_clamp(Extent size);
/// Not a preset: takes what one has made, with depth and motion, and smooths its edges.
std::unique_ptr<Denoiser> make_anti_aliasing(Extent size);

} // namespace quell::live

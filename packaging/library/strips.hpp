#pragma once

#include "host_images.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/pipeline/plan.hpp>

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quell_library {

/// How far a pass may look, in rows, at images of which rows are taken strip by strip. Where one looks further, they are copied as a whole.
inline constexpr int farthest_in_strips = 8;

// Whatever runs a pass is flattened: what all passes share must say that it stays a function, or each would have a copy of it.

/// Rows of the caller's images as planes in padded rows, for one strip of one pass. It stays in the cache.
class StripOfImages {
    using Plane = OwnImages::Image<1>; ///< has zeros between its rows
    static constexpr int rows_of_plane = most_rows_of_strip + 2 * farthest_in_strips;
    struct Taken {
        Image const* image;
        int first, end; ///< rows
        std::size_t plane;
    };
    quell::Extent size{}; ///< of the images
    std::vector<Plane> planes;
    std::vector<Taken> taken;
    std::size_t used = 0; ///< planes

public:
    /// Makes memory for so many components, so that take() needs none.
    QUELL_NOINLINE void prepare(quell::Extent of_images, std::size_t components) {
        if (!(size == of_images)) planes.clear(), size = of_images;
        planes.reserve(components), taken.reserve(components);
        while (planes.size() < components) planes.emplace_back(quell::Extent{size.width, rows_of_plane});
    }
    /// Begins another strip.
    void clear() {
        used = 0;
        taken.clear();
    }
    /// Points a view at rows `first` to `end` of its image.
    template <class View> void take(View& view, int first, int end) {
        if (view.in_strips == nullptr) return;
        auto const& image = *view.in_strips;
        view.in_strips = nullptr;
        point(image, View::components, view.planes, view.row_stride(), std::max(first, 0), std::min(end, size.height));
    }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (auto const& plane : planes) sum += plane.bytes();
        return sum;
    }

private:
    QUELL_NOINLINE void point(Image const& image, int components, float** to, std::ptrdiff_t to_row, int first, int end) {
        auto const planes_of = [&](Taken const& rows) {
            for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
                to[c] = planes[rows.plane + c].view().planes[0] - rows.first * to_row;
        };
        for (auto const& each : taken)
            if (each.image == &image && each.first <= first && each.end >= end) return planes_of(each);
        taken.push_back({&image, first, end, used});
        used += static_cast<std::size_t>(components);
        planes_of(taken.back());
        take_rows(image, components, to, to_row, size.width, first, end);
    }
};

/// Strips for threads that work side by side.
class StripPool {
    std::vector<std::unique_ptr<StripOfImages>> strips;
    std::vector<StripOfImages*> idle;
    std::mutex mutex;
    std::condition_variable returned;

public:
    /// Makes what so many threads need: no memory is made on the host's own threads, which could not be told that there is none.
    QUELL_NOINLINE void prepare(int threads, quell::Extent size, std::size_t components) {
        auto const count = static_cast<std::size_t>(std::max(threads, 1));
        while (strips.size() < count) strips.push_back(std::make_unique<StripOfImages>());
        idle.clear();
        for (auto const& strip : strips) strip->prepare(size, components), idle.push_back(strip.get());
    }
    /// Calls function(strip). More threads than there are strips wait for each other.
    template <class F> void with_strip(F const& function) {
        auto& strip = take();
        function(strip);
        give_back(strip);
    }
    void release() { idle.clear(), strips.clear(); }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (auto const& each : strips) sum += each->bytes();
        return sum;
    }

private:
    QUELL_NOINLINE StripOfImages& take() {
        std::unique_lock lock(mutex);
        returned.wait(lock, [&] { return !idle.empty(); });
        auto& strip = *idle.back();
        idle.pop_back();
        return strip;
    }
    QUELL_NOINLINE void give_back(StripOfImages& strip) {
        {
            std::scoped_lock const lock(mutex);
            idle.push_back(&strip);
        }
        returned.notify_one();
    }
};

/// Calls function(view, rows) for each view of a frame's images that a job has, with how many rows above and below its own it looks at.
template <class Job, class F> void for_each_view(Job& job, F const& function) {
    auto const of_frame = [&]<class... Cs>(quell::Views<HostImages, quell::Channels<Cs...>>& views, [[maybe_unused]] int rows) {
        (function(quell::detail::slot<Cs>(views), rows), ...);
    };
    if constexpr (requires {
                      job.pass;
                      job.finish;
                  }) {
        of_frame(job.scope.frame, quell::detail::farthest_tap_of(job.pass));
        of_frame(job.finish.scope.frame, 0);
    } else if constexpr (requires { job.denoised; })
        of_frame(job.frame, 0);
    else if constexpr (requires { job.motion.in_strips; }) // what a resolve keeps of a frame: it looks at the 3x3 around
        function(job.depth, 1), function(job.motion, 1);
    else if constexpr (requires { job.frame_count; }) // a resolve reads what it has kept
        return;
    else if constexpr (requires { job.from.in_strips; })
        function(job.from, 0);
    else
        static_assert(
            requires { job.from; }, "a job reads a frame's images in members that for_each_view does not know: add them there");
}

/// The executor of compiled presets.
struct Strips {
    Parallel parallel;
    StripPool* pool; ///< for images of which rows are taken

    template <class Job> void for_each_pixel(quell::Region region, Job const& job) const {
        quell::Extent size{};
        std::size_t components = 0;
        auto copy = job;
        for_each_view(copy, [&]<class View>(View const& view, int rows) {
            if (view.in_strips == nullptr) return;
            if (rows > farthest_in_strips) looks_too_far(job.name);
            components += static_cast<std::size_t>(View::components), size = view.size;
        });
        if (components > 0) pool->prepare(parallel.threads, size, components);
        for_each_strip(parallel, region.y1 - region.y0, [&](int y0, int y1) {
            quell::Region const strip{region.x0, region.y0 + y0, region.x1, region.y0 + y1};
            if (components > 0)
                pool->with_strip([&](StripOfImages& rows) { run_on(rows, strip, job); });
            else
                run(strip, job);
        });
        if (parallel.pass_done != nullptr) parallel.pass_done(parallel.user);
    }

private:
    [[noreturn]] QUELL_NOINLINE static void looks_too_far(std::string_view pass) {
        throw std::logic_error("pass '" + std::string(pass) + "' looks farther away than the plan says");
    }
    static void run(quell::Region region, auto const& job) { quell::Outlined<>{}.for_each_pixel(region, job); }
    template <class Job> static void run_on(StripOfImages& rows, quell::Region region, Job const& job) {
        auto its_own = job;
        rows.clear();
        for_each_view(its_own, [&](auto& view, int taps) { rows.take(view, region.y0 - taps, region.y1 + taps); });
        run(region, its_own);
    }
};

/// Names of the channels of which passes look at rows too far away for strips.
[[nodiscard]] inline std::vector<std::string_view> read_from_afar(quell::Plan const& plan) {
    std::vector<std::string_view> names;
    for (auto const& pass : plan.passes)
        if (pass.farthest_tap > farthest_in_strips || pass.fraction > 1) names.insert(names.end(), pass.reads.begin(), pass.reads.end());
    return names;
}

} // namespace quell_library

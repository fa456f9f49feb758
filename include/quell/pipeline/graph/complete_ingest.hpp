#pragma once

#include <quell/execute/executor.hpp>
#include <quell/pipeline/graph/counts.hpp>

// What hangs on the ingest's counts, for a queue: the host does not know them when it enqueues the passes. A grid of threads looks at them
// on the device, and each pass takes the host's guides or the repaired copies.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A job that looks where it runs whether guides were impossible: one of two that differ in the images that they read.
template <class Job> struct LateJob {
    static constexpr auto name = Job::name;
    static constexpr bool in_squares = Job::in_squares;
    Job as_given, as_repaired; ///< with the host's guides, and with the copies
    GuideCounts const* counts; ///< of the ingest

    template <class At> QUELL_KERNEL void operator()(At at, int x, int y, int count) const {
        // Two calls: what a pass reads then lies in constants, by known addresses.
        if (read_count(counts->pixels) > 0)
            as_repaired(at, x, y, count);
        else
            as_given(at, x, y, count);
    }
};

/// Makes the copies of all guides.
template <class... Repairs> struct GuideRepairs;
template <> struct GuideRepairs<> {
    QUELL_KERNEL void for_each(auto const&) const {}
};
template <class First, class... Rest> struct GuideRepairs<First, Rest...> {
    First first;
    GuideRepairs<Rest...> rest;
    QUELL_KERNEL void for_each(auto const& visit) const {
        visit(first);
        rest.for_each(visit);
    }
};
inline GuideRepairs<> guide_repairs() { return {}; }
template <class First, class... Rest> GuideRepairs<First, Rest...> guide_repairs(First const& first, Rest const&... rest) {
    return {first, guide_repairs(rest...)};
}

/// Behind the ingest: repairs guides, runs the ingest again and fills holes, as far as its counts say that there is need. Runs in all
/// threads of a grid.
template <class IngestJob, class FillJob, class Repairs> struct IngestCompletion {
    static constexpr auto name = "completion of ingest";
    Repairs repairs;
    IngestJob again;         ///< with repaired guides
    FillJob fill, fill_back; ///< from the ingest's image to another, and back
    FrameCounts* counts;
    int changing_guide; ///< the number of the one that changes samples; -1: there is none
    long long pixels;
    bool has_past;

    QUELL_KERNEL unsigned* barrier() const { return &counts->barrier; }
    QUELL_KERNEL void operator()(auto const& for_all) const {
        if (read_count(counts->first.guides.pixels) > 0) repairs.for_each(for_all);
        bool const repeat = changing_guide >= 0 && counts->first.guides.of(changing_guide) > 0;
        if (repeat) for_all(again);
        auto const& found = repeat ? counts->again : counts->first;
        auto holes = read_count(found.holes);
        if (holes == 0) return;
        if (read_count(found.missing) == pixels) {
            if (has_past) fill_from(for_all, fill, 0, nullptr), fill_from(for_all, fill_back, 1, nullptr);
            return;
        }
        bool there = true; // in the ingest's image
        for (int step = 2, i = 0; holes > 0 && i < most_steps; step *= 2, ++i, there = !there) {
            fill_from(for_all, there ? fill : fill_back, step, &counts->filled[i]);
            holes = read_count(counts->filled[i].holes);
        }
        if (!there) fill_from(for_all, fill_back, 1, nullptr); // without holes it is a copy
    }

private:
    static constexpr int most_steps = sizeof(FrameCounts::filled) / sizeof(Counts);

    QUELL_KERNEL void fill_from(auto const& for_all, FillJob job, int step, Counts* counted) const {
        job.pass.step = step;
        job.counts = counted;
        for_all(job);
    }
};
} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

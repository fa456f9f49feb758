#pragma once

#include <quell/execute/executor.hpp>
#include <quell/pipeline/graph/counts.hpp>

// What hangs on the ingest's counts, for a queue: the host does not know them when it enqueues the passes. A grid of threads looks at them
// on the device, and passes choose between the host's guides and the repaired copies.
namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A view of the host's guide, and one of its copy, which stands in where an impossible value has been counted.
template <ChannelTag C, class View> struct LateView {
    View given, copy;
    GuideCounts const* counts; ///< null: as the host gave it

    QUELL_KERNEL View chosen() const {
        View view = given;
        if (counts && counts->of(number_of_guide<C>()) > 0) view = copy;
        return view;
    }
};
template <ChannelTag C, class View> struct LateViewOfGuide { using type = View; };
template <ChannelTag C, class View>
    requires(CopiedGuides::has<C>)
struct LateViewOfGuide<C, View> {
    using type = LateView<C, View>;
};
/// What passes in a queue hold of a channel of the host's.
template <class Storage, ChannelTag C> using LateViewOf = typename LateViewOfGuide<C, ViewOf<Storage, C>>::type;

/// Stands for a storage in Views, whose guides are then chosen where they are read.
template <class Storage> struct ChosenLate {};
} // namespace detail

/// Views of a frame for passes in a queue.
template <class Storage, class... Cs>
struct Views<detail::ChosenLate<Storage>, Channels<Cs...>> : detail::Slot<Cs, detail::LateViewOf<Storage, Cs>>... {
    using channels = Channels<Cs...>; ///< those that it has
    /// The view of a channel of the set.
    template <ChannelTag C> QUELL_KERNEL auto view(C) const {
        auto const& held = detail::slot<C>(*this);
        if constexpr (requires { held.chosen(); })
            return held.chosen();
        else
            return held;
    }
};

namespace detail {
/// Repairs a guide, if need be.
template <class Job> struct ListedRepair {
    Job job;
    int number;           ///< of CheckedGuides
    bool changes_samples; ///< whether the ingest reads it for the samples
};
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
    long long pixels;
    bool has_past;

    QUELL_KERNEL void operator()(auto const& for_all) const {
        bool repeat = false;
        repairs.for_each([&](auto const& repair) {
            if (counts->first.guides.of(repair.number) == 0) return;
            for_all(repair.job);
            repeat = repeat || repair.changes_samples;
        });
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
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

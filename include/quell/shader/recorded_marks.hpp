#pragma once

#include <quell/pipeline/graph/job_in_scope.hpp>
#include <quell/shader/recorded_images.hpp>

/// @file
/// Marks of missing samples in a signal of which only the recording tells whether it is kept in half.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// MissingMark, by RecordOptions::half_precision.
struct RecordedMark {
    using InFloats = MissingMark<true>;
    using InHalves = MissingMark<false>;

    template <bool marks = true, class V> static auto of(V const& stored) { return InFloats::of<marks>(stored); } // the same in both
    template <class V> static auto hole(V const& stored) { return in_halves() ? InHalves::hole(stored) : InFloats::hole(stored); }
    template <bool marks = true, class V> static V value(V const& stored) {
        return in_halves() ? InHalves::value<marks>(stored) : InFloats::value<marks>(stored);
    }
    template <class V> static V marked(V const& value, auto missing) {
        return in_halves() ? InHalves::marked(value, missing) : InFloats::marked(value, missing);
    }
    template <class V> static V no_value() { return InFloats::no_value<V>(); } // the same in both

private:
    static bool in_halves() { return pass_recording->half_precision; }
};
/// A scope with such marks.
template <class S> struct RecordedScope : S { using mark = RecordedMark; };

template <class View> inline constexpr bool is_half_if_asked = false;
template <int N, class Memory> inline constexpr bool is_half_if_asked<PlanarView<HalfIfAsked, N, Memory>> = true;

/// A job as it is recorded: one of run() with a scope for it.
template <class Job> Job const& recorded_job(Job const& job) { return job; }
template <class Pass, class S, class SignalView, class MadeViews, class FinishWork, class RememberedSet, bool keeps_marks>
    requires is_half_if_asked<decltype(S::signal)>
auto recorded_job(PassJob<Pass, S, SignalView, MadeViews, FinishWork, RememberedSet, keeps_marks> const& job) {
    return job_in_scope(job, RecordedScope<S>{job.scope});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

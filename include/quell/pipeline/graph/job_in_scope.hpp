#pragma once

#include <quell/pipeline/graph/job.hpp>

#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A job of run() that looks at its images through another scope: one that records what is done, for instance.
/// @tparam Other with the members that the job's own scope has
template <class Pass, class S, class SignalView, class MadeViews, class FinishWork, class RememberedSet, bool keeps_marks, class Other>
auto job_in_scope(PassJob<Pass, S, SignalView, MadeViews, FinishWork, RememberedSet, keeps_marks> const& job, Other scope) {
    return PassJob<Pass, Other, SignalView, MadeViews, FinishWork, RememberedSet, keeps_marks>{.pass = job.pass,
                                                                                               .scope = std::move(scope),
                                                                                               .signal = job.signal,
                                                                                               .made = job.made,
                                                                                               .finish = job.finish,
                                                                                               .store_signal = job.store_signal,
                                                                                               .store_output = job.store_output,
                                                                                               .store_remembered = job.store_remembered,
                                                                                               .stored_channels = job.stored_channels,
                                                                                               .counts = job.counts};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

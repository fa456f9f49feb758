#pragma once

#include <quell/pipeline/pipeline.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// In the place of a judge: the pipeline is its own.
struct OwnJudge {};

namespace detail {
/// Whether it is a pipeline with a history, and no composite.
template <class P> inline constexpr bool has_one_history = false;
template <ChannelTag S, class... Parts> inline constexpr bool has_one_history<Pipeline<S, Parts...>> = Pipeline<S, Parts...>::has_temporal;
/// Whether a judge can go on from where a pipeline is.
template <class P, class Judge> constexpr bool can_judge() {
    if constexpr (has_one_history<P> && has_one_history<Judge>)
        return std::is_same_v<typename P::Output, typename Judge::Output> && std::is_same_v<typename P::Form, typename Judge::Form> &&
               contained_in<typename Judge::keeps, typename P::keeps> && contained_in<typename Judge::carries, typename P::carries> &&
               contained_in<typename StoredChannels<typename Judge::remembers>::type, typename StoredChannels<typename P::remembers>::type>;
    else
        return false;
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

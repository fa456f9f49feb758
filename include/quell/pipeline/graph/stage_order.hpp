#pragma once

#include <quell/pipeline/pipeline.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What follows from the order of a pipeline's stages.
template <class P> class StageOrder {
    using Stages = decltype(P::stages);
    template <std::size_t i> using StageAt = std::tuple_element_t<i, Stages>;

public:
    static constexpr std::size_t count = std::tuple_size_v<Stages>;

private:
    /// Whether a stage is known to make a new signal. Of a filter of several passes only a run tells.
    template <class Stage> static constexpr bool always_makes_signal = is_temporal<Stage> || !(leaves_signal<Stage> || has_passes<Stage>);
    template <std::size_t... i> static constexpr std::size_t counted_up_to_temporal(std::index_sequence<i...>) {
        std::size_t n = 0;
        static_cast<void>(((++n, is_temporal<StageAt<i>>) || ...));
        return n;
    }
    template <std::size_t... before> static constexpr bool marked_behind(std::index_sequence<before...>) {
        return !(... || (P::has_past ? is_temporal<StageAt<before>> : always_makes_signal<StageAt<before>>));
    }
    static constexpr bool last_may_leave_signal() {
        if constexpr (count == 0)
            return true;
        else
            return !always_makes_signal<StageAt<count - 1>>;
    }

public:
    /// Number of stages up to and including Temporal; all of them without one.
    static constexpr std::size_t up_to_temporal = counted_up_to_temporal(std::make_index_sequence<count>{});
    /// Whether stage i may see marks of missing samples. Marks last until Temporal, which keeps the history there; without a Temporal,
    /// until a stage has made a new signal.
    template <std::size_t i> static constexpr bool may_be_marked = marked_behind(std::make_index_sequence<i>{});
    /// Whether the last stage may make no signal. Then an extra pass writes the output.
    static constexpr bool may_end_without_signal = last_may_leave_signal();
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

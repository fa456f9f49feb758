// error: `reads` of a policy must be `using reads = Channels<...>`
// error: `remembers` of a policy must be `using remembers = Channels<...>`
// error: `keeps` of a policy must be `using keeps = Channels<...>`
// error: `reads_kept` of a policy must be `using reads_kept = Channels<...>`
// error: `emits` of a policy must be `using emits = Channels<...>`
// error: `parts` of a policy must be `using parts = Parts<...>`
// error: `Signal` of a policy must be `using Signal = ` a channel
// error: `name` of a policy must be `static constexpr auto name =
// error: `needs_camera` of a policy must be a `static constexpr bool`
// error: `checks_jitter` of a policy must be a `static constexpr bool`
// error: `reads_past_signal` of a policy must be a `static constexpr bool`
// error: `leaves_signal` of a policy must be a `static constexpr bool`
// error: `two_rows` of a policy must be a `static constexpr bool`
// error: `max_lanes` of a policy must be a `static constexpr int`
// error: `fraction` of a policy must be a `static constexpr int`
// error: `farthest_tap` of a policy must be a `static constexpr int`
// error: `feedback` of a policy must be `constexpr bool feedback() const`
// error: `memory` of a policy must be `constexpr BlendMemory memory() const`
#include <quell/quell.hpp>

// A number of a policy that happens to have the name of something that quell looks for.
#ifdef CORRECT
#define NUMBER(hook) hook##_of_mine
#else
#define NUMBER(hook) hook
#endif
#define FILTER_WITH(hook)                                                                                                                  \
    struct Filter_##hook {                                                                                                                 \
        float NUMBER(hook) = 0.5f;                                                                                                         \
        QUELL_KERNEL auto filter(auto px) const { return quell::scale(px.signal(), NUMBER(hook)); }                                        \
    };                                                                                                                                     \
    constexpr auto with_##hook = quell::Pipeline {                                                                                         \
        quell::radiance, quell::Spatial {                                                                                                  \
            Filter_##hook {}                                                                                                               \
        }                                                                                                                                  \
    }

FILTER_WITH(reads);
FILTER_WITH(remembers);
FILTER_WITH(keeps);
FILTER_WITH(reads_kept);
FILTER_WITH(emits);
FILTER_WITH(parts);
FILTER_WITH(Signal);
FILTER_WITH(name);
FILTER_WITH(needs_camera);
FILTER_WITH(checks_jitter);
FILTER_WITH(reads_past_signal);
FILTER_WITH(leaves_signal);
FILTER_WITH(two_rows);
FILTER_WITH(max_lanes);
FILTER_WITH(fraction);
FILTER_WITH(farthest_tap);
FILTER_WITH(feedback);
FILTER_WITH(memory);

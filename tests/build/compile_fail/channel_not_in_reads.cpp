// error: a policy looks at a channel that it does not list: add the channel to its `reads`
#include <quell/quell.hpp>

struct DarkerFarAway {
#ifdef CORRECT
    using reads = quell::Channels<quell::Depth>;
#endif
    QUELL_KERNEL auto filter(auto px) const { return quell::scale(px.signal(), 1.f / px[quell::depth]); }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{DarkerFarAway{}}};

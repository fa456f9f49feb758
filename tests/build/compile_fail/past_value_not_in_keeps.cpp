// error: a policy looks at a value that is not kept: add the channel to its `keeps`
#include <quell/quell.hpp>

struct Mean {
#ifdef CORRECT
    using keeps = quell::Channels<quell::HistoryLength>;
#endif
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const n = past[quell::history_length] + 1.f;
        return quell::accumulate(px, past, 1.f / n).with(quell::history_length, n);
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, Mean{}}};

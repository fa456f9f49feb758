// error: with(channel, value): the first must be a channel, such as history_length
#include <quell/quell.hpp>

struct Mean {
    QUELL_KERNEL auto blend(auto px, auto past) const {
#ifdef CORRECT
        return quell::accumulate(px, past, 0.5f);
#else
        return quell::accumulate(px, past, 0.5f).with(0, past.validity);
#endif
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, Mean{}}};

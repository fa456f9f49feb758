// error: with(channel, value): the value must have as many components as the channel
#include <quell/quell.hpp>

struct Mean {
    using keeps = quell::Channels<quell::HistoryLength>;
    QUELL_KERNEL auto blend(auto px, auto past) const {
#ifdef CORRECT
        return quell::accumulate(px, past, 0.5f).with(quell::history_length, past[quell::history_length]);
#else
        return quell::accumulate(px, past, 0.5f).with(quell::history_length, px.signal());
#endif
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, Mean{}}};

// error: a policy does not return a channel that it `keeps` or `emits`: add .with(channel, value) to its result
#include <quell/quell.hpp>

struct Mean {
    using keeps = quell::Channels<quell::HistoryLength>;
    QUELL_KERNEL auto blend(auto px, auto past) const {
        auto const n = past[quell::history_length] + 1.f;
#ifdef CORRECT
        return quell::accumulate(px, past, 1.f / n).with(quell::history_length, n);
#else
        return quell::accumulate(px, past, 1.f / n);
#endif
    }
};

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, Mean{}}};

void denoise_one(quell::Extent size) {
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    quell::run(denoise, frame, history, quell::Serial{});
}

// error: history[channel]: no policy of this pipeline keeps that channel
#include <quell/quell.hpp>

constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{quell::SurfaceMotion{}, quell::RunningMean{}}};

float length_of_first(quell::Extent size) {
    quell::History history{size, denoise};
#ifdef CORRECT
    return history[quell::history_length].get(0, 0, 0);
#else
    return history[quell::luminance_variance].get(0, 0, 0);
#endif
}

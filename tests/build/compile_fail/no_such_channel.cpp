// error: this frame has no such channel: construct it with a pipeline that reads the channel
#include <quell/quell.hpp>

constexpr auto denoise = quell::presets::none(quell::radiance);

float first_pixel(quell::Extent size) {
    quell::Frame frame{size, denoise};
#ifdef CORRECT
    return frame[quell::radiance].get(0, 0).x;
#else
    return frame[quell::depth].get(0, 0);
#endif
}

// error: run(pipeline, frame, history): the history is another pipeline's; construct it with this pipeline
#include <quell/quell.hpp>

constexpr auto denoise = quell::presets::surface(quell::radiance);
#ifdef CORRECT
constexpr auto remembered = denoise;
#else
constexpr auto remembered = quell::presets::surface_clamp(quell::radiance);
#endif

void denoise_one(quell::Extent size) {
    quell::Frame frame{size, denoise};
    quell::History history{size, remembered};
    quell::run(denoise, frame, history, quell::Serial{});
}

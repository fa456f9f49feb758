// error: run(pipeline, frame, ...): the frame lacks a channel that the pipeline reads; construct the frame with this pipeline
#include <quell/quell.hpp>

constexpr auto first = quell::presets::none(quell::radiance);
constexpr auto second = quell::presets::surface(quell::radiance);

void denoise_one(quell::Extent size) {
#ifdef CORRECT
    quell::Frame frame{size, first, second};
#else
    quell::Frame frame{size, first};
#endif
    quell::History history{size, second};
    quell::run(second, frame, history, quell::Serial{});
}

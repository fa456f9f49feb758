// error: run_into(target, pipeline, frame, ...): the target has another number of components than the pipeline's signal
#include <quell/quell.hpp>

void denoise(quell::Planar<>::Image<1>& grey, quell::Planar<>::Image<3>& colour) {
    constexpr auto surface = quell::presets::surface(quell::radiance);
    quell::Frame frame{quell::Extent{8, 8}, surface};
    quell::History history{quell::Extent{8, 8}, surface};
    static_cast<void>(grey), static_cast<void>(colour);
#ifdef CORRECT
    quell::run_into(colour.view(), surface, frame, history, quell::Serial{});
#else
    quell::run_into(grey.view(), surface, frame, history, quell::Serial{});
#endif
}

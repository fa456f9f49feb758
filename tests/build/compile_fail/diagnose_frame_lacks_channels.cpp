// error: diagnose(frame, history): the frame lacks a channel that the history's pipeline reads; construct the frame with this pipeline
#include <quell/diagnose/diagnose.hpp>
#include <quell/quell.hpp>

constexpr auto first = quell::presets::none(quell::radiance);
constexpr auto second = quell::presets::surface(quell::radiance);

auto ask(quell::Extent size) {
#ifdef CORRECT
    quell::Frame frame{size, first, second};
#else
    quell::Frame frame{size, first};
#endif
    quell::History history{size, second};
    return quell::diagnose(frame, history);
}

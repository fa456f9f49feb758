#include <quell/presets/effects.hpp>
#include <quell/quell.hpp>

#include "sequence.hpp"

namespace emulated_cuda {
namespace {
template <int number> std::vector<Result> results() {
    constexpr auto denoise = preset<number>();
    std::vector<Result> all;
    quell::History history{{steps[0].width, steps[0].height}, denoise};
    for (auto const& step : steps) {
        quell::Frame frame{{step.width, step.height}, denoise};
        fill(frame, step);
        if (step.forgotten) history.forget();
        auto const view = quell::run(denoise, frame, history, quell::Serial{});
        all.push_back(result_of(history, view));
    }
    return all;
}
} // namespace

std::vector<Result> by_serial(int preset) {
    std::vector<Result> (*const all[])() = {results<0>, results<1>, results<2>, results<3>};
    return all[preset]();
}
} // namespace emulated_cuda

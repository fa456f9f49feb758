#include "family.hpp"

#include "cuda/scene.hpp"

#include <library/cuda/cuda_presets.hpp>
#include <library/images_of_frame.hpp>
#include <library/own_threads.hpp>

#include <chrono>
#include <ctime>
#include <map>

namespace quell::bench {
namespace {

using namespace quell_library;
using Input = Frame<Sample::channels>;

/// Frames of the world that GPUs are measured by, to be run round and round. Only those of the last size asked for are kept.
std::vector<Input> const& sequence(Extent size) {
    static std::vector<Input> made;
    if (!made.empty() && made.front().size == size) return made;
    made.clear();
    for (int i = 0; i < 2; ++i) fill_frame(made.emplace_back(size), i);
    return made;
}

/// The threads that a frame is run by, and what its passes take.
struct Running {
    How how;
    std::vector<Seconds> taken{};
    Seconds last{};
    std::map<int, OwnThreads> threads{}; ///< by their number

    static void run(void* self, std::int32_t count, void (*task)(void* context, std::int32_t index), void* context) {
        auto& running = *static_cast<Running*>(self);
        if (running.how.kind != How::Kind::threads) return run_here(nullptr, count, task, context);
        auto& own = running.threads.try_emplace(running.how.threads, running.how.threads).first->second;
        OwnThreads::run(&own, count, task, context);
    }
    static void pass_done(void* self) {
        auto& running = *static_cast<Running*>(self);
        auto const now = Seconds::now();
        running.taken.push_back(now - running.last);
        running.last = now;
    }
};

class CompiledWorkload final : public Workload {
    Extent size;
    Running running{};
    Planar<>::Image<4> out; ///< of which the first components are used
    std::unique_ptr<CompiledDenoiser> denoiser;
    std::vector<FrameImages> frames; ///< of the sequence
    std::size_t at = 0;

public:
    CompiledWorkload(Way const& way, Extent s)
        : size(s), out(s),
          denoiser(way.make(s, {.run = Running::run, .user = &running, .threads = max_threads(), .pass_done = Running::pass_done}, {})) {
        for (auto const& frame : sequence(s)) frames.push_back(images_of(way, frame));
        for (int i = 0; i < 8; ++i) next({How::Kind::threads, max_threads()}); // until histories are long
    }
    Seconds next(How how) override {
        running.taken.clear();
        auto const before = Seconds::now();
        running.how = how, running.last = before;
        denoiser->run({&frames[at], 1}, image_of_view(out.view()));
        at = (at + 1) % frames.size();
        return Seconds::now() - before;
    }
    [[nodiscard]] std::vector<Seconds> const& passes() const override { return running.taken; }
    [[nodiscard]] double bytes_per_pixel() const override {
        return static_cast<double>(denoiser->bytes()) / static_cast<double>(size.pixels());
    }
};

std::vector<std::string> pass_names(std::vector<std::string> const& passes) {
    auto names = passes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::ranges::replace(names[i], ' ', '-');
        if (std::ranges::count(passes, passes[i]) > 1)
            names[i] += "/" + std::to_string(std::count(passes.begin(), passes.begin() + static_cast<std::ptrdiff_t>(i), passes[i]));
    }
    return names;
}

/// @param presets that live as long as the program
std::vector<Family> families_of(std::vector<CompiledPreset> const& presets) {
    std::vector<Family> made;
    for (auto const& preset : presets) made.push_back({preset.name, usual_storage, pass_names(preset.usual.passes()), &preset.usual});
    return made;
}

} // namespace

Seconds Seconds::now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec)};
}

std::vector<Family> families() { return families_of(compiled_presets()); }
std::vector<Family> cuda_families() {
    auto made = families_of(cuda_presets());
    for (auto& family : made) family.storage = cuda_storage, family.passes.clear(); // one after the other, on the device
    return made;
}

Workload& workload(Family const& family, Extent size) {
    static std::unique_ptr<Workload> made;
    static std::string made_for;
    auto const wanted = family.preset + "/" + family.storage + "/" + to_string(size);
    if (made_for != wanted) {
        made_for.clear();
        made.reset();
        made = std::make_unique<CompiledWorkload>(*family.way, size);
        made_for = wanted;
    }
    return *made;
}

} // namespace quell::bench

// Compiled presets as workloads.
#include "family.hpp"
#include "sequence.hpp"

#include <library/cuda/cuda_presets.hpp>
#include <library/images_of_frame.hpp>
#include <library/name_list.hpp>
#include <library/own_threads.hpp>

#include <map>

namespace quell::bench {
namespace {

using namespace quell_library;

/// The threads that a frame is run by, and what its passes take.
struct Running {
    How how;
    std::vector<Seconds>* taken;
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
        running.taken->push_back(now - running.last);
        running.last = now;
    }
};

class CompiledWorkload final : public Workload {
    Way const& way;
    Extent size;
    Running running;
    Planar<>::Image<4> out; ///< of which the first components are used
    std::unique_ptr<CompiledDenoiser> denoiser;
    std::vector<FrameImages> frames; ///< of the sequence

public:
    CompiledWorkload(Way const& w, Extent s)
        : way(w), size(s), running{{}, &taken}, out(s),
          denoiser(way.make(s, {.run = Running::run, .user = &running, .threads = max_threads(), .pass_done = Running::pass_done}, {})) {
        for (auto const& frame : sequence(s)) frames.push_back(images_of(way, frame));
    }
    void run(std::size_t frame, How how) override {
        running.how = how, running.last = Seconds::now();
        denoiser->run({&frames[frame], 1}, image_of_view(out.view()));
    }
    [[nodiscard]] double bytes_per_pixel() const override {
        return static_cast<double>(denoiser->bytes()) / static_cast<double>(size.pixels());
    }
};

/// @param presets that live as long as the program
std::vector<Family> families_of(std::vector<CompiledPreset> const& presets) {
    std::vector<Family> made;
    for (auto const& preset : presets) {
        auto const& way = preset.usual;
        if (!is_chosen(QUELL_BENCH_PRESETS, preset.name)) continue;
        made.push_back({preset.name, reference_storage, pass_names(way.passes()),
                        [&way](Extent size) { return std::make_unique<CompiledWorkload>(way, size); }});
    }
    return made;
}

} // namespace

std::vector<Family> compiled_families() { return families_of(compiled_presets()); }
std::vector<Family> cuda_families() {
    auto made = families_of(cuda_presets());
    for (auto& family : made) family.storage = cuda_storage, family.passes.clear(); // one after the other, on the device
    return made;
}

} // namespace quell::bench

// Compiled presets as workloads.
#include "family.hpp"
#include "sequence.hpp"

#if QUELL_BENCH_TRACES
#include "traced_sequence.hpp"
#endif

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

bool has_channels(std::vector<ReadChannel> const& channels, auto set) {
    return std::ranges::all_of(channels, [&](auto const& channel) {
        bool has = false;
        for_each_channel(set, [&](auto c) { has = has || channel.name == c.name; });
        return has;
    });
}
bool reads(Way const& way, std::string_view name) {
    return std::ranges::find(way.channels, name, &ReadChannel::name) != way.channels.end();
}

class CompiledWorkload final : public Workload {
    Way const& way;
    Extent size;
    Running running;
    std::unique_ptr<CompiledDenoiser> denoiser;
    std::vector<float> out;

public:
    CompiledWorkload(Way const& w, Extent s)
        : way(w), size(s), running{{}, &taken},
          denoiser(way.make(s, {.run = Running::run, .user = &running, .threads = max_threads(), .pass_done = Running::pass_done}, {})) {}
    void run(std::size_t frame, How how) override {
        std::array const window{frame_at(frame)};
        auto const output = planes_of(out, way.output_components, size);
        running.how = how, running.last = Seconds::now();
        denoiser->run(window, output);
    }
    [[nodiscard]] double bytes_per_pixel() const override {
        return static_cast<double>(denoiser->bytes()) / static_cast<double>(size.pixels());
    }

private:
    [[nodiscard]] FrameImages frame_at(std::size_t i) const {
        if (has_channels(way.channels, Input::channels{})) return images_of(way.channels, sequence(size)[i]);
#if QUELL_BENCH_TRACES
        if (reads(way, time.name) || reads(way, sweep.name)) return images_of(way.channels, traced_sequence<true>(size)[i]);
        return images_of(way.channels, traced_sequence<false>(size)[i]);
#else
        return {};
#endif
    }
};

} // namespace

std::vector<Family> compiled_families() {
    std::vector<Family> made;
    for (std::size_t order = 0; auto const& preset : compiled_presets()) {
        auto const& way = preset.usual;
        auto const place = order++;
        if (!is_chosen(QUELL_BENCH_PRESETS, preset.name) || !(QUELL_BENCH_TRACES || has_channels(way.channels, Input::channels{})))
            continue;
        made.push_back({preset.name, place, reference_storage, pass_names(way.passes()),
                        [&way](Extent size) { return std::make_unique<CompiledWorkload>(way, size); }});
    }
    return made;
}

} // namespace quell::bench

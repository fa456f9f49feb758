#include "sequence.hpp"

#include <support/progress.hpp>
#include <tracer/gltf/gltf.hpp>
#include <tracer/reference.hpp>
#include <tracer/trace_frame.hpp>

#include <filesystem>

namespace quell::bench {
namespace {

class SceneSequence final : public FitSequence {
    tracer::PreparedScene scene;
    tracer::RenderSettings settings;

public:
    explicit SceneSequence(FitOptions const& options)
        : scene(tracer::open_scene(options.scene)), settings{.size = options.size,
                                                             .seed = options.seed,
                                                             .threads = options.threads,
                                                             .shutter = options.blur ? 0.5f : 0.f} {
        name = "scene " + std::filesystem::path(options.scene).filename().string();
        size = options.size;
        for (int i = 0; i < options.frames; ++i) numbers.push_back(i);
        for_each_channel(FitFrame::channels{}, [&](auto channel) { channels.insert(channel.name); });
        if (!options.blur) channels.erase(Sweep::name), channels.erase(Time::name);
        converge(options);
    }

    void load(long long number, FitFrame& frame) override {
        settings.frame = static_cast<int>(number);
        tracer::trace_frame(scene, settings, frame);
    }

private:
    void converge(FitOptions const& options) {
        examples::Progress bar("references", 3, !options.quiet);
        auto how = settings;
        how.seed = 0; // the same for any noise
        for (int const frame : {24, 32, 40}) {
            if (frame >= options.frames) continue;
            bar.show(static_cast<long long>(converged.size()), "frame " + std::to_string(frame));
            how.frame = frame;
            auto const reference = tracer::reference<Channels<Radiance>>(scene, how, {.tolerance = options.tolerance});
            converged.push_back({frame, metrics::displayed(reference[radiance])});
        }
    }
};

} // namespace

std::unique_ptr<FitSequence> scene_sequence(FitOptions const& options) { return std::make_unique<SceneSequence>(options); }

} // namespace quell::bench

// What guides are worth where samples of a pixel see different things: the scenes lens and pane with guides of one sample and of 16, with
// and without SteadyGuides. Prints a table in Markdown.
//     quell-noisy-guides [--size WIDTHxHEIGHT]
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/pipeline/steady_guides.hpp>
#include <quell/quell.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>
#include <tracer/reference.hpp>
#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace {

using namespace quell;

constexpr int last = 31, scored_from = 28, many = 16;
constexpr auto general = presets::general(radiance, Demodulate{});
using Reads = decltype(general)::reads;
using Pictures = std::vector<metrics::Picture>; ///< displayed

/// Frames of one sample per pixel, from 0 to `last`.
std::vector<Frame<Reads>> traced(std::string const& name, Extent size, int guide_samples) {
    tracer::PreparedScene scene(tracer::built_in_scene(name));
    std::vector<Frame<Reads>> frames;
    tracer::RenderSettings settings{.size = size, .guide_samples = guide_samples};
    for (; settings.frame <= last; ++settings.frame) tracer::trace_frame(scene, settings, frames.emplace_back(size));
    return frames;
}
Pictures references(std::string const& name, Extent size) {
    tracer::PreparedScene scene(tracer::built_in_scene(name));
    Pictures pictures;
    tracer::RenderSettings settings{.size = size, .frame = scored_from};
    for (; settings.frame <= last; ++settings.frame)
        pictures.push_back(
            metrics::displayed(tracer::reference<Channels<Radiance>>(scene, settings, {.tolerance = 0.015, .max_samples = 512})[radiance]));
    return pictures;
}

struct NoGuides {
    void apply(auto&) {}
};

/// Runs a pipeline and prints the mean errors.
void print(char const* name, auto const& denoise, std::vector<Frame<Reads>> const& frames, Pictures const& truth, auto steady,
           bool remembers = true) {
    History history{frames.front().size, denoise};
    double rmse = 0, flip = 0;
    for (int i = 0; i <= last; ++i) {
        auto frame = frames[static_cast<std::size_t>(i)];
        if (!remembers) history.forget();
        steady.apply(frame);
        auto const shown = metrics::displayed(metrics::picture_of(run(denoise, frame, history)));
        if (i < scored_from) continue;
        auto const& wanted = truth[static_cast<std::size_t>(i - scored_from)];
        rmse += metrics::rmse(wanted, shown), flip += metrics::flip(wanted, shown).mean();
    }
    auto const count = static_cast<double>(truth.size());
    std::printf("| %s | %.4f (%.4f) |\n", name, rmse / count, flip / count);
}

void measure(Extent size) {
    constexpr auto final_frame = presets::final_frame(radiance, Demodulate{});
    SteadyGuides<Channels<Depth>> const depth_alone{size};
    SteadyGuides<Channels<Depth, Albedo>> const both{size};
    for (std::string const scene : {"lens", "pane"}) {
        auto const truth = references(scene, size);
        auto const own = traced(scene, size, 0), means = traced(scene, size, many);
        std::printf("| `%s` | RMSE (FLIP) |\n| --- | --- |\n", scene.c_str());
        print("input", presets::none(radiance, Demodulate{}), own, truth, NoGuides{});
        print("`general`, guides of the one sample", general, own, truth, NoGuides{});
        print("the same, the picture as one", presets::general(radiance), own, truth, NoGuides{});
        print("the same, steady depth and albedo", general, own, truth, both);
        print("guides of 16", general, means, truth, NoGuides{});
        print("guides of 16, without history", general, means, truth, NoGuides{}, false);
        print("guides of 16, steady depth", general, means, truth, depth_alone);
        print("`final-frame`, guides of the one sample", final_frame, own, truth, NoGuides{});
        print("`final-frame`, guides of 16", final_frame, means, truth, NoGuides{});
        print("`final-frame`, guides of 16, steady depth", final_frame, means, truth, depth_alone);
    }
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-noisy-guides", [&] {
        CLI::App app("What guides are worth where samples of a pixel see different things: a table in Markdown.", "quell-noisy-guides");
        std::string size = "160x90";
        app.add_option("--size", size, "Width x height in pixels")->capture_default_str();
        if (examples::parse(app, argc, argv)) measure(examples::size_in(size, 1, 1LL << 20)); // 64 frames are kept
    });
}

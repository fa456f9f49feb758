// How a picture of quell-denoise changes with each share of residual feedback, which bench/fit_feedback.py fits shares by.
//     quell-feedback-slopes 'dir/frame_%04d.exr' SAMPLES FRAMES OUT
// denoises FRAMES (a list, as of quell-denoise) as quell-denoise does, once with the shares for SAMPLES and once more for each share, with
// that share larger by a little. Writes OUT/slopes.0037.exr with the picture R, G and B, and the change by a share as wide.R and so on.
#include <denoise/frame_list.hpp>
#include <denoise/presets.hpp>
#include <denoise/sequence_denoiser.hpp>
#include <quell/io/write_exr.hpp>
#include <quell/resolve/residual_feedback_fit.hpp>
#include <support/program.hpp>

#include <charconv>
#include <filesystem>
#include <string_view>

namespace {

using namespace quell;
using namespace quell::examples;

/// Small enough for limits not to matter, large enough for float.
constexpr float larger_by = 0.05f;

std::vector<metrics::Picture> denoised(FramePattern const& in, std::vector<long long> const& frames, ResidualFeedbackShares const& shares) {
    auto const& preset = preset_of("final-frame");
    SequenceDenoiser denoiser({.preset = preset,
                               .later_frames = usual_later_frames,
                               .anti_aliases = true,
                               .refines = true,
                               .chooses_history = true,
                               .feedback = shares});
    std::vector<metrics::Picture> pictures;
    auto const steps = steps_for(frames, {preset.warm_up + 1, true}, in.on_disk());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].begins) denoiser.forget();
        if (steps[i].is_written)
            pictures.push_back(denoiser.next(in, steps[i].number));
        else // the picture before a wanted one takes part in it
            denoiser.warm_up(in, steps[i].number, i + 1 < steps.size() && steps[i + 1].is_written);
    }
    return pictures;
}

void add_planes(io::ExrImage& image, std::string const& prefix, metrics::Picture const& picture) {
    for (int c = 0; c < 3; ++c) {
        auto& plane = image.planes.emplace_back();
        plane.name = prefix + "RGB"[c];
        for (auto const& pixel : picture.pixels) plane.values.push_back(pixel[c]);
    }
}

float samples_in(std::string_view text) {
    float samples = 0;
    if (auto const [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), samples);
        wrong != std::errc{} || end != text.data() + text.size() || !(samples >= 1.f))
        throw Error("SAMPLES '" + std::string(text) + "'", "no number from 1 on", "give how many samples a pixel has");
    return samples;
}

void write_slopes(int argc, char** argv) {
    if (argc != 5)
        throw Error("arguments", std::to_string(argc - 1), "give the frames' pattern, their samples, which frames, and a folder");
    FramePattern const in(argv[1]);
    auto const today = ResidualFeedbackShares::of_samples(samples_in(argv[2]));
    auto const frames = frames_in(argv[3]);
    std::filesystem::path const out(argv[4]);
    auto const pictures = denoised(in, frames, today);
    std::vector<io::ExrImage> images(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) images[i].size = pictures[i].size, add_planes(images[i], "", pictures[i]);
    for (auto const& [name, share] : feedback_shares) {
        auto more = today;
        more.*share += larger_by;
        auto changed = denoised(in, frames, more);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            for (std::size_t k = 0; k < changed[i].pixels.size(); ++k)
                changed[i].pixels[k] = (changed[i].pixels[k] - pictures[i].pixels[k]) / larger_by;
            add_planes(images[i], std::string(name) + ".", changed[i]);
        }
    }
    std::filesystem::create_directories(out); // at the end: a folder that is there is whole
    for (std::size_t i = 0; i < frames.size(); ++i) io::write_exr(out / frame_file_name("slopes", frames[i], "exr"), images[i]);
}

} // namespace

int main(int argc, char** argv) {
    return exit_code_of("quell-feedback-slopes", [&] { write_slopes(argc, argv); });
}

#include <denoise/history_choice.hpp>
#include <denoise/light_split.hpp>
#include <denoise/presets.hpp>

#include <quell/resolve/evidence.hpp>

#include <utility>

namespace quell::examples {

namespace {
Preset const& judge_of(Preset const& preset) {
    auto const* const general = find_preset("general");
    return general != nullptr ? *general : preset;
}
} // namespace

HistoryChoice::HistoryChoice(Preset const& preset, Purpose purpose, Extent size, int threads)
    : alone(way_of(preset, purpose), size, threads), judge(way_of(judge_of(preset), purpose), size, threads) {}

ChosenLight HistoryChoice::choose(Denoiser const& with, io::ExrImage const& image, io::ChannelNames const& names, long long number,
                                  HistoryContents const& before, metrics::Picture const& with_history) {
    Evidence const rule{};
    auto const samples = picture_of(image, io::sources_of(names, radiance), 0.f);
    auto const by_itself = [&](Denoiser& denoiser, int left_out) {
        denoiser.forget();
        return denoiser.estimate(image, names, number, left_out, nullptr);
    };
    auto const after_the_past = [&](int left_out) {
        judge.remember(before);
        return judge.estimate(image, names, number, left_out, &with).pixels;
    };
    constexpr int none = -1;
    auto const with_sample = by_itself(judge, none);
    auto const parts = parts_by_evidence(rule, image.size, samples.pixels, with_sample.pixels, after_the_past,
                                         [&](int left_out) { return by_itself(judge, left_out).pixels; });
    auto by_frame = by_itself(alone, none);
    auto result = by_frame;
    for (std::size_t i = 0; i < parts.size(); ++i) result.pixels[i] += (with_history.pixels[i] - result.pixels[i]) * parts[i];
    return {std::move(result), std::move(by_frame)};
}

} // namespace quell::examples

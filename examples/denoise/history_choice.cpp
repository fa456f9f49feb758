#include <denoise/history_choice.hpp>
#include <denoise/light_split.hpp>
#include <denoise/presets.hpp>

#include <quell/resolve/evidence.hpp>

namespace quell::examples {

namespace {
Preset const& judge_of(Preset const& preset) {
    auto const* const general = find_preset("general");
    return general != nullptr ? *general : preset;
}
} // namespace

HistoryChoice::HistoryChoice(Preset const& preset, Purpose purpose, Extent size, int threads)
    : alone(way_of(preset, purpose), size, threads), judge(way_of(judge_of(preset), purpose), size, threads) {}

metrics::Picture HistoryChoice::choose(Denoiser const& with, io::ExrImage const& image, io::ChannelNames const& names, long long number,
                                       HistoryContents const& before, metrics::Picture const& with_history) {
    Evidence const rule{};
    EvidenceSums sums(image.size);
    auto const samples = picture_of(image, io::sources_of(names, radiance), 0.f);
    auto const by_itself = [&](Denoiser& denoiser, int left_out) {
        denoiser.forget();
        return denoiser.estimate(image, names, number, left_out, nullptr);
    };
    constexpr int none = -1;
    auto const with_sample = by_itself(judge, none);
    for (int const left_out : {0, 1}) {
        judge.remember(before);
        auto const a = judge.estimate(image, names, number, left_out, &with);
        auto const b = by_itself(judge, left_out);
        for (int y = 0, i = 0; y < image.size.height; ++y)
            for (int x = 0; x < image.size.width; ++x, ++i) {
                if ((x + y) % 2 != left_out) continue;
                auto const at = static_cast<std::size_t>(i);
                sums.add(rule, at, samples.pixels[at], a.pixels[at], b.pixels[at], with_sample.pixels[at]);
            }
    }
    auto result = by_itself(alone, none);
    auto const parts = sums.parts(rule);
    for (std::size_t i = 0; i < parts.size(); ++i) result.pixels[i] += (with_history.pixels[i] - result.pixels[i]) * parts[i];
    return result;
}

} // namespace quell::examples

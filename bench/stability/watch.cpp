#include "watch.hpp"

#include <quell/core/real.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>

#include <algorithm>
#include <numeric>

namespace quell::stability {

Pictures watch(examples::Preset const& preset, ScoredSequence const& sequence, Memory memory, int threads) {
    auto const denoiser = examples::denoiser_of(preset, sequence.size, threads);
    Pictures pictures;
    for (int i = sequence.first; i <= sequence.last(); ++i) {
        auto picture = denoiser->denoise(sequence.frame(i), {}, memory.number(i));
        if (i >= sequence.scored_from) pictures.push_back(std::move(picture));
    }
    return pictures;
}

FrameErrors errors(ScoredSequence const& sequence, Pictures const& pictures) {
    FrameErrors result;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        int const number = sequence.scored_from + static_cast<int>(i);
        auto const mask = sequence.mask(number);
        if (!mask.empty() && std::ranges::none_of(mask, [](auto m) { return m != 0; })) continue;
        auto const wanted = metrics::displayed(sequence.reference(number)), shown = metrics::displayed(pictures[i]);
        result.frames.push_back(number);
        result.rmse.push_back(metrics::rmse(wanted, shown, mask));
        result.flip.push_back(metrics::flip(wanted, shown).mean(mask));
    }
    return result;
}

void record(Results& results, std::string const& subject, std::string const& method, FrameErrors const& errors) {
    for (std::size_t i = 0; i < errors.frames.size(); ++i)
        results.frames.push_back({subject, method, errors.frames[i], errors.rmse[i], errors.flip[i]});
}

void record(Results& results, std::string const& subject, std::string const& method, int frame, metrics::Picture const& wanted,
            metrics::Picture const& shown) {
    auto const finite = [](glm::vec3 const& p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); };
    if (!std::ranges::all_of(shown.pixels, finite)) return;
    auto const truth = metrics::displayed(wanted), picture = metrics::displayed(shown);
    results.frames.push_back({subject, method, frame, metrics::rmse(truth, picture), metrics::flip(truth, picture).mean()});
}

double worst_ratio(FrameErrors const& a, FrameErrors const& b, int from) {
    double worst = 0;
    for (std::size_t i = 0; i < a.frames.size(); ++i)
        if (a.frames[i] >= from) worst = std::max(worst, a.rmse[i] / b.rmse[i]);
    return worst;
}

double mean_ratio(FrameErrors const& a, FrameErrors const& b) {
    return std::accumulate(a.rmse.begin(), a.rmse.end(), 0.) / std::accumulate(b.rmse.begin(), b.rmse.end(), 0.);
}

} // namespace quell::stability

#include "watch.hpp"

#include <quell/core/real.hpp>

#include <algorithm>
#include <numeric>

namespace quell::stability {

Pictures watch(examples::Preset const& preset, ScoredSequence const& sequence, Memory memory, int threads) {
    auto const denoiser = examples::denoiser_of(preset, sequence.size, threads);
    Pictures pictures;
    for (int i = sequence.first; i <= sequence.last(); ++i) {
        metrics::Picture picture = denoiser->denoise(sequence.frame(i), {}, memory.number(i));
        if (i >= sequence.scored_from) pictures.push_back(std::move(picture));
    }
    return pictures;
}

namespace {

metrics::Errors errors_of(metrics::Picture const& wanted, metrics::Picture const& shown, metrics::Mask const& mask = {}) {
    auto const truth = metrics::displayed(wanted), picture = metrics::displayed(shown);
    return metrics::errors_of({truth, picture}, mask);
}

} // namespace

FrameErrors record(Results& results, std::string const& subject, std::string const& method, ScoredSequence const& sequence,
                   Pictures const& pictures) {
    FrameErrors errors;
    for (int number = sequence.scored_from; auto const& picture : pictures) {
        auto const mask = sequence.mask(number);
        if (mask.empty() || std::ranges::any_of(mask, [](auto m) { return m != 0; }))
            errors.push_back({subject, method, number, errors_of(sequence.reference(number), picture, mask)});
        ++number;
    }
    results.frames.insert(results.frames.end(), errors.begin(), errors.end());
    return errors;
}

FrameErrors record(Results& results, std::string const& subject, examples::Preset const& preset, ScoredSequence const& sequence,
                   int threads) {
    return record(results, subject, preset.name, sequence, watch(preset, sequence, {}, threads));
}

void record(FrameErrors& errors, std::string const& subject, std::string const& method, int frame, metrics::Picture const& wanted,
            metrics::Picture const& shown) {
    auto const finite = [](glm::vec3 const& p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); };
    if (std::ranges::all_of(shown.pixels, finite)) errors.push_back({subject, method, frame, errors_of(wanted, shown)});
}

double worst_ratio(FrameErrors const& a, FrameErrors const& b, int from) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].frame >= from) worst = std::max(worst, a[i].errors["rmse"] / b[i].errors["rmse"]);
    return worst;
}

double mean_ratio(FrameErrors const& a, FrameErrors const& b) {
    auto const sum = [](FrameErrors const& errors) {
        return std::accumulate(errors.begin(), errors.end(), 0., [](double s, FrameError const& e) { return s + e.errors["rmse"]; });
    };
    return sum(a) / sum(b);
}

} // namespace quell::stability

#include <denoise/summary.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace quell::examples {

namespace {
using Json = nlohmann::ordered_json;

Json with_errors(Json json, metrics::Errors const& errors) {
    errors.for_each([&](auto const& metric, double value) { json[std::string(metric.name)] = value; });
    return json;
}

/// Adds the members "scores" and "mean", where there are any.
void add_scores(Json& json, FrameScores const& scores) {
    if (scores.empty()) return;
    metrics::MeanErrors mean;
    auto& rows = json["scores"] = Json::array();
    for (auto const& [frame, errors] : scores) {
        rows.push_back(with_errors({{"frame", frame}}, errors));
        mean.add(errors);
    }
    json["mean"] = with_errors({}, mean.mean());
}
} // namespace

std::string json_of(Summary const& summary) {
    Json json{{"preset", summary.preset},
              {"preset_reason", summary.preset_reason},
              {"signal", summary.signal},
              {"renderer", summary.renderer},
              {"written", summary.written},
              {"skipped", summary.skipped},
              {"warm_up_frames", summary.warm_up_frames},
              {"missing_samples", summary.missing_samples},
              {"size", {summary.size.width, summary.size.height}},
              {"upsampled_by", summary.upsampled_by},
              {"milliseconds", summary.milliseconds},
              {"bytes_per_pixel", summary.bytes_per_pixel},
              {"layout_changes", summary.layout_changes},
              {"findings", summary.findings},
              {"not_checked", summary.not_checked},
              {"remarks", summary.remarks}};
    if (!summary.why.empty()) json["why"] = summary.why;
    add_scores(json, summary.scores);
    for (auto const& view : summary.views) {
        Json row{{"name", view.name}};
        add_scores(row, view.scores);
        json["views"].push_back(row);
    }
    if (summary.error) json["error"] = *summary.error;
    // File names may have any bytes.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void say(Summary const& summary) {
    if (!summary.preset_reason.empty())
        std::fprintf(stderr, "quell-denoise: preset %s, since %s\n", summary.preset.c_str(), summary.preset_reason.c_str());
    for (auto const& remark : summary.remarks) std::fprintf(stderr, "quell-denoise: %s\n", remark.c_str());
    if (!summary.skipped.empty()) std::fprintf(stderr, "quell-denoise: %zu skipped, since their output is there\n", summary.skipped.size());
    auto const frames = summary.written.size();
    auto const of = summary.renderer.empty() ? std::string() : " of " + summary.renderer;
    std::fprintf(stderr, "quell-denoise: %zu %s%s; %lld %s missing (not finite, or negative)\n", frames, frames == 1 ? "frame" : "frames",
                 of.c_str(), summary.missing_samples, summary.missing_samples == 1 ? "sample was" : "samples were");
}

} // namespace quell::examples

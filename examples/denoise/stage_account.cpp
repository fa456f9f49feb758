#include <denoise/stage_account.hpp>
#include <support/csv.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

constexpr std::array<StageLook, stage_count> looks{
    {{"samples", "of the number of samples that files say is believed", "none", {0, 0, 0}},
     {"evidence", "of the light is what the frame alone has", "blue", {.2f, .4f, 1}},
     {"light", "of the light came back or went", "green", {.1f, .9f, .2f}},
     {"colours", "of the light was changed by colours of frames around", "yellow", {1, .9f, .1f}},
     {"guide noise", "of the light was taken off as noise of guides", "magenta", {1, .2f, 1}},
     {"repeated light", "of the light came back or went by what frames in a row lack", "cyan", {.1f, .9f, 1}}}};
constexpr glm::vec3 colour_of_refused{1, 0, 0};

constexpr double noticeable = .45; ///< part that a stage refuses, in the mean over frames

float brightness(glm::vec3 const& light) { return luminance(glm::abs(light)); }
float at(std::vector<float> const& plane, std::size_t pixel) { return pixel < plane.size() ? plane[pixel] : 0.f; }

} // namespace

StageLook const& look_of(Stage stage) { return looks[static_cast<std::size_t>(stage)]; }

std::string legend_of_stages() {
    std::string text;
    for (auto const& look : looks)
        if (look.colour != glm::vec3(0.f)) text += fmt::format("{} {}, ", look.colour_name, look.name);
    return text + "red what a stage refused";
}

void StageAccount::add_samples(int said, int believed) {
    StageRow row{"picture", Stage::samples};
    if (said < 1)
        row.reason = "the file does not say how many samples a pixel has";
    else
        row.share = static_cast<double>(std::min(said, believed)) / std::max({said, believed, 1});
    if (said > 0 && said != believed) {
        row.refused = 1. - row.share, row.is_broken = true;
        row.reason = fmt::format("the file says {} samples a pixel, its noise is that of {}", said, believed);
    }
    add(std::move(row));
}

double StageAccount::changed(Stage stage, LinearView const& before, LinearView const& after, LinearView const& factor) {
    if (!gathers) return 0.;
    auto& plane = changes[static_cast<std::size_t>(stage)];
    plane.resize(after.pixels());
    double change = 0, light = 0;
    for (std::size_t i = 0; i < after.pixels(); ++i) {
        auto const times = factor.empty() ? glm::vec3(1.f) : factor[i];
        auto const off = (after[i] - before[i]) * times, here = after[i] * times;
        if (!all_finite(off) || !all_finite(here)) continue;
        plane[i] += brightness(off);
        change += static_cast<double>(brightness(off)), light += static_cast<double>(brightness(here));
    }
    return light > 0. ? std::min(change / light, 1.) : 0.;
}

double StageAccount::chosen(LinearView const& with_history, LinearView const& alone, LinearView const& light, LinearView const& factor) {
    changed(Stage::history, with_history, light, factor);
    double sum = 0, known = 0;
    for (std::size_t i = 0; i < light.pixels(); ++i) {
        auto const off = alone[i] - with_history[i];
        float const square = glm::dot(off, off), part = glm::dot(light[i] - with_history[i], off) / square;
        if (square > 0.f && is_finite(part)) sum += static_cast<double>(std::clamp(part, 0.f, 1.f)), known += 1.;
    }
    return known > 0. ? sum / known : 0.;
}

void StageAccount::add_feedback(std::string const& signal, double share, std::optional<float> trust) {
    if (!trust) return add({signal, Stage::feedback, 0, 1, "the file has no normals or no depth"});
    double const refused = 1. - static_cast<double>(*trust);
    add({signal, Stage::feedback, share, refused, refused > 0. ? noise_is_shared : "", refused > 0.});
}

void StageAccount::refused(std::vector<float> const& parts) {
    if (!gathers) return;
    refusals.resize(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) refusals[i] = std::max(refusals[i], parts[i]);
}

void StageAccount::finish(LinearView const& picture, std::string const& reason) {
    for (std::size_t s = 0; s < stage_count; ++s)
        if (std::ranges::none_of(all, [=](auto const& row) { return static_cast<std::size_t>(row.stage) == s; }))
            add({"picture", static_cast<Stage>(s), 0, 0, reason});
    if (!gathers) return;
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels(); ++i) sum += all_finite(picture[i]) ? static_cast<double>(brightness(picture[i])) : 0.;
    auto const mean = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(picture.pixels(), 1)));
    shown.size = picture.size, shown.pixels.clear();
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        std::size_t most = 0;
        for (std::size_t s = 1; s < stage_count; ++s)
            if (at(changes[s], i) > at(changes[most], i)) most = s;
        float const light = (all_finite(picture[i]) ? brightness(picture[i]) : 0.f) + .1f * mean;
        float const change = at(changes[most], i), bright = change > 0.f ? std::sqrt(std::min(change / light, 1.f)) : 0.f;
        float const part = std::clamp(at(refusals, i), 0.f, 1.f);
        shown.pixels.push_back(glm::clamp(looks[most].colour * (bright * (1.f - part)) + colour_of_refused * part, 0.f, 1.f));
    }
}

std::string StageAccount::table(std::string const& view) const {
    std::string text;
    for (auto const& row : all)
        text += fmt::format("{},{},{},{:.4f},{:.4f},{}\n", csv_cell(view), csv_cell(row.signal), look_of(row.stage).name, row.share,
                            row.refused, csv_cell(row.reason));
    return text;
}

void StageTotals::add(std::string const& view, StageAccount const& account) {
    for (auto const& row : account.rows()) {
        auto const is_same = [&](Total const& t) { return t.view == view && t.row.signal == row.signal && t.row.stage == row.stage; };
        auto total = std::ranges::find_if(totals, is_same);
        if (total == totals.end()) total = totals.insert(total, {view, {row.signal, row.stage}});
        total->row.share += row.share, total->row.refused += row.refused, ++total->frames;
        if (!row.reason.empty()) total->row.reason = row.reason;
        total->row.is_broken = total->row.is_broken || row.is_broken;
    }
}

std::vector<std::string> StageTotals::sentences() const {
    std::vector<std::string> lines;
    for (auto const& [view, row, frames] : totals) {
        auto const percent = [count = frames](double sum) { return 100. * sum / count; };
        auto line = fmt::format("{}{}, {}: {:.2f} % {}", view.empty() ? "" : "view " + view + ", ", look_of(row.stage).name, row.signal,
                                percent(row.share), look_of(row.stage).of_share);
        if (row.refused > 0.) line += fmt::format(", {:.2f} % refused", percent(row.refused));
        lines.push_back(line + (row.reason.empty() ? "" : " (" + row.reason + ")"));
    }
    return lines;
}

std::vector<std::string> StageTotals::remarks() const {
    std::vector<std::string> lines;
    for (std::string const reason : {"", noise_is_shared, colours_differ, noise_is_the_same}) {
        double most = 0;
        std::string said = reason;
        for (auto const& [view, row, frames] : totals) {
            bool const is_this = reason.empty() ? row.stage == Stage::samples : row.reason == reason;
            if (!is_this || !row.is_broken || row.refused / frames <= most) continue;
            most = row.refused / frames, said = row.reason;
        }
        if (most < noticeable) continue;
        lines.push_back(reason.empty()
                            ? said + ", which is believed (--why)"
                            : fmt::format("{}: {:.0f} % of what a stage does by that is left out; --why shows where", said, 100. * most));
    }
    return lines;
}

} // namespace quell::examples

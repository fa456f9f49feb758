#include <denoise/converted_history.hpp>

#include <quell/core/value.hpp>
#include <quell/frame/kept_channels.hpp>

#include <algorithm>

namespace quell::examples {

namespace {

/// Converted histories count as no more frames than that: their colours are from a single frame.
constexpr float longest = 4.f;
/// Of a colour that light is divided by.
constexpr float darkest = 0.02f;

std::vector<float>* plane(HistoryContents& contents, std::string_view channel) {
    auto const found = contents.kept.find(channel);
    return found == contents.kept.end() ? nullptr : &found->second[0];
}

/// Multiplies the light of each pixel by factor(pixel).
void multiply(HistoryContents& contents, auto const& factor) {
    auto* const mean = plane(contents, luminance_mean.name);
    auto* const variance = plane(contents, luminance_variance.name);
    auto* const length = plane(contents, history_length.name);
    for (std::size_t i = 0; i < contents.signal[0].size(); ++i) {
        glm::vec3 const f = factor(i);
        for (std::size_t c = 0; c < 3; ++c) contents.signal[c][i] *= f[static_cast<glm::length_t>(c)];
        float const bright = luminance(f);
        if (mean) (*mean)[i] *= bright;
        if (variance) (*variance)[i] *= bright * bright;
        if (length) (*length)[i] = std::min((*length)[i], longest);
    }
}

void add(std::vector<float>& sum, std::vector<float> const& more) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

} // namespace

std::optional<HistoryContents> whole_history(std::vector<std::optional<HistoryContents>> const& parts, SignalShares const& shares,
                                             std::vector<float> const& alpha) {
    std::optional<HistoryContents> whole;
    for (std::size_t s = 0; s < parts.size(); ++s) {
        if (!parts[s]) continue;
        auto part = *parts[s];
        multiply(part, [&](std::size_t i) { return shares.colours[s][i]; });
        if (!whole) {
            whole = std::move(part);
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) add(whole->signal[c], part.signal[c]);
        for (auto const name : {std::string_view(luminance_mean.name), std::string_view(luminance_variance.name)})
            if (auto* const sum = plane(*whole, name)) add(*sum, *plane(part, name));
        if (auto* const length = plane(*whole, history_length.name))
            for (std::size_t i = 0; i < length->size(); ++i) (*length)[i] = std::min((*length)[i], (*plane(part, history_length.name))[i]);
    }
    if (!whole) return whole;
    for (std::size_t i = 0; i < shares.added.pixels(); ++i)
        for (int c = 0; c < 3; ++c) whole->signal[static_cast<std::size_t>(c)][i] += shares.added.at(c, i);
    if (alpha.size() == whole->signal[0].size()) whole->signal.resize(4), whole->signal[3] = alpha;
    return whole;
}

HistoryContents part_of_history(HistoryContents whole, SignalShares const& shares, std::size_t signal) {
    multiply(whole, [&](std::size_t i) {
        auto const share = shares.shares[signal][i], colour = shares.colours[signal][i];
        return share / glm::vec3(std::max(colour.x, darkest), std::max(colour.y, darkest), std::max(colour.z, darkest));
    });
    if (whole.signal.size() == 4)
        for (std::size_t i = 0; i < whole.signal[3].size(); ++i) whole.signal[3][i] *= luminance(shares.shares[signal][i]);
    return whole;
}

} // namespace quell::examples

#include <denoise/composite.hpp>
#include <denoise/guide_images.hpp>
#include <denoise/picture_refiner.hpp>
#include <denoise/repeated_detail.hpp>

#include <quell/core/light.hpp>
#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <limits>

namespace quell::examples {

namespace {

/// Where a frame's surfaces are in another one; nothing where the file doesn't say.
template <class Channel> std::optional<Frame<Channels<Channel>>> vectors_of(SeenFrame const& seen, io::ChannelNames const& names) {
    if (!seen.image.has_all(io::planes_of(Channels<Channel>{}, names))) return std::nullopt;
    std::optional<Frame<Channels<Channel>>> vectors(std::in_place, seen.image.size);
    load_guides(Channels<Channel>{}, *vectors, seen.image, names);
    return vectors;
}

/// What noisy guides add to the picture in their finest detail. It goes by the file and by the picture as one, so that it is the same in
/// frames that are denoised for those after them.
metrics::Picture detail_in(RepeatedDetail const& rule, SeenFrame const& seen, LightSplit const& light, metrics::Picture const& as_one) {
    auto const& colours = seen.around->colours;
    auto const signals = colours.size() - 1;
    metrics::Picture detail{seen.image.size, std::vector<glm::vec3>(as_one.pixels.size(), glm::vec3(0.f))};
    auto const add = [&](metrics::Picture const& part) {
        for (std::size_t i = 0; i < detail.pixels.size(); ++i) detail.pixels[i] += part.pixels[i];
    };
    for (std::size_t s = 0; s < signals; ++s) {
        if (colours[s].pixels.empty() || !light.active[s]) continue;
        auto product = light_of(seen.image, light.signals[s]);
        for (std::size_t i = 0; i < product.pixels.size(); ++i) product.pixels[i] *= colours[s].pixels[i];
        limit_detail(rule, as_one, product); // of few bright samples
        add(detail_of_colour(rule, colours[s], product));
    }
    if (!colours[signals].pixels.empty()) add(finest_detail(rule, colours[signals]));
    limit_detail(rule, as_one, detail);
    return detail;
}

/// Adds to each signal its share of what is added to a pixel of the picture: that of the light. Where there is none, the rest takes it.
void add_to_signals(DenoisedFrame& frame, std::size_t pixel, glm::vec3 const& change) {
    for (int c = 0; c < 3; ++c) {
        float sum = 0.f;
        for (auto const& signal : frame.signals) sum += std::max(signal.pixels[pixel][c], 0.f);
        if (!(sum > 0.f) || !is_finite(sum)) {
            frame.signals.back().pixels[pixel][c] += change[c];
            continue;
        }
        for (auto& signal : frame.signals)
            if (float& part = signal.pixels[pixel][c]; part > 0.f) part += change[c] * (part / sum);
    }
}

} // namespace

void PictureRefiner::take_off_noise_of_guides(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light,
                                              metrics::Picture const& as_one, DenoisedFrame& frame) {
    auto const vectors = vectors_of<Motion>(seen, names);
    if (!vectors) return;
    RepeatedDetail const rule;
    auto guides = detail_in(rule, seen, light, as_one);
    bool const follows = detail_before && detail_before->first + 1 == seen.number;
    auto const shares =
        repeated_share(rule, guides, as_one, (*vectors)[motion].view(), follows ? detail_before->second : metrics::Picture{});
    auto difference = frame.picture;
    for (std::size_t i = 0; i < difference.pixels.size(); ++i) difference.pixels[i] -= as_one.pixels[i];
    auto const detail = finest_detail(rule, std::move(difference));
    auto const theirs = share_of_guides(rule, detail, guides, as_one);
    for (std::size_t i = 0; i < frame.picture.pixels.size(); ++i) {
        auto const noise = theirs[i] * (1.f - shares[i]) * detail.pixels[i];
        frame.picture.pixels[i] -= noise, add_to_signals(frame, i, -noise);
    }
    detail_before.emplace(seen.number, std::move(guides));
}

metrics::Picture samples_of_picture(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light) {
    if (!seen.image.has_all(io::planes_of(Channels<Motion>{}, names))) return {};
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    std::vector<bool> is_missing(seen.image.pixels());
    auto const samples_of = [&](std::size_t s) {
        auto samples = light_of(seen.image, light.signals[s], none);
        for (std::size_t i = 0; i < is_missing.size(); ++i)
            is_missing[i] = is_missing[i] || !quell::detail::is_light(vec3<float>(samples.pixels[i]));
        return samples;
    };
    long long not_finite = 0;
    std::vector<metrics::Picture> parts;
    auto samples = composite(seen.image, light, samples_of, not_finite, parts);
    for (std::size_t i = 0; i < is_missing.size(); ++i)
        if (is_missing[i]) samples.pixels[i] = glm::vec3(none);
    return samples;
}

void change_signals(DenoisedFrame& frame, std::vector<glm::vec3> const& before) {
    for (std::size_t i = 0; i < before.size(); ++i) add_to_signals(frame, i, frame.picture.pixels[i] - before[i]);
}

} // namespace quell::examples

#include <denoise/composite.hpp>
#include <denoise/picture_refiner.hpp>
#include <denoise/repeated_detail.hpp>

#include <quell/core/light.hpp>
#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <limits>

namespace quell::examples {

namespace {

/// What noisy guides add to the picture in their finest detail. It goes by the file and by the picture as one, so that it is the same in
/// frames that are denoised for those after them.
LinearPicture detail_in(RepeatedDetail const& rule, SeenFrame const& seen, io::SequenceNames const& names, LightSplit const& light,
                        LinearView const& as_one) {
    LinearPicture detail(seen.image.size);
    auto const add = [&](LinearPicture const& part) {
        for (std::size_t k = 0; k < detail.values.size(); ++k) detail.values[k] += part.values[k];
    };
    for (std::size_t s = 0; s < names.of_signals.size(); ++s) {
        if (names.of_signals[s].factor.empty() || !light.active[s]) continue;
        auto const colour = picture_of(seen.image, names.of_signals[s].factor, 1.f);
        auto const samples = light_of(seen.image, light.signals[s]);
        auto product = samples.in_place();
        for (std::size_t i = 0; i < product.pixels(); ++i) product[i] = samples[i] * colour[i];
        limit_detail(rule, as_one, product); // of few bright samples
        add(detail_of_colour(rule, colour, product));
    }
    if (!names.added.empty()) add(finest_detail(rule, picture_of(seen.image, names.added, 0.f)));
    limit_detail(rule, as_one, detail);
    return detail;
}

/// Adds to each signal its share of what is added to a pixel of the picture: that of the light. Where there is none, the rest takes it.
void add_to_signals(DenoisedFrame& frame, std::size_t pixel, glm::vec3 const& change) {
    for (int c = 0; c < 3; ++c) {
        float sum = 0.f;
        for (auto const& signal : frame.signals) sum += std::max(signal.at(c, pixel), 0.f);
        if (!(sum > 0.f) || !is_finite(sum)) {
            frame.signals.back().at(c, pixel) += change[c];
            continue;
        }
        for (auto& signal : frame.signals)
            if (float& part = signal.at(c, pixel); part > 0.f) part += change[c] * (part / sum);
    }
}

} // namespace

void PictureRefiner::take_off_noise_of_guides(SeenFrame& seen, io::ChannelNames const& guide_names, io::SequenceNames const& names,
                                              LightSplit const& light, LinearView const& as_one, DenoisedFrame& frame) {
    auto const vectors = seen.guide(motion, guide_names);
    if (!vectors) return;
    RepeatedDetail const rule;
    auto guides = detail_in(rule, seen, names, light, as_one);
    bool const follows = detail_before && detail_before->first + 1 == seen.number;
    auto const shares = repeated_share(rule, guides, as_one, vectors->view(motion), follows ? detail_before->second.view() : LinearView{});
    LinearPicture difference(as_one.size);
    for (std::size_t i = 0; i < difference.pixels(); ++i) difference[i] = glm::vec3(frame.picture[i]) - as_one[i];
    auto const detail = finest_detail(rule, difference);
    auto const theirs = share_of_guides(rule, detail, guides, as_one);
    for (std::size_t i = 0; i < detail.pixels(); ++i) {
        auto const noise = theirs[i] * (1.f - shares[i]) * detail[i];
        frame.picture[i] -= noise, add_to_signals(frame, i, -noise);
    }
    detail_before.emplace(seen.number, std::move(guides));
}

LinearPicture samples_of_picture(SeenFrame const& seen, io::ChannelNames const& names, LightSplit const& light) {
    if (!seen.image.has_all(io::planes_of(Channels<Motion>{}, names))) return {};
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    std::vector<bool> is_missing(seen.image.pixels());
    auto const samples_of = [&](std::size_t s) {
        auto samples = light_of(seen.image, light.signals[s], none);
        for (std::size_t i = 0; i < is_missing.size(); ++i)
            is_missing[i] = is_missing[i] || !quell::detail::is_light(vec3<float>(samples[i]));
        return samples;
    };
    long long not_finite = 0;
    std::vector<LinearPicture> parts;
    auto samples = composite(seen.image, light, samples_of, not_finite, parts);
    for (std::size_t i = 0; i < is_missing.size(); ++i)
        if (is_missing[i]) samples[i] = glm::vec3(none);
    return samples;
}

void change_signals(DenoisedFrame& frame, LinearView const& before) {
    for (std::size_t i = 0; i < before.pixels(); ++i) add_to_signals(frame, i, glm::vec3(frame.picture[i]) - before[i]);
}

} // namespace quell::examples

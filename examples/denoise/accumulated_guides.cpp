#include <denoise/accumulated_guides.hpp>
#include <denoise/light_split.hpp>

#include <quell/core/real.hpp>
#include <quell/frame/kept_channels.hpp>
#include <quell/resolve/light_unit.hpp>

#include <algorithm>

namespace quell::examples {

namespace {

/// The mean of a picture that is exposed as usual, of what is white.
constexpr double middle_grey = 0.18;

/// What a signal's light is multiplied by: its factor, or else the albedo that it holds.
ReadPicture colour_of(io::ExrImage const& image, io::SignalNames const& signal) {
    if (!signal.factor.empty()) return picture_of(image, signal.factor, 1.f);
    return picture_of(image, io::sources_of(signal.channels, albedo), 1.f);
}
/// A signal without a colour, such as light in a volume, says nothing of the surface.
bool has_colour(io::SignalNames const& signal) {
    return !signal.factor.empty() || !io::planes_of(io::sources_of(signal.channels, albedo)).empty();
}

} // namespace

PictureGuides::PictureGuides(Preset p, int t) : preset(std::move(p)), threads(t) {}

std::vector<AccumulatedGuide> PictureGuides::next(io::ExrImage& image, io::SequenceNames const& names, long long number,
                                                  GuideImages& images) {
    LinearPicture colours(image.size);
    auto const added = picture_of(image, names.added, 0.f);
    LinearPicture light(added);
    for (auto const& signal : names.of_signals) {
        auto const colour = colour_of(image, signal), of_signal = light_of(image, signal);
        bool const is_factor = !signal.factor.empty(), counts = has_colour(signal);
        for (std::size_t i = 0; i < light.pixels(); ++i) {
            light[i] += is_factor ? of_signal[i] * colour[i] : of_signal[i];
            if (counts) colours[i] += colour[i];
        }
    }
    // What shines, and what lies behind everything, is its own albedo, as a usual exposure shows it: of any unit.
    double const mean = quell::detail::mean_brightness(light.view());
    auto const exposure = static_cast<float>(mean > 0. ? middle_grey / mean : 0.);
    for (std::size_t i = 0; i < added.pixels(); ++i) colours[i] += glm::clamp(added[i] * exposure, 0.f, 1.f);
    bool const has_none = names.added.empty() && std::ranges::none_of(names.of_signals, has_colour);
    for (auto& value : colours.values) value = has_none ? 1.f : glm::min(value, 1.f);
    auto channels = names.of_signals[0].channels;
    channels.sources["radiance"] = !names.picture.empty() && image.has_all(io::planes_of(names.picture))
                                       ? names.picture
                                       : put_picture(image.planes, "guided light", light);
    channels.sources["albedo"] = put_picture(image.planes, "guided albedo", colours);
    if (!denoiser) denoiser = std::make_unique<Denoiser>(way_of(preset), image.size, threads);
    denoiser->look_ahead(image, channels, number, images);
    static_cast<void>(denoiser->denoise(image, channels, number));
    std::vector<AccumulatedGuide> guides;
    for (auto const& name : denoiser->guides())
        guides.push_back({name, name == mean_normal.name ? std::array{"X", "Y", "Z"} : std::array{"R", "G", "B"}, denoiser->guide(name)});
    return guides;
}

void PictureGuides::release_scratch() {
    if (denoiser) denoiser->release_scratch();
}

} // namespace quell::examples

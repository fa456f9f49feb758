#include <denoise/guide_planes.hpp>
#include <denoise/light_split.hpp>
#include <denoise/untold_motion.hpp>

#include <quell/core/light.hpp>
#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>

namespace quell::examples {

namespace {

constexpr std::size_t kept = 16;       ///< motions, more than any window of frames is long
constexpr std::size_t least_part = 50; ///< a part of less than one in so many pixels does not count

constexpr std::size_t background = 0; ///< of UntoldMotion::parts

using Pixels = std::vector<std::size_t>;

/// The pixels of both parts, by depth; of one that is small, none.
std::array<Pixels, 2> pixels_of_parts(io::ExrImage const& image, io::ChannelNames const& names, GuideImages& guides) {
    std::array<Pixels, 2> parts;
    auto const view = guides.get(depth.name, image, names)->view(depth);
    std::size_t i = 0;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x, ++i) parts[is_finite(view.get(0, x, y)) ? 1 : background].push_back(i);
    for (auto& pixels : parts)
        if (pixels.size() * least_part < i) pixels.clear();
    return parts;
}

/// By what a part is found again: the light of a background, the colours of surfaces.
std::vector<float> shown_by(std::size_t part, io::ExrImage const& image, io::SequenceNames const& names) {
    std::vector<float> light(image.pixels(), 0.f);
    auto const add = [&](LinearView const& picture) {
        for (std::size_t i = 0; i < light.size(); ++i) light[i] += luminance(picture[i]);
    };
    if (part == background) add(whole_picture(image, names));
    for (auto const& signal : names.of_signals) {
        auto const colour = signal.factor.empty() ? io::sources_of(signal.channels, albedo) : signal.factor;
        if (part != background && image.has_all(io::planes_of(colour))) add(picture_of(image, colour, 0.f));
    }
    return light;
}

/// Both components of a channel of vectors, in pixels of quell's convention.
template <ChannelTag C>
std::vector<glm::vec2> vectors_of(C channel, io::ExrImage const& image, io::ChannelNames const& names, GuideImages& images) {
    auto const view = images.get(channel.name, image, names)->view(channel);
    std::vector<glm::vec2> vectors;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x) vectors.emplace_back(view.get(0, x, y), view.get(1, x, y));
    return vectors;
}

/// Whether vectors say nothing of these pixels: they are 0.
bool are_zero(std::vector<glm::vec2> const& vectors, Pixels const& pixels) {
    auto const moving = std::ranges::count_if(pixels, [&](auto i) { return vectors[i] != glm::vec2(0.f); });
    return static_cast<std::size_t>(moving) * 10 < pixels.size();
}

/// Adds motion to the vectors of a part, of each set of planes once. Vectors of the background at the rim of things may be means with those
/// of surfaces, where the others are 0.
/// @param more of a pixel's place
template <ChannelTag C>
void add(C channel, io::ExrImage& image, io::SequenceNames const& names, std::size_t part, GuideImages& images, auto const& more) {
    std::vector<std::vector<std::string>> done;
    for (auto const& signal : names.of_signals) {
        auto const& guides = signal.channels;
        auto const sources = io::sources_of(guides, channel);
        auto const planes = io::planes_of(sources);
        bool const is_done = std::ranges::find(done, planes) != done.end();
        if (is_done || !is_pass(image, sources) || !image.has_all(io::planes_of(Channels<Depth>{}, guides))) continue;
        done.push_back(planes);
        auto const pixels = pixels_of_parts(image, guides, images)[part];
        auto const vectors = vectors_of(channel, image, guides, images);
        bool const is_told = part != background || !are_zero(vectors, pixels);
        for (int axis = 0; axis < 2; ++axis) {
            auto const convention = std::is_same_v<C, Motion> ? guides.motion : io::detail::next_convention(guides.motion);
            auto const own = io::detail::to_own_motion(axis, image, convention);
            put_component(image, sources[static_cast<std::size_t>(axis)], pixels, [&](std::size_t i) {
                auto const width = static_cast<std::size_t>(image.size.width);
                float const told = is_told ? vectors[i][axis] : 0.f;
                return (told + more(static_cast<double>(i % width), static_cast<double>(i / width))[axis] - own.offset) / own.factor;
            });
        }
        images.forget(channel.name);
    }
}

} // namespace

void UntoldMotion::tell(io::ExrImage& image, io::SequenceNames const& names, long long number, bool is_opaque, GuideImages& images) {
    auto const& guides = names.of_signals[0].channels;
    if (!image.has_all(io::planes_of(Channels<Depth, Motion>{}, guides))) return;
    auto const pixels_of_part = pixels_of_parts(image, guides, images);
    auto told = vectors_of(motion, image, guides, images);
    if (are_zero(told, pixels_of_part[background]))
        for (auto const i : pixels_of_part[background]) told[i] = glm::vec2(0.f);
    for (std::size_t part = is_opaque ? background : background + 1; part < parts.size(); ++part) {
        auto& [last, found] = parts[part];
        auto const& pixels = pixels_of_part[part];
        if (!found.contains(number) && !pixels.empty()) {
            std::vector<char> is_part(told.size(), 0);
            for (auto const i : pixels) is_part[i] = 1;
            Pyramid pyramid(image.size, shown_by(part, image, names), std::move(is_part));
            if (last && last->number + 1 == number && last->pyramid.size == image.size)
                if (auto const more = found_motion(pyramid, last->pyramid, told)) found.insert_or_assign(number, *more);
            last = Shown{number, std::move(pyramid)};
            while (found.size() > kept) found.erase(found.begin());
        }
        if (auto const of = found.find(number); of != found.end())
            add(motion, image, names, part, images, [&](double x, double y) { return of->second.at(x, y); });
    }
}

bool UntoldMotion::tell_next(io::ExrImage& image, io::SequenceNames const& names, long long number, GuideImages& images) const {
    bool is_known = false;
    for (std::size_t part = 0; part < parts.size(); ++part)
        if (auto const of = parts[part].found.find(number + 1); of != parts[part].found.end()) {
            add(motion_next, image, names, part, images, [&](double x, double y) { return of->second.back_from(x, y); });
            is_known = true;
        }
    return is_known;
}

} // namespace quell::examples

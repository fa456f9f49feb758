#include <denoise/behind_volume.hpp>
#include <denoise/light_split.hpp>

#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace quell::examples {

namespace {

constexpr int passes = 2;           ///< pixels from which guides come at most
constexpr int around = 2;           ///< pixels in which a volume is looked for
constexpr float fewest_hits = .02f; ///< part of the samples of which colours are taken
constexpr float far_behind = 4.f;   ///< times the depth of the farthest surface

bool is_black(glm::vec3 const& p) { return !(p.x > 0.f || p.y > 0.f || p.z > 0.f); }

/// Calls f(pixel) with those of the square around (x, y) that are in the image.
template <class F> void for_each_around(Extent size, int x, int y, int radius, F&& f) {
    for (int j = std::max(y - radius, 0); j <= std::min(y + radius, size.height - 1); ++j)
        for (int i = std::max(x - radius, 0); i <= std::min(x + radius, size.width - 1); ++i) f(index_of(size, i, j));
}
template <class F> void for_each_place(Extent size, F&& f) {
    std::size_t pixel = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) f(x, y, pixel++);
}

/// A frame, and where its guides come from.
class Behind {
    io::ExrImage& image;
    io::SequenceNames names;
    ReadPicture volume, added;
    std::vector<float> depth;      ///< infinite: no surface
    std::vector<float> hits;       ///< part of the samples
    std::vector<bool> is_near;     ///< whether there is light of a volume around
    std::vector<std::size_t> from; ///< of each pixel: whose guides it takes

    /// From the pixels around, one pixel farther at a time.
    void take_from_around() {
        for (int pass = 0; pass < passes; ++pass) {
            auto const depth_before = depth;
            auto const from_before = from;
            for_each_place(image.size, [&](int x, int y, std::size_t here) {
                if (!is_hole(here) || is_finite(depth_before[here])) return;
                std::vector<std::size_t> found;
                for_each_around(image.size, x, y, 1, [&](std::size_t there) {
                    if (is_finite(depth_before[there])) found.push_back(there);
                });
                if (found.empty()) return;
                auto const middle = found.begin() + static_cast<std::ptrdiff_t>((found.size() - 1) / 2);
                std::ranges::nth_element(found, middle, {}, [&](std::size_t there) { return std::pair(depth_before[there], there); });
                depth[here] = depth_before[*middle], from[here] = from_before[*middle];
            });
        }
    }
    /// Whether a pixel without a surface may have one behind its volume: it didn't just see what lies behind everything.
    [[nodiscard]] bool is_hole(std::size_t i) const { return is_near[i] && (is_black(added[i]) || !is_black(volume[i])); }

    /// Planes of a guide as they are seen, under names of their own.
    void fill(std::vector<io::Source>& sources, float const* at_misses) {
        for (std::size_t c = 0; c < sources.size(); ++c)
            for (auto& name : sources[c].sum) {
                auto const seen = "quell:behind " + name;
                if (image.find(seen) == nullptr) {
                    auto plane = image[name];
                    auto const given = plane.values;
                    plane.name = seen, plane.with_part.clear(), plane.stored.reset();
                    for (std::size_t i = 0; i < given.size(); ++i) {
                        plane.values[i] = given[from[i]];
                        if (at_misses != nullptr && is_near[i] && !is_finite(depth[i])) plane.values[i] = at_misses[c];
                    }
                    image.planes.push_back(std::move(plane));
                }
                name = seen;
            }
    }
    void fill_guides(io::ChannelNames& channels, float farthest) {
        std::array const far_depth{farthest};
        std::array const far_normal{0.f, 0.f, 1.f};
        auto const fill_guide = [&](auto guide, float const* at_misses) {
            auto sources = io::sources_of(channels, guide);
            if (!image.has_all(io::planes_of(sources))) return;
            fill(sources, at_misses);
            channels.sources[std::string(guide.name)] = std::move(sources);
        };
        fill_guide(quell::depth, far_depth.data()), fill_guide(normal, far_normal.data());
        fill_guide(motion, nullptr), fill_guide(motion_next, nullptr), fill_guide(position, nullptr), fill_guide(instance, nullptr);
    }
    std::vector<io::Source> put(std::string const& name, LinearView const& picture, std::vector<io::Source> const& instead_of) {
        return put_picture(image, "behind " + name, picture, instead_of);
    }
    /// The colour of what was hit, and light that comes from there through the volume.
    void divide(io::SignalNames& signal) {
        auto const mean = picture_of(image, signal.factor, 1.f);
        auto const given_light = light_of(image, signal);
        auto colour = LinearPicture(mean), light = given_light.in_place();
        for (std::size_t i = 0; i < hits.size(); ++i) {
            light[i] = given_light[i];
            float const part = hits[from[i]];
            if (!is_near[i] || !(part > fewest_hits)) continue;
            for (int c = 0; c < 3; ++c) {
                float const own = mean.at(c, i), whole = std::min(mean.at(c, from[i]) / part, std::max(own, 1.f));
                if (!is_finite(whole) || !(whole > 0.f)) continue;
                colour.at(c, i) = whole, light.at(c, i) *= own / whole;
            }
        }
        signal.factor = put("colour of " + signal.name, colour, signal.factor);
        auto const given = io::sources_of(signal.channels, radiance);
        signal.channels.sources["radiance"] = put("light of " + signal.name, light, given);
    }
    void add_to_volume(io::SignalNames& signal) {
        LinearPicture light(image.size), rest(image.size);
        for (std::size_t i = 0; i < light.pixels(); ++i) {
            bool const joins = is_near[i] && all_finite(added[i]);
            light[i] = joins ? volume[i] + added[i] : volume[i], rest[i] = joins ? glm::vec3(0.f) : added[i];
        }
        auto const given = io::sources_of(signal.channels, radiance);
        signal.channels.sources["radiance"] = put("light of " + signal.name, light, given);
        if (!names.added.empty()) names.added = put("added", rest, names.added);
    }

public:
    Behind(io::ExrImage& frame, io::SequenceNames const& n, io::SignalNames const& of_volume)
        : image(frame), names(n), volume(light_of(frame, of_volume)), added(picture_of(frame, n.added, 0.f)), is_near(frame.pixels()),
          from(frame.pixels()) {
        std::iota(from.begin(), from.end(), std::size_t{0});
        auto const& channels = names.of_signals[0].channels;
        depth = io::component_of(frame, io::sources_of(channels, quell::depth)[0]);
        for (auto& z : depth)
            if (z >= channels.miss_from || z <= channels.miss_to) z = std::numeric_limits<float>::infinity();
        auto const normals = picture_of(frame, io::sources_of(channels, normal), 0.f);
        for (std::size_t i = 0; i < normals.pixels(); ++i) {
            auto const n3 = normals[i];
            float const length = std::sqrt(glm::dot(n3, n3));
            hits.push_back(is_finite(length) ? std::min(length, 1.f) : 0.f);
        }
        for_each_place(frame.size, [&](int x, int y, std::size_t i) {
            for_each_around(frame.size, x, y, around, [&](std::size_t there) { is_near[i] = is_near[i] || !is_black(volume[there]); });
        });
    }
    [[nodiscard]] bool has_volume() const { return std::ranges::find(is_near, true) != is_near.end(); }

    io::SequenceNames see() {
        take_from_around();
        float farthest = 0.f;
        for (float const z : depth)
            if (is_finite(z)) farthest = std::max(farthest, z);
        farthest = std::min(far_behind * std::max(farthest, 1e-3f), .5f * names.of_signals[0].channels.miss_from);
        for (auto& signal : names.of_signals) {
            if (!signal.factor.empty()) divide(signal);
            if (signal.name == volume_name) add_to_volume(signal);
        }
        for (auto& signal : names.of_signals) fill_guides(signal.channels, farthest);
        return std::move(names);
    }
};

} // namespace

std::optional<io::SequenceNames> names_behind_volume(io::ExrImage& image, io::SequenceNames const& names) {
    auto const of_volume = std::ranges::find_if(names.of_signals, [](auto const& s) { return s.name == volume_name && s.factor.empty(); });
    if (of_volume == names.of_signals.end() || names.of_signals.size() < 2) return std::nullopt;
    auto const& channels = names.of_signals[0].channels;
    auto const of_depth = io::sources_of(channels, depth), of_normal = io::sources_of(channels, normal);
    if (of_depth[0].sum.size() != 1 || of_depth[0].scale != 1.f || of_depth[0].offset != 0.f || io::planes_of(of_normal).empty())
        return std::nullopt;
    auto wanted = io::planes_of(of_depth);
    for (auto const& plane : io::planes_of(of_normal)) wanted.push_back(plane);
    if (!image.has_all(wanted)) return std::nullopt;
    for (auto const& signal : names.of_signals)
        if (io::planes_of(io::sources_of(signal.channels, radiance)).empty() ||
            (!signal.factor.empty() && io::planes_of(signal.factor).empty()))
            return std::nullopt; // a constant
    if (!names.added.empty() && io::planes_of(names.added).empty()) return std::nullopt;
    Behind behind(image, names, *of_volume);
    if (!behind.has_volume()) return std::nullopt;
    return behind.see();
}

} // namespace quell::examples

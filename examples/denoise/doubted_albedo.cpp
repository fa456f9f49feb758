#include <denoise/doubted_albedo.hpp>
#include <denoise/doubted_places.hpp>
#include <denoise/light_split.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/frame/modulation.hpp>
#include <quell/frame/repair.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quell::examples {

namespace {

using Pixels = std::vector<glm::vec3>;

constexpr AlbedoDoubt begins{6.f, .2f};  ///< of correct renders at 1 and 16 samples, none has such a sum
constexpr AlbedoDoubt goes_on{3.f, .1f}; ///< beside a pixel with doubt
constexpr AlbedoDoubt of_all{3.f, .02f}; ///< of a whole picture: where albedos are right, far more speaks for them than against
constexpr std::size_t fewest = 64;       ///< places of sums that go together: less is an edge
constexpr float fading = .8f;            ///< of sums over a frame
constexpr std::size_t frames_kept = 8;
constexpr float same_depth = .1f; ///< part by which a surface's depth changes over a frame at most

/// Sums are made at one pixel of so many, along rows and columns.
int step_of(Extent size) {
    int const shorter = std::min(size.width, size.height);
    return shorter < 128 ? 1 : shorter < 256 ? 2 : 3;
}

/// A pixel of which nothing but the albedo is known: what a Demodulate looks at.
struct AlbedoPixel {
    using Real = float;
    glm::vec3 value;
    glm::vec3 operator[](Albedo) const { return value; }
};
glm::vec3 divisor_of(glm::vec3 const& colour) {
    return Demodulate{}.outward(AlbedoPixel{detail::Repair<Albedo>::repaired(colour)}, glm::vec3(1.f));
}
bool is_constant(std::vector<io::Source> const& sources) { return io::planes_of(sources).empty(); }

/// One signal of a frame.
struct Signal {
    io::SignalNames const& names;
    std::vector<io::Source> of_light, of_colour; ///< the colour: the factor, or the albedo

    Signal(io::SignalNames const& signal, bool by_albedo) : names(signal), of_light(io::sources_of(signal.channels, radiance)) {
        if (has_factor())
            of_colour = names.factor;
        else if (by_albedo)
            of_colour = io::sources_of(names.channels, albedo);
    }
    [[nodiscard]] bool has_factor() const { return !names.factor.empty(); }
    [[nodiscard]] bool is_divided(io::ExrImage const& image) const {
        return !is_constant(of_colour) && !is_constant(of_light) && image.has_all(io::planes_of(of_colour)) &&
               image.has_all(io::planes_of(of_light));
    }
};

/// The light of a signal in one image.
struct Light {
    ReadPicture light, colour; ///< as they are
    Pixels part, divisor;      ///< light in the picture, and what it is divided by

    Light(io::ExrImage const& image, Signal const& signal)
        : light(picture_of(image, signal.of_light, 0.f)), colour(picture_of(image, signal.of_colour, 1.f)) {
        for (std::size_t i = 0; i < image.pixels(); ++i) {
            part.push_back(signal.has_factor() ? light[i] * colour[i] : light[i]);
            divisor.push_back(signal.has_factor() ? colour[i] : divisor_of(colour[i]));
        }
    }
};

/// One pixel of so many along rows and columns.
struct Grid {
    Extent whole;
    int step;
    Extent size{(whole.width + step - 1) / step, (whole.height + step - 1) / step};

    [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(size.pixels()); }
    [[nodiscard]] std::size_t index(int x, int y) const { return index_of(size, x, y); }
    [[nodiscard]] std::size_t in_whole(int x, int y) const { return index_of(whole, x * step, y * step); }
    /// Calls f(x, y) with each place.
    void for_each(auto&& f) const {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) f(x, y);
    }
    [[nodiscard]] std::vector<float> of(std::vector<float> const& values) const {
        std::vector<float> some;
        if (!values.empty()) for_each([&](int x, int y) { some.push_back(values[in_whole(x, y)]); });
        return some;
    }
    [[nodiscard]] SurfaceGuides of(SurfaceGuides const& guides) const {
        SurfaceGuides some{of(guides.depth), {of(guides.normals[0]), of(guides.normals[1]), of(guides.normals[2])}};
        some.find_slopes(size);
        return some;
    }
    /// What a signal is read from.
    [[nodiscard]] io::ExrImage of(io::ExrImage const& image, Signal const& signal) const {
        io::ExrImage small{.name = image.name, .size = size};
        for (auto const& sources : {signal.of_light, signal.of_colour})
            for (auto const& name : io::planes_of(sources))
                if (small.find(name) == nullptr) small.planes.push_back({.name = name, .values = of(image[name].values)});
        return small;
    }
};

/// Where each place of a grid was in the frame before: a place of the grid, or none. Without motion, where it is.
class Moved {
    Grid const& grid;
    LoadedChannelPointer vectors;

public:
    Moved(Grid const& g, LoadedChannelPointer v) : grid(g), vectors(std::move(v)) {}
    [[nodiscard]] std::optional<std::size_t> from(int x, int y) const {
        if (!vectors) return grid.index(x, y);
        auto const view = vectors->view(motion);
        auto const steps = static_cast<float>(grid.step);
        auto const at = [&](int c, int place) {
            return std::round(static_cast<float>(place) + view.get(c, x * grid.step, y * grid.step) / steps);
        };
        float const there_x = at(0, x), there_y = at(1, y);
        auto const is_in = [](float a, int length) { return is_finite(a) && a >= 0.f && a < static_cast<float>(length); };
        if (!is_in(there_x, grid.size.width) || !is_in(there_y, grid.size.height)) return std::nullopt;
        return grid.index(static_cast<int>(there_x), static_cast<int>(there_y));
    }
};

/// Pixels of the whole image whose nearest places of the grid on their surface are doubted, most of them.
std::vector<bool> in_whole(Grid const& grid, std::vector<bool> const& mask, SurfaceGuides const& guides) {
    std::vector<bool> whole;
    for (int y = 0; y < grid.whole.height; ++y)
        for (int x = 0; x < grid.whole.width; ++x) {
            int more = 0;
            for (int const j : {y / grid.step, y / grid.step + 1})
                for (int const i : {x / grid.step, x / grid.step + 1}) {
                    if (i >= grid.size.width || j >= grid.size.height) continue;
                    if (guides.are_one(whole.size(), grid.in_whole(i, j), i * grid.step - x, j * grid.step - y))
                        more += mask[grid.index(i, j)] ? 1 : -1;
                }
            whole.push_back(more > 0);
        }
    return whole;
}

/// Takes the rim of doubted places in: pixels beside them, of much the same depth, whose normals turn too fast to be linked to any.
void take_rim(std::vector<bool>& mask, Extent size, std::vector<float> const& depth) {
    constexpr int rounds = 2;
    constexpr float of_one_thing = .1f; // part of the depth
    for (int round = 0; round < rounds && !depth.empty(); ++round) {
        auto const before = mask;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto const here = index_of(size, x, y);
                for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j)
                    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.width - 1); ++i)
                        if (auto const there = index_of(size, i, j);
                            before[there] && std::abs(depth[there] - depth[here]) <= of_one_thing * depth[here])
                            mask[here] = true;
            }
    }
}

/// Whether the picture as a whole speaks against its albedo, and most surfaces too: one thing of very bright albedo is not the picture.
bool is_doubted_all_over(std::vector<AlbedoEvidence> const& evidence, std::vector<AlbedoEvidence> const& of_surfaces) {
    AlbedoEvidence all;
    for (auto const& each : evidence) all += each;
    auto const against = std::ranges::count_if(of_surfaces, [](auto const& sum) { return sum.difference > 0.f; });
    auto const in_favour = std::ranges::count_if(of_surfaces, [](auto const& sum) { return sum.difference < 0.f; });
    return against > in_favour && of_all.holds(all);
}

/// Puts constants in the place of a signal's colours, and light that makes the same picture with them.
void replace(io::ExrImage& image, io::SignalNames& names, Signal const& signal, SurfaceLinks const& surfaces,
             std::vector<bool> const& mask) {
    Light given(image, signal);
    flatten(surfaces, mask, given.divisor);
    auto light = given.light.in_place(), colour = given.colour.in_place();
    for (std::size_t i = 0; i < mask.size(); ++i) {
        light[i] = mask[i] && signal.has_factor() ? given.light[i] * (given.colour[i] / given.divisor[i]) : given.light[i];
        colour[i] = mask[i] ? given.divisor[i] : given.colour[i];
    }
    auto& sources = names.channels.sources;
    (signal.has_factor() ? names.factor : sources["albedo"]) = put_picture(image, "colour for " + names.name, colour, signal.of_colour);
    if (signal.has_factor()) sources["radiance"] = put_picture(image, "light for " + names.name, light, signal.of_light);
}

} // namespace

DoubtedAlbedo::Known const* DoubtedAlbedo::find(long long number, Extent size) const {
    for (auto const& each : known)
        if (each.number == number && each.size == size) return &each;
    return nullptr;
}

std::optional<io::SequenceNames> DoubtedAlbedo::names_for(io::ExrImage& image, io::SequenceNames const& names, bool by_albedo,
                                                          long long number, GuideImages& images) {
    auto const guides = surface_guides_in(image, names.of_signals[0].channels);
    if (!guides) return std::nullopt;
    Grid const grid{image.size, step_of(image.size)};
    auto const small_guides = grid.of(*guides);
    SurfaceLinks const small_surfaces(grid.size, small_guides);
    Moved const moved(grid, images.get(motion.name, image, names.of_signals[0].channels));
    auto const* const before = find(number - 1, grid.size);
    Known now{number, grid.size, small_guides.depth, {}};
    std::optional<SurfaceLinks> surfaces;
    std::optional<io::SequenceNames> seen;
    for (std::size_t s = 0; s < names.of_signals.size(); ++s) {
        Signal const signal(names.of_signals[s], by_albedo);
        if (!signal.is_divided(image)) continue;
        Light const light(grid.of(image, signal), signal);
        auto& evidence = now.of_signals[s] = albedo_evidence(small_surfaces, light.part, light.divisor);
        if (before != nullptr && before->of_signals.contains(s)) {
            auto const& earlier = before->of_signals.at(s);
            grid.for_each([&](int x, int y) {
                auto const here = grid.index(x, y);
                auto const there = moved.from(x, y);
                if (!there) return;
                if (!now.depth.empty() && !before->depth.empty() &&
                    std::abs(now.depth[here] - before->depth[*there]) > same_depth * now.depth[here])
                    return;
                evidence[here] += earlier[*there].weighted(fading);
            });
        }
        auto const sums = small_surfaces.window_sums(evidence);
        std::vector<bool> whole;
        if (is_doubted_all_over(evidence, sums)) {
            whole.assign(image.pixels(), true); // edges and sky too, which lie on no surface
            if (!surfaces) surfaces.emplace(image.size, *guides);
        } else {
            auto mask = places(
                small_surfaces, grid.pixels(), fewest, [&](std::size_t i) { return begins.holds(sums[i]); },
                [&](std::size_t i) { return goes_on.holds(sums[i]); });
            if (std::ranges::find(mask, true) == mask.end()) continue;
            close_gaps(small_surfaces, mask);
            if (!surfaces) surfaces.emplace(image.size, *guides);
            whole = in_whole(grid, mask, *guides);
            close_gaps(*surfaces, whole);
            take_rim(whole, image.size, guides->depth);
        }
        most = std::max(most, static_cast<double>(std::ranges::count(whole, true)) / static_cast<double>(whole.size()));
        if (!seen) seen = names;
        replace(image, seen->of_signals[s], signal, *surfaces, whole);
    }
    if (find(number, grid.size) == nullptr) known.push_back(std::move(now));
    if (known.size() > frames_kept) known.pop_front();
    return seen;
}

std::vector<std::string> DoubtedAlbedo::remarks() const {
    if (!(most > 0.)) return {};
    return {"albedo says nothing of the light in up to " + std::to_string(static_cast<int>(std::ceil(100. * most))) +
            " % of the picture, and is not divided by there"};
}

} // namespace quell::examples

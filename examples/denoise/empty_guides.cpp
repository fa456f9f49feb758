#include <denoise/empty_guides.hpp>
#include <denoise/guide_planes.hpp>
#include <denoise/light_split.hpp>
#include <denoise/noisy_normals.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <array>

namespace quell::examples {

namespace {

using Values = std::vector<float>;

/// The guides of one signal.
class Guides {
    io::ExrImage& image;
    std::vector<io::Source> of_normal, of_depth;
    io::ChannelNames const& names;
    std::array<Values, 3> normals; ///< empty: no pass
    Values depths;                 ///< as in the file; empty: no pass

    [[nodiscard]] float squared_normal(std::size_t i) const {
        return normals[0][i] * normals[0][i] + normals[1][i] * normals[1][i] + normals[2][i] * normals[2][i];
    }
    [[nodiscard]] std::vector<std::size_t> pixels_where(auto const& f) const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < image.pixels(); ++i)
            if (f(i)) found.push_back(i);
        return found;
    }
    void flatten(std::vector<std::size_t> const& pixels) {
        for (std::size_t c = 0; c < 3; ++c) put_component(image, of_normal[c], pixels, [c](std::size_t) { return c == 2 ? 1.f : 0.f; });
    }
    /// Of each pixel, whether the depth shows a surface; empty: that is not known.
    [[nodiscard]] std::vector<bool> surfaces() const {
        if (depths.empty()) return {};
        auto z = depths;
        io::detail::mark_misses(z, image, of_depth[0], names);
        std::vector<bool> shown;
        for (float const each : z) shown.push_back(is_finite(each) && each > 0.f);
        return shown;
    }

public:
    Guides(io::ExrImage& frame, io::ChannelNames const& channels)
        : image(frame), of_normal(io::sources_of(channels, normal)), of_depth(io::sources_of(channels, quell::depth)), names(channels) {
        for (std::size_t c = 0; c < 3 && is_pass(image, of_normal); ++c) normals[c] = io::component_of(image, of_normal[c]);
        if (is_pass(image, of_depth)) depths = io::component_of(image, of_depth[0]);
    }

    /// Of normals that show a surface, where the depth is 0. @return whether it is 0 everywhere
    bool fill_depth() {
        if (depths.empty()) return false;
        bool const is_empty = std::ranges::all_of(depths, [](float z) { return z == 0.f; });
        if (normals[0].empty()) return false;
        auto const pixels = pixels_where([&](std::size_t i) { return depths[i] == 0.f && squared_normal(i) > .25f; });
        put_component(image, of_depth[0], pixels, [](std::size_t) { return 1.f; });
        for (auto const i : pixels) depths[i] = 1.f;
        return is_empty && !pixels.empty();
    }
    /// Of surfaces, where the normal is 0. @return whether it is 0 on all of them
    bool fill_normal() {
        if (normals[0].empty()) return false;
        auto const shown = surfaces();
        auto const is_surface = [&](std::size_t i) { return shown.empty() || shown[i]; };
        auto const seen = pixels_where(is_surface);
        auto const pixels = pixels_where([&](std::size_t i) { return is_surface(i) && squared_normal(i) == 0.f; });
        bool const is_empty = !seen.empty() && pixels.size() == seen.size();
        if (shown.empty() && !is_empty) return false; // it may be the sky
        flatten(pixels);
        return is_empty;
    }
    void flatten_normals() {
        if (!normals[0].empty()) flatten(pixels_where([&](std::size_t i) { return squared_normal(i) > 0.f; }));
    }
    /// Whether albedo is black on all surfaces, and light is not.
    [[nodiscard]] bool has_black_albedo() const {
        auto const of_albedo = io::sources_of(names, albedo), of_light = io::sources_of(names, radiance);
        if (!is_pass(image, of_albedo) || !is_pass(image, of_light)) return false;
        auto const shown = surfaces();
        bool is_lit = false;
        for (std::size_t c = 0; c < 3; ++c) {
            auto const colours = io::component_of(image, of_albedo[c]), light = io::component_of(image, of_light[c]);
            for (std::size_t i = 0; i < colours.size(); ++i) {
                if (!shown.empty() && !shown[i]) continue;
                if (colours[i] != 0.f) return false;
                is_lit = is_lit || light[i] > 0.f;
            }
        }
        return is_lit;
    }
};

} // namespace

EmptyGuides fill_empty_guides(io::ExrImage& image, io::SequenceNames const& names) {
    EmptyGuides empty;
    for (auto const& signal : names.of_signals) {
        Guides guides(image, signal.channels);
        empty.depth = guides.fill_depth() || empty.depth;
        empty.normal = guides.fill_normal() || empty.normal;
        empty.albedo = guides.has_black_albedo() || empty.albedo;
    }
    return empty;
}

bool fill_noisy_normals(io::ExrImage& image, io::SequenceNames const& names) {
    auto const guides = surface_guides_in(image, names.of_signals[0].channels);
    if (!guides || !are_normals_rough(image.size, *guides)) return false;
    if (do_normals_explain(image.size, *guides, whole_picture(image, names))) return false;
    for (auto const& signal : names.of_signals) Guides(image, signal.channels).flatten_normals();
    return true;
}

std::vector<std::string> EmptyPasses::remarks() const {
    std::vector<std::string> all;
    if (normal) all.emplace_back("the pass of normals is 0 on every surface: surfaces are told apart by depth alone");
    if (noise) all.emplace_back("the pass of normals is noise, with which light does not go: surfaces are told apart by depth alone");
    if (depth) all.emplace_back("the pass of depth is 0 everywhere: surfaces are told apart by normals alone");
    if (albedo && !is_first) all.emplace_back("the pass of albedo is black on every surface: textures are filtered as light is");
    return all;
}

} // namespace quell::examples

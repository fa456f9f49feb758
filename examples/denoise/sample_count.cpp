#include <denoise/light_split.hpp>
#include <denoise/sample_count.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quell::examples {

int samples_in(io::ExrListing const& file, io::SequenceNames const& names) {
    constexpr std::string_view before = "cycles.", behind = ".samples";
    std::map<std::string, int> by_layer;
    for (auto const& [name, value] : file.attributes)
        if (auto const* const text = std::get_if<std::string>(&value);
            text && name.starts_with(before) && name.ends_with(behind) && name.size() > before.size() + behind.size())
            by_layer[name.substr(before.size(), name.size() - before.size() - behind.size())] = std::max(std::atoi(text->c_str()), 0);
    if (by_layer.empty()) return 0;
    auto const light = io::planes_of(io::sources_of(names.of_signals[0].channels, radiance));
    auto const* const channel = light.empty() ? nullptr : file.find(light[0]);
    std::string layer; // the longest: names of layers may have dots
    for (auto const& [name, samples] : by_layer)
        if (channel && channel->in_part.starts_with(name + ".") && name.size() > layer.size()) layer = name;
    if (!layer.empty()) return by_layer.at(layer);
    auto const first = by_layer.begin()->second;
    return std::ranges::all_of(by_layer, [=](auto const& each) { return each.second == first; }) ? first : 0;
}

namespace {

constexpr float noise_of_one_sample = 1.6f; ///< its standard deviation over the light around, of indirect light
/// Octaves between the number that is said and the one that is seen: up to the first the file is believed, from the second on it is not.
struct Doubt {
    float begins, ends;
    [[nodiscard]] float of(float octaves) const { return std::clamp((octaves - begins) / (ends - begins), 0.f, 1.f); }
};
constexpr Doubt of_fewer{2.75f, 4.25f}, of_more{4.f, 6.f};

/// Whether a plane is of a pass of indirect light, by any of Blender's names.
bool is_indirect(std::string_view plane) {
    auto const pass = plane.substr(0, plane.rfind('.'));
    return pass.ends_with("Ind") || pass.ends_with(" Indirect");
}

/// The sum of the passes of indirect light; without pixels where there are none.
ReadPicture indirect_light(io::ExrImage const& image, io::SequenceNames const& names) {
    std::vector<io::Source> sum(3);
    for (auto const& signal : names.of_signals) {
        auto const light = io::sources_of(signal.channels, radiance);
        for (std::size_t c = 0; c < 3 && c < light.size(); ++c)
            std::ranges::copy_if(light[c].sum, std::back_inserter(sum[c].sum), is_indirect);
    }
    for (auto const& source : sum)
        if (source.sum.empty() || !image.has_all(source.sum)) return {};
    return picture_of(image, sum, 0.f);
}

/// The standard deviations of a picture's noise over its light, in the middle of all windows of 5x5 pixels that are not dark, and that
/// which a fifth of them exceed; 0: not known. Noise is what neighbours differ by more than pixels at twice the distance make likely, along
/// rows or columns, whichever is less.
std::array<float, 2> relative_noise(LinearView const& picture) {
    constexpr int side = 5;
    struct Window {
        float light, noise;
    };
    std::vector<Window> windows;
    double mean = 0;
    auto const at = [&](int x, int y) { return picture[index_of(picture.size, x, y)]; };
    for (int y0 = 0; y0 + side <= picture.size.height; y0 += side)
        for (int x0 = 0; x0 + side <= picture.size.width; x0 += side) {
            float light = 0, sums[2][2] = {}; // along rows and columns: of neighbours, and at twice the distance
            for (int y = y0; y < y0 + side; ++y)
                for (int x = x0; x < x0 + side; ++x) {
                    auto const here = at(x, y);
                    light += std::abs(luminance(here));
                    for (int step = 1; step <= 2; ++step) {
                        auto const add = [&](float& sum, int dx, int dy) {
                            if (x + dx >= x0 + side || y + dy >= y0 + side) return;
                            auto const off = at(x + dx, y + dy) - here;
                            sum += dot(off, off) / static_cast<float>(6 * side * (side - step));
                        };
                        add(sums[0][step - 1], step, 0), add(sums[1][step - 1], 0, step);
                    }
                }
            float const rows = std::clamp(2.f * sums[0][0] - sums[0][1], 0.f, sums[0][0]);
            float const columns = std::clamp(2.f * sums[1][0] - sums[1][1], 0.f, sums[1][0]);
            light /= static_cast<float>(side * side);
            if (!is_finite(light) || !is_finite(rows + columns)) continue;
            windows.push_back({light, std::sqrt(std::min(rows, columns))}), mean += static_cast<double>(light);
        }
    if (windows.empty()) return {0.f, 0.f};
    float const dark = 0.05f * static_cast<float>(mean / static_cast<double>(windows.size()));
    std::vector<float> parts;
    for (auto const& window : windows)
        if (window.light > dark) parts.push_back(window.noise / window.light);
    if (parts.empty()) return {0.f, 0.f};
    std::ranges::sort(parts);
    return {parts[parts.size() / 2], parts[parts.size() * 4 / 5]};
}

} // namespace

int believed_samples(io::ExrImage const& image, io::SequenceNames const& names, int said) {
    if (said < 1) return said;
    auto const [middle, most] = relative_noise(indirect_light(image, names));
    if (!(middle > 0.f && most > 0.f)) return said;
    auto const seen_by = [](float noise) { return 2.f * std::log2(noise_of_one_sample / noise); };
    // That there are more samples has to be seen in nearly all windows: some light has no noise, as that of mirrors.
    float const of_file = std::log2(static_cast<float>(said)), fewer = seen_by(middle), more = seen_by(most);
    float const seen = fewer < of_file ? fewer : std::max(more, of_file);
    float const doubt = seen < of_file ? of_fewer.of(of_file - seen) : of_more.of(seen - of_file);
    return static_cast<int>(std::lround(std::exp2(std::clamp(of_file + doubt * (seen - of_file), 0.f, 20.f))));
}

} // namespace quell::examples

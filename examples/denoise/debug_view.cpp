#include <denoise/debug_view.hpp>
#include <support/png.hpp>

#include <quell/io/write_exr.hpp>

#include <algorithm>
#include <array>

namespace quell::examples {

namespace {

/// One colour for each number, up to seven.
glm::vec3 color_of_number(float number) {
    constexpr std::array<glm::vec3, 8> colors{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
    return colors[static_cast<std::size_t>(std::clamp(number, 0.f, 7.f))];
}

glm::vec3 color_of(std::string const& view, float value) {
    if (view == debug_source.name || view == debug_rejection.name) return color_of_number(value);
    float const white = view == debug_length.name ? 32.f : 1.f;
    return glm::vec3(std::clamp(value / white, 0.f, 1.f));
}

} // namespace

std::string debug_view_names() {
    std::string names;
    for_each_channel(DebugChannels{}, [&](auto channel) { names += (names.empty() ? "" : ", ") + std::string(channel.name); });
    return names;
}

bool is_debug_view(std::string const& name) {
    bool found = false;
    for_each_channel(DebugChannels{}, [&](auto channel) { found = found || name == channel.name; });
    return found;
}

std::filesystem::path path_beside(std::filesystem::path output, std::string const& name) {
    if (output.extension() == ".exr") output.replace_extension(); // what is behind another dot may be the frame's number
    return output += "." + name;
}

void write_debug_view(std::filesystem::path const& output, std::string const& view, std::string const& name, DebugImage const& image) {
    io::ExrImage exr{.size = image.size};
    exr.planes.push_back({.name = "Y", .type = io::SampleType::float32, .values = image.values});
    io::write_exr(path_beside(output, name + ".exr"), exr);
    metrics::Picture picture{image.size, {}};
    for (auto const value : image.values) picture.pixels.push_back(color_of(view, value));
    write_png(path_beside(output, name + ".png"), picture);
}

} // namespace quell::examples

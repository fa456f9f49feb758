#include "header.hpp"

#include <quell/presets/named.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <utility>

namespace quell::bench {
namespace {

/// What a host writes into each channel; quell/frame/channels.hpp says it at length.
constexpr std::array meanings{
    std::pair{"albedo", "diffuse reflectance, 1 where there is no surface"},
    std::pair{"normal", "unit, world space"},
    std::pair{"depth", "along the view axis, > 0, +inf for a miss"},
    std::pair{"position", "of the surface, world space"},
    std::pair{"roughness", "GGX, as artists give it, in [0, 1]"},
    std::pair{"motion", "pixels, y down: previous position = current position + motion"},
    std::pair{"direct", "direct light without shadows, noise-free"},
    std::pair{"visibility", "1 where the light sample is seen, 0 where it is blocked"},
    std::pair{"light", "the light sample's position, world space"},
    std::pair{"light_previous", "where that point of the light was a frame ago"},
    std::pair{"blocker", "what the shadow ray hit, not finite for nothing"},
    std::pair{"blocker_previous", "where that point was a frame ago"},
    std::pair{"receiver_previous", "where the point seen in the pixel was a frame ago"},
    std::pair{"glossy", "reflected radiance times the specular reflectance"},
    std::pair{"glossy_hit", "what the reflected ray hit, not finite for nothing"},
    std::pair{"glossy_hit_previous", "where that point was a frame ago"},
    std::pair{"indirect", "incident radiance of the one indirect sample"},
    std::pair{"indirect_direction", "where that came from, unit, world space"},
    std::pair{"sweep", "pixels that what the sample shows moves while the shutter is open"},
    std::pair{"time", "of the sample, in [0, 1] over the open shutter"},
};

/// The rest is what the pipelines of the others don't make.
std::string meaning_of_radiance(Effects const& split) {
    std::string text = "the noisy picture";
    if (has(split, Part::shadow)) text += " - direct * visibility";
    if (has(split, Part::glossy)) text += " - glossy";
    if (has(split, Part::indirect)) text += " - albedo * indirect";
    return text;
}

std::string meaning_of(std::string const& channel, Effects const& split) {
    for (auto const& [name, meaning] : meanings)
        if (channel == name) return meaning;
    return meaning_of_radiance(split);
}

void write_comment(std::ostream& out, Composition const& composition, Origin const& origin) {
    auto const frames = fmt::format("{}", fmt::join(origin.scored, ", "));
    out << "// Written by quell-fit: the smallest composition found that keeps " << origin.sequence << " to " << to_string(origin.bounds)
        << ".\n"
        << "// " << to_string(composition) << '\n'
        << "// At " << to_string(origin.size) << " on " << origin.threads << " threads: " << to_string(composition.figures)
        << " (displayed, mean of frames " << frames << ").\n"
        << "// Memory: " << origin.memory << ".\n";
    for (auto const& sentence : origin.left_out) out << "// Left out: " << sentence << '\n';
    out << "//\n// Channels that a host must fill:\n";
    for (auto const& name : channels_of(composition)) out << fmt::format("//   {:<20}{}\n", name, meaning_of(name, composition.split));
    bool const camera = std::ranges::any_of(composition.parts, [](auto const* trial) { return trial->contender->needs_camera; });
    if (camera) out << "// and frame.camera.\n";
    if (std::ranges::count(channels_of(composition), Sweep::name) > 0)
        out << "// and frame.shutter, the part of the frame time during which the shutter is open.\n";
}

/// The headers of the presets that it is made of.
std::set<std::string_view> groups_of(Composition const& composition) {
    std::set<std::string_view> groups;
    for (auto const* trial : composition.parts) {
        auto const& name = trial->contender->name;
        for_each_preset([&](auto const& preset) {
            if (preset.name == name.substr(0, name.find('/'))) groups.insert(to_string(preset.group));
        });
    }
    return groups;
}

void write_pipeline(std::ostream& out, Composition const& composition) {
    out << "inline constexpr auto pipeline = [] {\n    using namespace quell;\n    return Composite{\n";
    for (auto const* trial : composition.parts)
        out << "        " << trial->contender->code << (trial == composition.parts.back() ? "\n" : ",\n");
    out << "    };\n}();\n\n/// What its history and its scratch are kept in: quell::History history{size, pipeline, Storage{}}.\n"
        << "using Storage = quell::Planar<" << (composition.memory() == Precision::half ? "quell::Float16" : "") << ">;\n";
}

} // namespace

std::vector<std::string> channels_of(Composition const& composition) {
    std::vector<std::string> channels;
    for_each_channel(FitFrame::channels{}, [&](auto channel) {
        auto const reads = [&](auto const* trial) { return std::ranges::count(trial->contender->reads, channel.name) > 0; };
        if (std::ranges::any_of(composition.parts, reads)) channels.emplace_back(channel.name);
    });
    return channels;
}

std::string header_text(Composition const& composition, Origin const& origin) {
    auto const channels = channels_of(composition);
    std::ostringstream out;
    write_comment(out, composition, origin);
    out << "#pragma once\n\n";
    for (auto const& group : groups_of(composition)) out << "#include <quell/presets/" << group << ".hpp>\n";
    out << "#include <quell/quell.hpp>\n\n#include <array>\n#include <string_view>\n\nnamespace fit {\n\n";
    write_pipeline(out, composition);
    out << "\n/// What it reads.\ninline constexpr std::array<std::string_view, " << channels.size() << "> channels{"
        << fmt::format("\"{}\"", fmt::join(channels, "\", \"")) << "};\n"
        << "static_assert(std::remove_const_t<decltype(pipeline)>::reads::size == channels.size(), \"this quell isn't the one that it was "
           "fitted with: run quell-fit again\");\n"
        << "\n/// Against the references of the sequence that it was fitted to.\ninline constexpr double promised_rmse = "
        << fmt::format("{:.6f}", composition.figures.rmse) << ";\n\n} // namespace fit\n";
    return out.str();
}

} // namespace quell::bench

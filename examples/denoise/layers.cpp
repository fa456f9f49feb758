#include <denoise/layers.hpp>
#include <denoise/layout_changes.hpp>

#include <quell/core/half.hpp>
#include <quell/core/real.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace quell::examples {

namespace {

constexpr std::array components{"R", "G", "B"};

std::string layer_of(std::string const& channel) {
    auto const dot = channel.rfind('.');
    return dot == std::string::npos ? std::string() : channel.substr(0, dot);
}

/// A name stands for a channel, a layer, all layers below a view layer, a layer whatever its view layer, or a part.
bool is_named(std::string const& name, std::string const& part, std::string const& channel) {
    auto const layer = layer_of(channel);
    return name == channel || name == layer || layer.starts_with(name + ".") || layer.ends_with("." + name) ||
           (!part.empty() && name == part);
}

std::string list_of_layers(io::ExrListing const& file) {
    std::set<std::string> names;
    for (auto const& channel : file.channels) names.insert(layer_of(channel.in_part).empty() ? channel.in_part : layer_of(channel.in_part));
    std::string list;
    for (auto const& name : names) list += ", " + name;
    return list;
}

ChannelTriple in_layer(std::string const& layer, std::string const& eye) {
    ChannelTriple names;
    for (std::size_t c = 0; c < 3; ++c) names[c] = io::detail::with_eye(layer + (layer.empty() ? "" : ".") + components[c], eye);
    return names;
}

float rounded(float value, io::SampleType type) {
    return type == io::SampleType::half ? float_from_half(io::detail::stored_half(value)) : value;
}

/// What is added to the signals at a pixel, in order; nothing where some of it is not finite.
void find_added(DenoisedFrame const& frame, std::size_t pixel, int component, std::vector<float>& values) {
    values.clear();
    for (auto const& planes : frame.added)
        for (auto const& plane : planes)
            if (!is_finite((*plane.values)[pixel])) return;
    for (auto const& plane : frame.added[static_cast<std::size_t>(component)])
        values.push_back((*plane.values)[pixel] * plane.scale + plane.offset);
}

struct Place {
    int part;
    std::string name;
    io::SampleType type;
};
Place place_of(std::string const& name, io::ExrListing const& file, io::SequenceNames const& names, io::SampleType otherwise) {
    auto const home = home_part(file, names);
    auto const home_name = std::ranges::find(file.channels, home, &io::ExrChannel::part)->part_name + ".";
    for (auto const& channel : file.channels) // other parts may have that name too
        if (channel.part == home && (channel.in_part == name || home_name + channel.in_part == name))
            return {home, channel.in_part, channel.type};
    // Of several views, the parts of others are not meant.
    auto const* const channel = file.find(name);
    bool const is_meant = channel && (names.view.empty() || !io::detail::has_several_parts(file) || channel->in_part != name);
    if (is_meant) return {channel->part, channel->in_part, channel->type};
    bool const is_qualified = !names.view.empty() && io::detail::has_several_parts(file) && name.starts_with(home_name);
    return {home, is_qualified ? name.substr(home_name.size()) : name, otherwise};
}

/// The channels that guides are read from: data, whatever a renderer or a map calls them.
std::vector<io::ExrChanges::Guide> guides_in(io::ExrListing const& file, io::SequenceNames const& names) {
    std::vector<io::ExrChanges::Guide> guides;
    for (auto const& signal : names.of_signals)
        for (auto const& plane : io::planes_of(Channels<Normal, Depth, Motion, MotionNext, Position>{}, signal.channels)) {
            auto const place = place_of(plane, file, names, io::SampleType::half);
            if (file.find(plane)) guides.push_back({place.part, place.name});
        }
    return guides;
}

} // namespace

bool LayerChoice::has(std::string const& word) const {
    return names.empty() || std::ranges::find(names, word) != names.end() || std::ranges::find(names, "all") != names.end();
}

bool LayerChoice::keeps(std::string const& part, std::string const& channel) const {
    return has("all") || std::ranges::any_of(names, [&](auto const& name) { return is_named(name, part, channel); });
}

void LayerChoice::check(io::ExrListing const& file) const {
    for (auto const& name : names) {
        if (name == "all" || name == "picture" || name == "signals" || name == "guides") continue;
        if (std::ranges::none_of(file.channels, [&](auto const& c) { return is_named(name, c.part_name, c.in_part); }))
            throw Error("--layers", "there is no layer '" + name + "' in " + file.name,
                        "choose any of: all, picture, signals, guides" + list_of_layers(file));
    }
}

std::optional<ChannelTriple> only_signal(io::SequenceNames const& names) {
    if (names.of_signals.size() != 1 || !names.of_signals[0].factor.empty() || !names.added.empty()) return std::nullopt;
    auto const sources = io::sources_of(names.of_signals[0].channels, radiance);
    ChannelTriple channels;
    for (std::size_t c = 0; c < 3; ++c) {
        if (sources[c].sum.size() != 1 || sources[c].scale != 1.f || sources[c].offset != 0.f) return std::nullopt;
        channels[c] = sources[c].sum[0];
    }
    return channels;
}

int home_part(io::ExrListing const& file, io::SequenceNames const& names) {
    for (auto const& source : io::sources_of(names.of_signals[0].channels, radiance))
        for (auto const& plane : source.sum)
            if (auto const* const channel = file.find(plane)) return channel->part;
    return file.channels.front().part;
}

std::string word_of(std::string name) {
    for (auto& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    while (name.ends_with('_')) name.pop_back();
    return name;
}

ChannelTriple picture_channels(io::SequenceNames const& names, std::optional<std::string> const& said) {
    if (said) return in_layer(*said, names.eye);
    if (names.picture.size() == 3) {
        ChannelTriple channels;
        for (std::size_t c = 0; c < 3; ++c) channels[c] = names.picture[c].sum.at(0);
        return channels;
    }
    if (auto const only = only_signal(names)) return *only;
    return in_layer(names.layer.empty() ? "" : names.layer + "Combined", names.eye);
}

std::optional<std::string> alpha_plane(io::ExrListing const& file, io::SequenceNames const& names,
                                       std::optional<std::string> const& layer) {
    auto const red = picture_channels(names, layer)[0];
    auto const beside = layer_of(red);
    auto const name = beside.empty() ? "A" : beside + ".A";
    auto const *const picture = file.find(red), *const alpha = file.find(name);
    bool const is_others = picture && alpha && picture->part != alpha->part; // another part's alpha is another picture's
    return alpha && !is_others ? std::optional(name) : std::nullopt;
}

std::vector<ChannelTriple> signal_channels(io::SequenceNames const& names) {
    if (!has_several_signals(names)) return {};
    std::vector<ChannelTriple> channels;
    auto const add = [&](std::string const& name) {
        channels.push_back(in_layer(names.layer + "denoised_" + word_of(name), names.eye));
        if (std::ranges::count(channels, channels.back()) > 1)
            throw Error(names.renderer, "two signals have the name '" + name + "'", "give each a name of its own");
    };
    for (auto const& signal : names.of_signals) add(signal.name);
    add(rest_name);
    return channels;
}

void add_up_exactly(DenoisedFrame& frame, std::array<io::SampleType, 3> const& type) {
    std::vector<float> added;
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < frame.picture.pixels(); ++i) {
            auto& whole = frame.picture.at(c, i);
            whole = rounded(whole, type[static_cast<std::size_t>(c)]);
            if (frame.signals.empty()) continue;
            find_added(frame, i, c, added);
            auto const sum_as_read = [&] {
                float all = 0;
                for (auto const& signal : frame.signals) all += signal.at(c, i);
                for (auto const value : added) all += value;
                return all;
            };
            auto* strongest = &frame.signals[0].at(c, i);
            double rest = 0;
            for (auto& signal : frame.signals) {
                auto& part = signal.at(c, i);
                if (!is_finite(part)) part = 0.f;
                rest += static_cast<double>(part);
                if (std::abs(part) > std::abs(*strongest)) strongest = &part;
            }
            for (auto const value : added) rest += static_cast<double>(value);
            *strongest = static_cast<float>(static_cast<double>(whole) - (rest - static_cast<double>(*strongest)));
            // Whoever adds the layers up rounds after each addition, so that the exact difference may lead to a neighbour of `whole`. Then
            // the next float or the one after it leads there, of that signal or of another one. Where large signals cancel each other there
            // may be none: then the picture is their sum, as long as that is close and the picture's type holds it.
            constexpr int most_steps = 8;
            auto const leads_there = [&](float& part) {
                auto const before = part;
                for (int step = 0; step < most_steps && sum_as_read() != whole; ++step)
                    part = std::nextafter(part, sum_as_read() < whole ? INFINITY : -INFINITY);
                if (sum_as_read() == whole) return true;
                part = before;
                return false;
            };
            if (leads_there(*strongest)) continue;
            if (std::ranges::any_of(frame.signals, [&](auto& signal) { return leads_there(signal.at(c, i)); })) continue;
            float const sum = sum_as_read();
            if (rounded(sum, type[static_cast<std::size_t>(c)]) == sum && std::abs(sum - whole) <= 1e-6f * std::abs(*strongest))
                whole = sum;
        }
}

void check_levels(io::ExrOriginal const& original, io::SequenceNames const& names, std::optional<std::string> const& picture_layer,
                  LayerChoice const& layers) {
    auto const& file = original.listed;
    auto triples = signal_channels(names);
    triples.push_back(picture_channels(names, picture_layer));
    std::set<int> touched;
    for (auto const& triple : triples)
        for (auto const& name : triple) touched.insert(place_of(name, file, names, io::SampleType::half).part);
    for (auto const& channel : file.channels)
        if (!layers.keeps(channel.part_name, channel.in_part)) touched.insert(channel.part);
    for (auto const part : touched)
        if (original.has_levels(part))
            throw Error(file.name, "its tiles have several levels (a mip map or rip map)", "write frames with one level");
}

io::ExrChanges changes_for(DenoisedFrame& frame, io::ExrListing const& file, io::SequenceNames const& names,
                           std::optional<std::string> const& picture_layer, LayerChoice const& layers) {
    auto const picture = picture_channels(names, picture_layer);
    auto const alpha_name = alpha_plane(file, names, picture_layer);
    auto const alpha = alpha_name ? std::optional(place_of(*alpha_name, file, names, io::SampleType::half)) : std::nullopt;
    auto const name_of = [&](int part) { return std::ranges::find(file.channels, part, &io::ExrChannel::part)->part_name; };
    auto const alpha_part = alpha && io::detail::has_several_parts(file) ? name_of(alpha->part) : std::string();
    io::ExrChanges changes{.canvas = frame.canvas, .keeps = [=, &layers](auto const& part, auto const& channel) {
                               bool const is_alpha = alpha && channel == alpha->name && (alpha_part.empty() || part == alpha_part);
                               return layers.keeps(part, channel) || (layers.has_picture() && is_alpha); // it belongs to the picture
                           }};
    changes.guides = guides_in(file, names);
    auto const put = [&](Place const& place, LinearView const& of, std::size_t c) {
        if (c == 0) LayoutChanges::add();
        changes.numbers.push_back({place.part, place.name, place.type, {of.planes[c], of.planes[c] + of.pixels()}});
    };
    std::vector<Place> places;
    for (auto const& name : picture) places.push_back(place_of(name, file, names, io::SampleType::half));
    add_up_exactly(frame, {places[0].type, places[1].type, places[2].type});
    std::size_t const different = picture[0] == picture[1] ? 1 : 3;
    LayoutChanges::Of const of_picture("picture");
    for (std::size_t c = 0; c < different; ++c)
        if (layers.has_picture() || layers.keeps(name_of(places[c].part), places[c].name)) put(places[c], frame.picture, c);
    if (alpha && !frame.alpha.empty() && layers.has_picture())
        changes.numbers.push_back({alpha->part, alpha->name, alpha->type, frame.alpha});
    for (auto const& guide : frame.guides)
        for (std::size_t c = 0; c < 3 && layers.has_guides(); ++c) {
            auto const name = io::detail::with_eye(names.layer + guide.name + "." + guide.components[c], names.eye);
            put(place_of(name, file, names, io::SampleType::half), guide.values, c);
        }
    auto const signals = signal_channels(names);
    for (std::size_t s = 0; s < signals.size() && layers.has_signals(); ++s) {
        LayoutChanges::Of const of(s < names.of_signals.size() ? names.of_signals[s].name : rest_name);
        for (std::size_t c = 0; c < 3; ++c) put(place_of(signals[s][c], file, names, io::SampleType::float32), frame.signals[s], c);
    }
    return changes;
}

} // namespace quell::examples

#include <denoise/layers.hpp>
#include <denoise/signal_choice.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace quell::examples {

namespace {

/// quell's own signals; those with albedo in them are divided by it.
using OwnSignals = Channels<Radiance, Direct, Visibility, Glossy, Indirect>;
bool has_albedo_in_it(std::string_view signal) { return signal == radiance.name || signal == direct.name; }

bool has_all(io::ExrListing const& file, std::vector<io::Source> const& sources) { return file.has_all(io::planes_of(sources)); }

std::vector<io::Source> ones() { return std::vector<io::Source>(3, io::Source{{}, 1.f}); }

/// One component stands for three that are the same.
std::vector<io::Source> as_three(std::vector<io::Source> sources) {
    if (sources.size() == 1) sources.resize(3, sources[0]);
    return sources;
}

SignalChoice choice_of(std::string const& word, std::vector<io::Source> const& sources, io::SignalNames const& of,
                       io::SequenceNames const& names) {
    SignalChoice choice{word, names, static_cast<int>(sources.size())};
    choice.names.of_signals = {of}, choice.names.added.clear(), choice.names.picture.clear();
    choice.names.of_signals[0].name = word;
    choice.names.of_signals[0].channels.sources["radiance"] = as_three(sources);
    return choice;
}

/// A part of the light, whose guides are those of the picture's first signal. How it changes and sweeps by itself has its name.
SignalChoice choice_of_part(std::string const& word, std::vector<io::Source> const& sources, io::ExrListing const& file,
                            io::SequenceNames const& names) {
    auto of = names.of_signals[0];
    of.factor.clear();
    if (!has_albedo_in_it(word)) of.channels.sources["albedo"] = ones();
    if (word == radiance.name) return choice_of(word, sources, of, names);
    auto const vectors = [](std::string const& layer) { return std::vector<io::Source>{{{layer + ".X"}}, {{layer + ".Y"}}}; };
    of.channels.sources["radiance_gradient"] = vectors(word + "_gradient");
    if (auto const own = vectors("sweep_" + word); has_all(file, own)) of.channels.sources["sweep"] = own;
    return choice_of(word, sources, of, names);
}

/// The layer or the channel of that name: R, G and B of it, or the only component that it has.
std::vector<io::Source> layer_named(std::string const& word, io::ExrListing const& file) {
    std::vector<io::Source> colour;
    for (auto const* const letter : {".R", ".G", ".B"}) colour.push_back({{word + letter}});
    if (has_all(file, colour)) return colour;
    if (file.find(word)) return {{{word}}};
    std::vector<io::Source> components;
    for (auto const& channel : file.channels)
        if (channel.name.starts_with(word + ".") && channel.name.find('.', word.size() + 1) == std::string::npos)
            components.push_back({{channel.name}});
    return components.size() == 1 ? components : std::vector<io::Source>();
}

template <class F> void for_each_own_signal(io::ExrListing const& file, io::SequenceNames const& names, F&& f) {
    for_each_channel(OwnSignals{}, [&](auto channel) {
        auto const sources = io::sources_of(names.of_signals[0].channels, channel);
        if (has_all(file, sources)) f(std::string(channel.name), sources);
    });
}

std::string signals_in(io::ExrListing const& file, io::SequenceNames const& names) {
    std::vector<std::string> all;
    auto const add = [&](std::string const& name) {
        if (std::ranges::find(all, name) == all.end()) all.push_back(name);
    };
    for (auto const& signal : names.of_signals)
        if (has_all(file, io::sources_of(signal.channels, radiance))) add(signal.name);
    for_each_own_signal(file, names, [&](auto const& name, auto const&) { add(name); });
    for (auto const& channel : file.channels) {
        auto const layer = channel.name.substr(0, channel.name.rfind('.'));
        if (channel.name.ends_with(".R") && layer_named(layer, file).size() == 3) add(layer);
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

} // namespace

SignalChoice choose_signal(std::string const& word, io::ExrListing const& file, io::SequenceNames const& names) {
    for (auto const& signal : names.of_signals)
        if (signal.name == word && has_all(file, io::sources_of(signal.channels, radiance)))
            return choice_of(word, io::sources_of(signal.channels, radiance), signal, names);
    std::optional<SignalChoice> choice;
    for_each_own_signal(file, names, [&](auto const& name, auto const& sources) {
        if (name == word) choice = choice_of_part(word, sources, file, names);
    });
    if (choice) return *choice;
    if (auto const sources = layer_named(word, file); !sources.empty()) return choice_of_part(word, sources, file, names);
    if (word == rest_name)
        throw Error("--signal", "the rest is what the signals leave over of each frame's picture, and not in " + file.name,
                    "leave --signal out, and take the layer denoised_rest (--layers signals)");
    throw Error("--signal", "there is no signal '" + word + "' in " + file.name, "choose any of: " + signals_in(file, names));
}

bool can_denoise(Preset const& preset, SignalChoice const& signal) {
    return preset.of_signals.size() == 1 && preset.of_signals[0].components >= signal.components;
}

io::SequenceNames names_for(Preset const& preset, SignalChoice const& signal) {
    if (preset.of_signals.size() > 1) {
        std::vector<std::string> parts;
        for (auto const& part : preset.of_signals) parts.push_back(part.name);
        throw Error("--preset", fmt::format("'{}' puts a picture together of {}", preset.name, fmt::join(parts, ", ")),
                    "leave --signal out, or choose a preset of one signal, such as final-frame");
    }
    auto const& own = preset.of_signals.at(0);
    if (!can_denoise(preset, signal))
        throw Error("--preset",
                    "'" + preset.name + "' denoises a signal of one component, as " + own.name + " is, and '" + signal.word + "' has three",
                    "choose another preset, such as final-frame");
    auto names = signal.names;
    auto& sources = names.of_signals[0].channels.sources;
    if (is_part(preset)) sources["direct"] = sources["albedo"] = ones();
    auto given = sources.at("radiance");
    given.resize(static_cast<std::size_t>(own.components));
    sources[own.name] = given;
    return names;
}

PresetChoice preset_for(io::ExrListing const& file, SignalChoice const& signal) {
    for (auto const* const name : {"blur", "shadow", "glossy", "dual-cone"}) {
        auto const* const preset = find_preset(name);
        if (!preset || (is_part(*preset) && preset->of_signals[0].name != signal.word)) continue;
        if (can_denoise(*preset, signal) && applies(*preset, file, names_for(*preset, signal)))
            return {preset,
                    is_part(*preset) ? "the files have what " + signal.word + " moves by" : "the files have sweeps and times of samples"};
    }
    return {&preset_of("final-frame"), "the files have " + signal.word + " and guides"};
}

std::optional<std::string> layer_of_signal(io::SequenceNames const& names) {
    if (only_signal(names)) return std::nullopt;
    return names.layer + "denoised_" + word_of(names.of_signals[0].name);
}

std::optional<io::SequenceNames> names_of_effects(Preset const& preset, io::SequenceNames const& names) {
    if (preset.group == PresetGroup::blur || (!is_part(preset) && preset.of_signals.size() < 2)) return std::nullopt;
    auto const& channels = names.of_signals[0].channels;
    io::SequenceNames parts{names.renderer};
    for (auto const& part : preset.of_signals) {
        io::SignalNames signal{part.name, channels};
        for_each_channel(OwnSignals{}, [&](auto channel) {
            if (channel.name == part.name) signal.channels.sources["radiance"] = as_three(io::sources_of(channels, channel));
        });
        if (part.name == visibility.name) signal.factor = io::sources_of(channels, direct);
        if (part.name == indirect.name) signal.factor = io::sources_of(channels, albedo);
        parts.of_signals.push_back(signal);
    }
    return parts;
}

} // namespace quell::examples

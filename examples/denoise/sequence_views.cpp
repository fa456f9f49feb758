#include <denoise/layers.hpp>
#include <denoise/sequence_views.hpp>

#include <fmt/format.h>

namespace quell::examples {

namespace {

std::optional<io::ExrFile> first_readable(std::vector<std::filesystem::path> const& frames) {
    for (auto const& path : frames) {
        if (!std::filesystem::exists(path)) continue;
        try {
            return std::optional<io::ExrFile>(std::in_place, path);
        } catch (Error const&) { // whoever wants it complains
        }
    }
    return std::nullopt;
}

std::optional<io::SequenceNames> names_of_one(io::ExrListing const& frame) {
    try {
        return recognised(frame);
    } catch (Error const&) {
        return std::nullopt; // another chunk complains of it
    }
}

/// How references hold what a preset makes: the effect's part of the picture, or the picture.
ReferenceNames reference_names(Preset const& preset, std::optional<io::SequenceNames> const& known) {
    auto const picture = known ? *known : io::own_sequence();
    auto const effects = names_of_effects(preset, picture);
    if (!effects) return known;
    if (is_part(preset)) return {{*effects, picture}, true};
    return {{picture, *effects}, true};
}

/// The picture of a view as converged frames may hold it, without its passes.
io::SequenceNames picture_alone(io::SequenceNames const& names) {
    io::SequenceNames alone{names.renderer, {{"picture"}}};
    for (auto const& channel : picture_channels(names)) alone.of_signals[0].channels.sources["radiance"].push_back({{channel}});
    return alone;
}

} // namespace

SequenceViews::SequenceViews(std::string map_, std::vector<std::filesystem::path> const& frames)
    : map(std::move(map_)), frame(first_readable(frames)) {
    if (frame) {
        auto found = views_in(*frame, map);
        left = std::move(found.left);
        for (auto& view : found.views) all.push_back({std::move(view), std::nullopt});
    }
    for (auto& view : all) view.names = names_in_file(*view.part, *frame);
    if (!all.empty()) return;
    auto& whole = all.emplace_back();
    left.clear();
    if (!map.empty())
        whole.names = read_map(map, frame ? &*frame : nullptr);
    else if (frame)
        whole.names = names_of_one(*frame);
}

PresetChoice SequenceViews::choose(Preset const* preset, std::string const& word, std::filesystem::path const& first) {
    PresetChoice choice{preset, {}};
    if (!word.empty()) {
        choose_signals(choice, word, first);
    } else if (!preset) {
        io::ExrFile const file(first);
        choice = preset_for(file, all[0].names ? *all[0].names : recognised(file));
    }
    set_references(*choice.preset, !word.empty());
    return choice;
}

void SequenceViews::choose_signals(PresetChoice& choice, std::string const& word, std::filesystem::path const& first) {
    std::vector<SequenceView> with_it;
    for (auto& view : all) {
        io::ExrFile const file(first);
        auto const& listing = view.part ? view.part->listing : static_cast<io::ExrListing const&>(file);
        auto const signal = [&]() -> std::optional<SignalChoice> {
            try {
                return choose_signal(word, listing, view.part ? view.part->names : view.names ? *view.names : recognised(file));
            } catch (Error const&) {
                if (&view == &all.back() && with_it.empty()) throw;
                left.push_back(view.names->view);
                return std::nullopt;
            }
        }();
        if (!signal) continue;
        if (!choice.preset) choice = preset_for(listing, *signal);
        auto names = names_for(*choice.preset, *signal);
        if (view.part) {
            auto of_signal = *view.part;
            of_signal.names = std::move(names);
            names = names_in_file(of_signal, *frame);
        }
        with_it.push_back({std::move(view.part), std::move(names)});
    }
    all = std::move(with_it);
}

/// The first view of a sequence is scored by whatever its references are recognised as, the others by what they are called.
void SequenceViews::set_references(Preset const& preset, bool is_signal) {
    for (auto& view : all) {
        bool const is_first = &view == &all.front();
        if (is_signal)
            view.references = {{*view.names}, false};
        else if (is_first)
            view.references = reference_names(preset, map.empty() ? std::nullopt : view.names);
        else {
            view.references = reference_names(preset, view.names);
            view.references.any_of.push_back(picture_alone(*view.names));
            view.references.or_recognised = false;
        }
    }
}

std::optional<std::string> SequenceViews::remark() const {
    if (left.empty()) return std::nullopt;
    return fmt::format("left as in the files: {} (not all of light, depth and motion by the names that are read)", fmt::join(left, "; "));
}

} // namespace quell::examples

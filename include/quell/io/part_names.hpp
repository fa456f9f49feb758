#pragma once

#include <quell/io/sequence_names.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

namespace detail {

/// Finds the channels that names stand for in a file of several parts, which may hold the same names for other eyes or other things.
class NamesInParts {
    ExrListing const& file;
    ExrChannel const* home = nullptr; ///< a channel of the picture

public:
    /// @param picture the planes of the picture: the first that the file has says which part it lies in
    NamesInParts(ExrListing const& in, std::vector<std::string> const& picture) : file(in) {
        for (auto const& name : picture)
            if (!home) home = file.find(name);
    }

    /// The channel that a name means: the only one of that name, else that of the picture's part, else the only one of the picture's view.
    /// Null where there is none, or where no rule tells.
    [[nodiscard]] ExrChannel const* find(std::string const& name) const {
        auto const all = called(name);
        if (all.size() <= 1) return all.empty() ? file.find(name) : all[0];
        if (!home) return nullptr;
        ExrChannel const* of_view = nullptr;
        int of_views = 0;
        for (auto const* const channel : all) {
            if (channel->part == home->part) return channel;
            if (!home->view.empty() && channel->view == home->view) of_view = channel, ++of_views;
        }
        return of_views == 1 ? of_view : nullptr;
    }

    /// Whether the file gives another channel by that name.
    [[nodiscard]] bool is_other(std::string const& name) const {
        auto const* const channel = find(name);
        return channel && channel != file.find(name);
    }

    /// Writes the part's name before names by which the file would give other channels.
    /// @throws Error naming the parts where it is not known which one a name stands for
    void resolve(std::vector<Source>& sources) const {
        for (auto& source : sources)
            for (auto& name : source.sum)
                if (is_other(name))
                    name = find(name)->part_name + "." + name;
                else if (!find(name) && called(name).size() > 1)
                    fail(name);
    }

private:
    /// All channels of that name in their parts.
    [[nodiscard]] std::vector<ExrChannel const*> called(std::string const& name) const {
        std::vector<ExrChannel const*> all;
        for (auto const& channel : file.channels)
            if (channel.in_part == name) all.push_back(&channel);
        return all;
    }
    [[noreturn]] void fail(std::string const& name) const {
        std::string parts;
        auto const all = called(name);
        for (auto const* const channel : all) parts += (parts.empty() ? "" : ", ") + channel->part_name;
        throw Error(file.name + " channel '" + name + "'",
                    "the parts " + parts + " have it" + (home ? ", and the picture lies in part " + home->part_name : ""),
                    "write the part's name before it in a channel map, as in " + all[0]->part_name + "." + name);
    }
};

} // namespace detail

/// The names by which a file of several parts holds what these names say. A name that several parts have is that of the part that the
/// signal's light lies in, or of the part of the same view. Names that the file lacks stay as they are.
/// @throws Error naming the parts where none of them is the picture's
[[nodiscard]] inline SequenceNames names_in_parts(SequenceNames names, ExrListing const& file) {
    if (file.channels.empty() || file.channels.front().part == file.channels.back().part) return names;
    auto const light = [](SignalNames const& signal) { return planes_of(sources_of(signal.channels, radiance)); };
    for (auto& signal : names.of_signals) {
        detail::NamesInParts const parts(file, light(signal));
        parts.resolve(signal.factor);
        for_each_channel(AllChannels{}, [&](auto channel) { // also those that go by quell's own names
            auto const own = sources_of(signal.channels, channel);
            if (std::ranges::any_of(planes_of(own), [&](auto const& name) { return parts.is_other(name); }))
                signal.channels.sources.insert_or_assign(std::string(channel.name), own);
        });
        for (auto& [channel, sources] : signal.channels.sources) parts.resolve(sources);
    }
    detail::NamesInParts const parts(file, names.of_signals.empty() ? std::vector<std::string>() : light(names.of_signals.front()));
    parts.resolve(names.added), parts.resolve(names.picture);
    return names;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io

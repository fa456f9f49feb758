#pragma once

#include <quell/io/exr_image.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

/// A channel listed in a file's header.
struct ExrChannel {
    std::string name;                   ///< unique in the file: prefixed by the part's name if an earlier part has the same channel
    std::string in_part;                ///< name within its part
    SampleType type = SampleType::half; ///< of its numbers in the file
    int part = 0;                       ///< index of its part
    std::string part_name = {};         ///< may be empty
    /// Subsampling: the file stores every n-th column and row.
    int x_sampling = 1, y_sampling = 1;
    std::string view = {}; ///< of its part, such as left; may be empty
};

/// What an EXR file's header lists, or a part of it.
struct ExrListing {
    std::string name;                                              ///< its path, for messages
    Extent size;                                                   ///< of the display window
    std::vector<ExrChannel> channels = {};                         ///< of all parts, without deep ones
    std::map<std::string, Attribute, std::less<>> attributes = {}; ///< by name; the first part's where several have one
    std::vector<std::string> eyes = {};                            ///< the attribute multiView: stereo views, the default one first

    /// The channel of that name, with or without its part's name; null if there is none.
    [[nodiscard]] ExrChannel const* find(std::string_view channel) const {
        auto const where = [&](auto const& is_it) {
            auto const found = std::ranges::find_if(channels, is_it);
            return found != channels.end() ? &*found : nullptr;
        };
        if (auto const* const named = where([&](auto const& c) { return c.name == channel; })) return named;
        if (auto const* const qualified = where([&](auto const& c) { return c.part_name + "." + c.in_part == channel; })) return qualified;
        return where([&](auto const& c) { return c.in_part == channel; }); // of a listing in which it goes by another name
    }
    /// Whether all of these channels are there.
    [[nodiscard]] bool has_all(std::vector<std::string> const& names) const {
        return std::ranges::all_of(names, [&](auto const& each) { return find(each) != nullptr; });
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::io

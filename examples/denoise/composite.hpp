#pragma once

#include <denoise/light_split.hpp>
#include <support/frame_pattern.hpp>

#include <filesystem>
#include <functional>
#include <optional>

namespace quell::examples {

/// A signal's light times its factor, anti-aliased, or what is added (null: no light); none where they are multiplied pixel by pixel.
using Resolve = std::function<std::optional<LinearPicture>(std::size_t signal, LinearView const* light)>;

/// The picture that the signals of a split make up: the sum of each times its factor, and of what is added. `signal(i)` is the i-th
/// signal's picture, and is asked for where that signal has light. What isn't finite among factors, added parts and the sum counts as 0,
/// and in `missing`.
/// @param parts what each signal adds to it: its picture times its factor
[[nodiscard]] LinearPicture composite(io::ExrImage const& image, LightSplit const& split,
                                      std::function<ReadPicture(std::size_t)> const& signal, long long& missing,
                                      std::vector<LinearPicture>& parts, Resolve const& resolve = {});

/// How a converged frame's file may hold the picture.
struct ReferenceNames {
    std::vector<io::SequenceNames> any_of; ///< the first whose planes it has
    bool or_recognised = true;             ///< otherwise as quell recognises it

    ReferenceNames() = default;
    ReferenceNames(std::vector<io::SequenceNames> some, bool recognised) : any_of(std::move(some)), or_recognised(recognised) {}
    /// As a map says, where there is one, else as quell recognises it.
    ReferenceNames(std::optional<io::SequenceNames> const& map) { // not explicit: callers hand over their map as it is
        if (map) any_of.push_back(*map);
    }
};
/// A converged frame as a linear picture. @throws Error where it has none of these names
[[nodiscard]] LinearPicture read_reference(std::filesystem::path const& path, ReferenceNames const& names);
/// The same for frames of that size. @throws Error for another one
[[nodiscard]] LinearPicture read_reference(std::filesystem::path const& path, ReferenceNames const& names, Extent size);
/// The frames that have one. @throws Error where none has
[[nodiscard]] std::vector<long long> numbers_of_references(FramePattern const& references, FrameRange const& frames);

} // namespace quell::examples

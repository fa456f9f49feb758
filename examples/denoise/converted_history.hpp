#pragma once

#include <denoise/light_split.hpp>

#include <quell/pipeline/history_contents.hpp>

namespace quell::examples {

/// The history of a picture that is filtered as one, made of those of its signals. Nothing where none of them has any.
/// @param alpha of the last frame, as far as light carries it; empty: the picture has none
[[nodiscard]] std::optional<HistoryContents> whole_history(std::vector<std::optional<HistoryContents>> const& parts,
                                                           SignalShares const& shares, std::vector<float> const& alpha);

/// The history of a signal, made of that of the picture which was filtered as one.
[[nodiscard]] HistoryContents part_of_history(HistoryContents whole, SignalShares const& shares, std::size_t signal);

} // namespace quell::examples

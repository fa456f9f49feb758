#pragma once

#include <quell/execute/executor.hpp>

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// An image, or a plane of one, that a pass reads.
struct ListedRead {
    void const* image; ///< its address identifies it
    int rows;          ///< how many rows of the frame above and below its own the pass may look at
};

/// One pass of a frame, ready to run.
struct ListedPass {
    std::string_view name{};               ///< of the pass
    Extent size{};                         ///< pixels
    int fraction = 1;                      ///< a row of it is so many rows of the frame
    std::span<ListedRead const> reads{};   ///< of what passes of this list write: not the host's images
    std::span<void const* const> writes{}; ///< images, by address

    /// @cond
    void (*run)(Region, std::byte const* job, void const* executor) = nullptr;
    std::byte const* job = nullptr;
    void const* executor = nullptr;
    /// @endcond

    /// Computes a part of the pass, by for_each_pixel of the executor that got the list.
    void operator()(Region region) const { run(region, job, executor); }
};

/// An executor that takes all passes of a frame behind the first one, which looks for missing samples:
///
///     void run_list(std::span<ListedPass const> passes) const      // beside for_each_pixel
///
/// It runs each pass for each pixel once. Row y of a pass may run when each earlier pass of the list has run its first rows_before(earlier,
/// later, y) rows. In any such order, and in several threads at once, results are the same bits.
template <class E>
concept ListExecutor = Executor<E> && requires(E const e, std::span<ListedPass const> passes) {
    e.run_list(passes);
};

namespace detail {
inline bool writes(ListedPass const& pass, void const* image) {
    for (void const* const written : pass.writes)
        if (written == image) return true;
    return false;
}
/// How many rows one pass must be ahead of another that reads what it writes. Negative where that reads none of it.
inline int rows_ahead(ListedPass const& writer, ListedPass const& reader) {
    int rows = -1;
    for (auto const& read : reader.reads)
        if (read.rows > rows && writes(writer, read.image)) rows = read.rows;
    return rows;
}
} // namespace detail

/// How many rows of an earlier pass must be done before a later one may compute its row y: 0 where they share no image. A later pass waits
/// for what it reads to be written, and for what it overwrites to be read.
[[nodiscard]] inline int rows_before(ListedPass const& earlier, ListedPass const& later, int y) {
    int const to_read = detail::rows_ahead(earlier, later), to_overwrite = detail::rows_ahead(later, earlier);
    int ahead = to_read > to_overwrite ? to_read : to_overwrite;
    for (void const* const image : later.writes)
        if (ahead < 0 && detail::writes(earlier, image)) ahead = 0;
    if (ahead < 0) return 0;
    if (ahead == std::numeric_limits<int>::max()) return earlier.size.height;
    int const last_of_frame = (y + 1) * later.fraction - 1 + ahead;
    int const rows = last_of_frame / earlier.fraction + 1;
    return rows < earlier.size.height ? rows : earlier.size.height;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <gauntlet/shot.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace quell::gauntlet {

/// What an earlier program made of a frame.
struct Stored {
    double input = 0, quick = 0, full = 0;
    double right = 0;              ///< of `full`, in the part that is right
    std::vector<double> windows{}; ///< of `quick`
};

/// Figures of an earlier program, by situation, samples and frame.
class StoredFigures {
    std::map<std::tuple<std::string, int, int>, Stored> all;

public:
    void add(std::string const& situation, int samples, int frame, Stored figures) {
        all[{situation, samples, frame}] = std::move(figures);
    }
    /// Null where there are none.
    [[nodiscard]] Stored const* find(std::string const& situation, int samples, int frame) const;
    [[nodiscard]] bool is_empty() const { return all.empty(); }

    /// A table, in whose last column each window has two letters: its error within a thousandth.
    void write(std::filesystem::path const& file, Making const& making) const;
    /// Nothing where the file's frames were made in another way.
    /// @throws Error where it is no such table
    [[nodiscard]] static StoredFigures read(std::filesystem::path const& file, Making const& making);
};

/// Numbers from 1e-4 to 1 or so, two letters each.
[[nodiscard]] std::string packed(std::vector<double> const& numbers);
[[nodiscard]] std::vector<double> unpacked(std::string const& letters);

} // namespace quell::gauntlet

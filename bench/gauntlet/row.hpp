#pragma once

#include <gauntlet/references.hpp>
#include <gauntlet/situations.hpp>

#include <quell/metrics/picture.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace quell::gauntlet {

/// Pictures of a frame: as it came in, by `quell-denoise --quick` and by `quell-denoise`.
enum Method : std::size_t { by_none, by_quick, by_default };
inline constexpr std::array method_names{"input", "--quick", "default"};

struct FrameFigures {
    int frame = 0;
    std::array<double, 3> error{}; ///< RMSE of linear colour, by Method
    std::array<double, 3> right{}; ///< the same in the part that is right
    bool has_right = false;
    std::array<std::vector<double>, 3> windows{};
};

/// A situation at a number of samples.
struct Row {
    Situation const* situation = nullptr;
    int samples = 1;
    std::vector<FrameFigures> frames{};
    std::vector<std::string> remarks{};  ///< of quell-denoise
    std::vector<std::string> findings{}; ///< of its --diagnose, which looks where nothing is broken
    /// Of the frame in which the default is worst beside the others, with the reference last.
    int shown = 0;
    std::array<metrics::Picture, 4> pictures{};

    [[nodiscard]] std::string name() const { return situation->name + ", " + std::to_string(samples); }
};

/// Makes the frames of a row, denoises them and scores what comes out.
/// @param program quell-denoise
/// @param folder  for the frames
/// @throws Failure where the program fails
[[nodiscard]] Row run_row(Situation const& situation, Making const& making, References& references, std::filesystem::path const& program,
                          std::filesystem::path const& folder);

/// The same of a sequence of files, whose references lie in the folder `reference` beside it, of the same names. Where there is a folder
/// `broken` beside it, channel R of its files is above 0 in pixels that are broken.
/// @param sequence a folder of frame_0001.exr and so on
/// @throws Error where no frame has a reference
[[nodiscard]] Row run_sequence(Situation const& situation, std::filesystem::path const& sequence, std::filesystem::path const& program,
                               std::filesystem::path const& folder);

} // namespace quell::gauntlet

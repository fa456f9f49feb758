#pragma once

#include <denoise/composite.hpp>
#include <denoise/map_file.hpp>
#include <denoise/presets.hpp>
#include <denoise/signal_choice.hpp>

#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// What of a sequence is denoised by itself.
struct SequenceView {
    std::optional<io::FileView> part;       ///< of the files; empty: they are one view
    std::optional<io::SequenceNames> names; ///< that files are read by; empty: the first file that is read tells
    ReferenceNames references = {};         ///< how converged frames hold it
};

/// The views of a sequence, all of them known from one frame, so that all chunks go by the same.
class SequenceViews {
    std::string map;
    std::optional<io::ExrFile> frame; ///< that they are known from; empty: none can be read
    std::vector<std::string> left;    ///< names of what stays as it is

public:
    std::vector<SequenceView> all; ///< at least one; the first is the one that references score

    /// @param map    a file or a renderer's name; empty: names are recognised
    /// @param frames of which the first is looked at that can be read
    /// @throws Error where the map can't be used
    SequenceViews(std::string map, std::vector<std::filesystem::path> const& frames);

    /// Takes a preset, or else the one that suits the first view.
    /// @param word  the signal to denoise by itself; empty: the picture. Views that do not have it stay as they are.
    /// @param first a frame that there is
    /// @throws Error where the preset can't denoise the signal, or no view has it
    [[nodiscard]] PresetChoice choose(Preset const* preset, std::string const& word, std::filesystem::path const& first);

    /// One line on what stays as it is; nothing where that is nothing.
    [[nodiscard]] std::optional<std::string> remark() const;

private:
    void choose_signals(PresetChoice& choice, std::string const& word, std::filesystem::path const& first);
    void set_references(Preset const& preset, bool is_signal);
};

} // namespace quell::examples

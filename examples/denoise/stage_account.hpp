#pragma once

#include <denoise/linear_picture.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quell::examples {

/// What is done behind a preset, in order.
enum class Stage {
    samples,     ///< the number of samples that a file says is believed
    history,     ///< light with its history is put together with that of the frame alone
    feedback,    ///< light that the filter took out comes back
    colours,     ///< colours are put together from frames around
    guide_noise, ///< noise of guides is taken off
    repeated     ///< what frames in a row lack comes back
};
inline constexpr std::size_t stage_count = 6;

/// How a stage is shown.
struct StageLook {
    std::string_view name;
    std::string_view of_share; ///< what a share of it is: the end of a sentence
    std::string_view colour_name;
    glm::vec3 colour;
};
[[nodiscard]] StageLook const& look_of(Stage stage);
/// What the colours of StageAccount::image() mean.
[[nodiscard]] std::string legend_of_stages();

// Reasons why stages refuse, where something breaks what they rely on.
inline constexpr auto noise_is_shared = "neighbouring pixels share their noise";
inline constexpr auto colours_differ = "frames around show other colours than this one";
inline constexpr auto noise_is_the_same = "a frame around has the same noise";

/// What a stage did to a signal of a frame.
struct StageRow {
    std::string signal; ///< or picture
    Stage stage;
    double share = 0;       ///< how much it did: from 0 to 1
    double refused = 0;     ///< which part of it is left out: from 0 to 1
    std::string reason{};   ///< why
    bool is_broken = false; ///< whether something in the files breaks what the stage relies on
};

/// What stages did to a frame: numbers that cost next to nothing, and where it is asked for, how much they changed each pixel.
class StageAccount {
    bool gathers;
    std::vector<StageRow> all{};
    std::array<std::vector<float>, stage_count> changes{}; ///< of the picture's pixels; empty: the stage changed none
    std::vector<float> refusals{};                         ///< the largest part of each pixel that some stage refused
    metrics::Picture shown{};

public:
    /// @param how whether changes of pixels are gathered
    explicit StageAccount(bool how = false) : gathers(how) {}

    [[nodiscard]] bool is_gathered() const { return gathers; }
    void add(StageRow row) { all.push_back(std::move(row)); }
    /// The number of samples. @param said 0: the file says none
    void add_samples(int said, int believed);
    /// A copy for changed(), where that is gathered.
    [[nodiscard]] LinearPicture before(LinearView const& light) const { return gathers ? LinearPicture(light) : LinearPicture(); }
    /// Gathers what a stage changed. Returns the mean change as a part of the mean light; 0 where that is not gathered.
    /// @param factor that light is multiplied by in the picture; empty: 1
    double changed(Stage stage, LinearView const& before, LinearView const& after, LinearView const& factor = {});
    /// The same of a choice between light with its history and that of the frame alone. Returns which part of it, in the mean, is the
    /// latter.
    double chosen(LinearView const& with_history, LinearView const& alone, LinearView const& light, LinearView const& factor);
    /// What feedback did. @param trust how far it was done; nothing where files lack what it wants
    void add_feedback(std::string const& signal, double share, std::optional<float> trust);
    /// Gathers which part of each pixel a stage refused.
    void refused(std::vector<float> const& parts);
    /// Ends the frame. Stages that have said nothing were left out, for a reason that is given.
    /// @param picture what came out
    void finish(LinearView const& picture, std::string const& reason);

    [[nodiscard]] std::vector<StageRow> const& rows() const { return all; }
    /// For each pixel the colour of the stage that changed it most, the brighter the more that is of the light; what was refused has a
    /// colour of its own. Without pixels where nothing is gathered.
    [[nodiscard]] metrics::Picture const& image() const { return shown; }

    /// The header of a table of stages, and the rows of a view of it.
    static constexpr auto header = "view,signal,stage,share,refused,reason\n";
    [[nodiscard]] std::string table(std::string const& view) const;
};

/// What stages did to all frames.
class StageTotals {
    struct Total {
        std::string view;
        StageRow row; ///< sums over frames; the last reason
        int frames = 0;
    };
    std::vector<Total> totals;

public:
    void add(std::string const& view, StageAccount const& account);
    /// A sentence for each view, signal and stage.
    [[nodiscard]] std::vector<std::string> sentences() const;
    /// A line for each reason that breaks a stage in a noticeable part of the picture.
    [[nodiscard]] std::vector<std::string> remarks() const;
};

} // namespace quell::examples

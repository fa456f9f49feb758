#pragma once

#include <denoise/accumulated_guides.hpp>
#include <denoise/alpha_signal.hpp>
#include <denoise/denoised_frame.hpp>
#include <denoise/denoiser.hpp>
#include <denoise/film_alpha.hpp>
#include <denoise/picture_refiner.hpp>
#include <denoise/residual_links.hpp>
#include <denoise/sequence_frames.hpp>
#include <support/frame_pattern.hpp>

#include <quell/link/residual/residual_feedback_shares.hpp>
#include <quell/resolve/kept_frames.hpp>

#include <array>
#include <deque>
#include <filesystem>
#include <optional>
#include <set>

namespace quell::examples {

/// Denoises the frames of a sequence one after the other, whichever renderer wrote them.
class SequenceDenoiser {
public:
    /// @throws Error where the preset has no debug images, or not one that is wanted
    explicit SequenceDenoiser(SequenceSettings settings);

    /// What the last frame showed for the first time.
    [[nodiscard]] std::vector<Finding> const& findings() const { return found; }

    /// What the last frame looked like inside, by a name for each image: that of the view, behind those of the signal and of its pipeline
    /// where there are several.
    [[nodiscard]] std::vector<std::pair<std::string, DebugImage>> debug_images(std::string const& view);

    /// Reads, denoises and puts together one frame: a linear picture of its display window. Frames are to be asked for in order.
    /// @throws Error naming the file and what is wrong with it
    [[nodiscard]] metrics::Picture next(FramePattern const& in, long long number);
    /// The same with its signals, and all that the file holds around the display window. Valid until the next frame is asked for.
    /// @throws Error as next does
    [[nodiscard]] DenoisedFrame next_whole(FramePattern const& in, long long number) { return next_frame(in, number, true); }
    /// Denoises a frame for those after it alone.
    /// @throws Error as next does
    /// @param in_full whether a frame after it is put together from its picture too
    void warm_up(FramePattern const& in, long long number, bool in_full = false) { static_cast<void>(next_frame(in, number, in_full)); }
    /// The part of a picture that the display window shows; an upsampled picture is that.
    [[nodiscard]] metrics::Picture displayed(LinearView const& whole) const { return frames.displayed(whole); }
    /// Its size.
    [[nodiscard]] Extent displayed_size(LinearView const& whole) const { return frames.settings.upsampling ? whole.size : frames.size(); }

    /// What stages did to the last frame, as long as this has it.
    [[nodiscard]] StageAccount const& account() const { return current->why; }

    /// Gives back all memory but what is remembered: the frame that next_whole() gave ends too. Frames that were read ahead are read again.
    void release_scratch();

    /// Forgets all frames so far, as before frames that don't follow them.
    void forget();

    [[nodiscard]] long long missing_samples() const { return missing; }              ///< of all frames so far
    [[nodiscard]] RepairedGuides const& repaired_guides() const { return repaired; } ///< of all frames so far
    /// Of all frames so far: how long denoising took, without reading and loading files.
    [[nodiscard]] double milliseconds() const;
    /// Memory of history and scratch of all signals. Complete once a frame was denoised.
    [[nodiscard]] double bytes_per_pixel() const;
    /// How the files name their channels. Known once a frame was denoised.
    [[nodiscard]] std::optional<io::SequenceNames> const& names() const { return frames.settings.map; }
    /// About guides that say nothing, in the frames so far.
    [[nodiscard]] std::vector<std::string> remarks() const { return frames.remarks(); }
    /// Whether alpha was left as it is for want of a preset that denoises it.
    [[nodiscard]] bool left_alpha() const { return alpha_stays; }
    /// How pictures are enlarged, as far as it is known; once a frame was denoised, as they are.
    [[nodiscard]] std::optional<Upsampling> const& upsampling() const { return frames.settings.upsampling; }
    /// How often frames began to reach farther out of their display window, so that history started afresh.
    [[nodiscard]] int canvas_changes() const { return changes; }

private:
    SequenceFrames frames;
    int changes = 0;
    double earlier_milliseconds = 0;                  ///< of denoisers that are gone
    double other_milliseconds = 0;                    ///< of what is done to their pictures
    std::vector<std::unique_ptr<Denoiser>> denoisers; ///< one per signal, and one of the rest; null before there was light for it
    /// Between light with history and without, for all signals: without alpha, and with it. Null before they were wanted.
    std::array<std::unique_ptr<quell_library::HistoryChoice>, 2> choices;
    std::optional<PictureGuides> guides; ///< where the preset accumulates them; none before the first frame
    PictureRefiner refiner;
    ResidualLinks links;
    std::unique_ptr<Denoiser> whole;    ///< of the picture beside its signals; null before it was wanted
    std::optional<Upsampler> upsampler; ///< none before it was wanted
    bool was_as_one = false;            ///< whether the last frame was filtered as one picture
    std::optional<long long> last;      ///< number of the frame that was denoised last
    FilmAlpha film;
    AlphaSignal alpha;        ///< where no light speaks for it
    bool alpha_stays = false; ///< whether some film was transparent whose alpha the preset can't denoise with its light
    long long missing = 0;
    RepairedGuides repaired;
    bool checks = false;        ///< whether one of the denoisers looks at the first frames
    std::set<Mistake> known;    ///< those that were found already
    std::vector<Finding> found; ///< in the frame that was asked for last

    /// A frame whose signals are denoised. Its picture is finished when those of the next frame are.
    struct DenoisedSignals {
        SeenFrame seen;
        DenoisedFrame frame;
        LinearPicture samples{}; ///< of its picture; empty where nothing is given back
        FilmContents shown{};    ///< where a transparent film shows something; empty: the film is opaque
        long long missing = 0;   ///< samples
        RepairedGuides repaired{};
        std::vector<Finding> found{};
        StageAccount why{};
    };
    std::optional<DenoisedSignals> current; ///< what was asked for last
    std::optional<DenoisedSignals> ahead;   ///< the frame after it, where its picture takes part in it
    std::deque<SeenFrame> window;           ///< frames that were read: the next to be denoised first
    KeptFrames<std::shared_ptr<FrameAround const>, AntiAliased::most_frames> earlier; ///< frames that have been denoised

    /// @param is_wanted whether it is shown, or only remembered
    [[nodiscard]] DenoisedFrame next_frame(FramePattern const& in, long long number, bool is_wanted);
    [[nodiscard]] DenoisedSignals denoised(FramePattern const& in, long long number, bool is_wanted);
    void denoise_ahead(FramePattern const& in, long long number);
    [[nodiscard]] DenoisedFrame finished(DenoisedSignals& signals);
    [[nodiscard]] bool sees_next(SeenFrame const& seen) const;
    void begin(io::ExrOriginal const& file);
    void upsample(DenoisedFrame& frame, SeenFrame& seen);
    [[nodiscard]] std::string against_giving_back(SeenFrame& seen) const;
    [[nodiscard]] std::string name_of(std::size_t signal) const;
    void tell_history(StageAccount& why, std::size_t signal, quell_library::HistoryChoice& choice, LinearView const& light,
                      LinearView const& factor);
    [[nodiscard]] std::vector<float> denoised_alpha(SeenFrame const& seen, LightSplit const& split);
    void add_as_in_file(DenoisedFrame& frame, io::ExrImage const& image, LightSplit const& split) const;
    [[nodiscard]] Purpose purpose_of(std::size_t signal) const;
    [[nodiscard]] Denoiser& denoiser(std::size_t signal);
    [[nodiscard]] quell_library::HistoryChoice* choice_for(std::size_t signal);
    [[nodiscard]] LinearPicture denoised_as_one(SeenFrame& seen);
    void accumulate_guides(DenoisedFrame& frame, SeenFrame& seen);
    void hand_over(FramePattern const& in);
    void read(FramePattern const& in, long long number, bool is_ahead);
    void read_ahead(FramePattern const& in, long long number);
    void collect(std::vector<Finding> const& findings, std::vector<Finding>& into);
};

} // namespace quell::examples

#pragma once

#include <denoise/accumulated_guides.hpp>
#include <denoise/denoised_frame.hpp>
#include <denoise/denoiser.hpp>
#include <denoise/film_alpha.hpp>
#include <denoise/picture_refiner.hpp>
#include <denoise/seen_frame.hpp>
#include <denoise/upsampler.hpp>
#include <support/frame_pattern.hpp>

#include <quell/io/exr/exr_original.hpp>
#include <quell/io/sequence_names.hpp>
#include <quell/resolve/kept_frames.hpp>
#include <quell/resolve/residual_feedback_fit.hpp>

#include <array>
#include <deque>
#include <filesystem>
#include <optional>
#include <set>

namespace quell::examples {

/// How a sequence is denoised.
struct SequenceSettings {
    Preset preset;
    int threads = 0;                        ///< 0: all that there are
    std::optional<io::SequenceNames> map{}; ///< how the files name their channels; without one, that is recognised from the first file
    std::optional<float> shutter{};         ///< how long it is open, whatever the files or the map say
    std::optional<float> field_of_view{};   ///< vertical, degrees: of files whose depth is the length of rays, where they have no camera
    int later_frames = 0;      ///< that each frame is denoised with, where the preset makes use of them and the files are there
    bool keeps_alpha = false;  ///< leave alpha as the files have it
    bool anti_aliases = false; ///< put colours together from frames around
    bool refines = false;      ///< take what is best of several estimates: light with history and without
    bool diagnose = false;     ///< look at each frame for what its renderer got wrong
    std::optional<ResidualFeedbackShares> feedback{}; ///< of what residual feedback gives back; none: as they were fitted
    std::optional<Upsampling> upsampling{};           ///< of the picture and its alpha, which are then all that a frame has; empty: none
    std::vector<std::string> debug_views{}; ///< names of DebugChannels that debug_images() will be asked for: slower, and on one thread
};

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
    [[nodiscard]] metrics::Picture displayed(metrics::Picture const& whole) const;
    /// Its size.
    [[nodiscard]] Extent displayed_size(metrics::Picture const& whole) const { return settings.upsampling ? whole.size : size; }

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
    [[nodiscard]] std::optional<io::SequenceNames> const& names() const { return settings.map; }
    /// Whether alpha was left as it is for want of a preset that denoises it.
    [[nodiscard]] bool left_alpha() const { return alpha_stays; }
    /// How pictures are enlarged, as far as it is known; once a frame was denoised, as they are.
    [[nodiscard]] std::optional<Upsampling> const& upsampling() const { return settings.upsampling; }
    /// How often frames began to reach farther out of their display window, so that history started afresh.
    [[nodiscard]] int canvas_changes() const { return changes; }

private:
    SequenceSettings settings;
    Extent size;                 ///< of the display window
    Region canvas;               ///< what is denoised
    io::SequenceNames on_canvas; ///< the names for images of the canvas
    int changes = 0;
    double earlier_milliseconds = 0;                  ///< of denoisers that are gone
    double other_milliseconds = 0;                    ///< of what is done to their pictures
    std::unique_ptr<Denoiser> any;                    ///< says what each of them wants
    std::vector<std::unique_ptr<Denoiser>> denoisers; ///< one per signal, and one of the rest; null before there was light for it
    /// Between light with history and without, for all signals: without alpha, and with it. Null before they were wanted.
    std::array<std::unique_ptr<quell_library::HistoryChoice>, 2> choices;
    std::optional<PictureGuides> guides; ///< where the preset accumulates them; none before the first frame
    PictureRefiner refiner;
    std::unique_ptr<Denoiser> whole;    ///< of the picture beside its signals; null before it was wanted
    std::optional<Upsampler> upsampler; ///< none before it was wanted
    bool was_as_one = false;            ///< whether the last frame was filtered as one picture
    std::optional<long long> last;      ///< number of the frame that was denoised last
    std::string alpha;                  ///< the plane of the film's alpha; empty: none
    FilmAlpha film;
    bool alpha_stays = false; ///< whether some film was transparent whose alpha the preset can't denoise
    long long missing = 0;
    RepairedGuides repaired;
    bool checks = false;        ///< whether one of the denoisers looks at the first frames
    std::set<Mistake> known;    ///< those that were found already
    std::vector<Finding> found; ///< in the frame that was asked for last

    /// A frame whose signals are denoised. Its picture is finished when those of the next frame are.
    struct DenoisedSignals {
        SeenFrame seen;
        DenoisedFrame frame;
        std::vector<glm::vec3> lacking{}; ///< what its picture lacks of its samples; empty where nothing is given back
        long long missing = 0;            ///< samples
        RepairedGuides repaired{};
        std::vector<Finding> found{};
    };
    std::optional<DenoisedSignals> current; ///< what was asked for last
    std::optional<DenoisedSignals> ahead;   ///< the frame after it, where its picture takes part in it
    [[nodiscard]] LightSplit const& split(SeenFrame& seen, bool as_one) const;
    [[nodiscard]] io::SequenceNames const& names_of(SeenFrame const& seen) const { return seen.behind ? *seen.behind : on_canvas; }
    std::deque<SeenFrame> window;
    KeptFrames<std::shared_ptr<FrameAround const>, AntiAliased::most_frames> earlier; ///< frames that have been denoised

    [[nodiscard]] bool takes_more() const { return looks_ahead(settings.preset) && settings.debug_views.empty(); }
    [[nodiscard]] bool anti_aliases() const { return settings.anti_aliases && takes_more(); }
    [[nodiscard]] bool refines() const { return settings.refines && takes_more(); }
    /// @param is_wanted whether it is shown, or only remembered
    [[nodiscard]] DenoisedFrame next_frame(FramePattern const& in, long long number, bool is_wanted);
    [[nodiscard]] DenoisedSignals denoised(FramePattern const& in, long long number, bool is_wanted);
    void denoise_ahead(FramePattern const& in, long long number);
    [[nodiscard]] DenoisedFrame finished(DenoisedSignals& signals);
    [[nodiscard]] bool sees_next(SeenFrame const& seen) const;
    void begin(io::ExrOriginal const& file);
    void check_upsampling(io::ExrListing const& file);
    void upsample(DenoisedFrame& frame, SeenFrame const& seen);
    [[nodiscard]] SplitRule rule() const;
    [[nodiscard]] bool has_alpha(std::size_t signal) const;
    [[nodiscard]] bool gives_light_back(SeenFrame& seen) const;
    void feed_back_residual(io::ExrImage const& image, io::ChannelNames const& names, int samples, metrics::Picture const& alone,
                            metrics::Picture& light);
    [[nodiscard]] std::vector<float> denoised_alpha(SeenFrame const& seen, LightSplit const& split);
    void clear_empty_film(DenoisedFrame& frame, SeenFrame const& seen);
    void add_as_in_file(DenoisedFrame& frame, io::ExrImage const& image, LightSplit const& split) const;
    [[nodiscard]] Purpose purpose_of(std::size_t signal) const;
    [[nodiscard]] Denoiser& denoiser(std::size_t signal);
    [[nodiscard]] quell_library::HistoryChoice* choice_for(std::size_t signal);
    [[nodiscard]] metrics::Picture denoised_as_one(SeenFrame& seen);
    void accumulate_guides(DenoisedFrame& frame, SeenFrame& seen);
    [[nodiscard]] SeenFrame seen(io::ExrOriginal const& file, long long number) const;
    void hand_over(FramePattern const& in);
    [[nodiscard]] bool is_inside(Region const& other) const;
    void read(FramePattern const& in, long long number, bool is_ahead);
    void read_ahead(FramePattern const& in, long long number);
    void collect(std::vector<Finding> const& findings, std::vector<Finding>& into);
    [[nodiscard]] std::vector<std::string> planes(io::ExrListing const& file) const;
};

} // namespace quell::examples

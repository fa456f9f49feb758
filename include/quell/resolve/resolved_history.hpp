#pragma once

#include <quell/pipeline/history.hpp>
#include <quell/resolve/kept_frames.hpp>
#include <quell/resolve/resolve_passes.hpp>

#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
struct ResolvedRun;
/// Vectors that a Resolve keeps, or nearest and farthest depth.
struct ResolvedPair : Channel<2> {
    static constexpr auto name = "resolved_pair";
    static constexpr bool full_precision = true;
};
} // namespace detail

/// The pipeline's history, and what a Resolve keeps of the last frames.
template <class P, class Policy, ImageStorage Storage> class History<Resolved<P, Policy>, Storage> {
    using Output = typename P::Output;
    struct Kept {
        ImageOf<Storage, Output> colour;
        ImageOf<Storage, detail::ResolvedPair> motion;
        ImageOf<Storage, Depth> depth;
        glm::vec2 jitter{0.f};

        explicit Kept(Extent size) : colour(size), motion(size), depth(size) {}
        [[nodiscard]] std::size_t bytes() const { return colour.bytes() + motion.bytes() + depth.bytes(); }
        /// The jitter in pixels of a frame of that size.
        [[nodiscard]] glm::vec2 jitter_at(Extent size) const {
            auto const own = colour.size();
            if (own == size) return jitter;
            return {jitter.x * (static_cast<float>(size.width) / static_cast<float>(own.width)),
                    jitter.y * (static_cast<float>(size.height) / static_cast<float>(own.height))};
        }
        [[nodiscard]] auto view() const { return detail::ResolvedFrame{colour.view(), motion.view(), depth.view(), colour.size(), jitter}; }
    };
    struct Scratch {
        ImageOf<Storage, Output> low, high;
        ImageOf<Storage, detail::ResolvedPair> depths;

        explicit Scratch(Extent size) : low(size), high(size), depths(size) {}
        [[nodiscard]] std::size_t bytes() const { return low.bytes() + high.bytes() + depths.bytes(); }
        [[nodiscard]] auto view() const { return detail::RangeImages{low.view(), high.view(), depths.view()}; }
    };

public:
    /// @param output_size of what comes out; that of the frames may differ
    /// @param resolved    a pipeline with a resolve behind it
    /// @param storage     of the pipeline's images and of what is kept
    /// @throws Error for a size without pixels
    explicit History(Extent output_size, Resolved<P, Policy> const& resolved, Storage const& storage = {})
        : pipeline(detail::checked(output_size), resolved.pipeline, storage), extent(output_size) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() { pipeline.forget(), frames.forget(); }
    /// Gives scratch back: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() { pipeline.release_scratch(), scratch.reset(), sharpened.reset(); }
    /// Those of the pipeline.
    [[nodiscard]] Statistics statistics() const { return pipeline.statistics(); }
    /// Memory of history, scratch and output, in bytes. Complete when one frame more has run than are kept.
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = pipeline.bytes() + (scratch ? scratch->bytes() : 0) + frames.bytes();
        for (auto const* const image : {&sharpened, &output}) sum += *image ? (*image)->bytes() : 0;
        return sum;
    }
    /// The same per pixel of the output.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(extent.pixels()); }
    /// Pixels of the output.
    [[nodiscard]] Extent size() const { return extent; }

private:
    friend struct detail::ResolvedRun;

    History<P, Storage> pipeline;
    KeptFrames<std::optional<Kept>, std::size_t{Policy::past_frames}> frames{};
    std::optional<Scratch> scratch{};                    ///< of the running frame
    std::optional<ImageOf<Storage, Output>> sharpened{}; ///< where there is sharpening
    Extent extent;                                       ///< of the output
    std::optional<ImageOf<Storage, Output>> output{};    ///< where it is not written to the host's memory
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/blend/running_mean.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/run.hpp>

#include <tuple>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Whether values of a channel may be negative by what it is: directions, places and ways.
template <class C>
inline constexpr bool may_be_negative = std::is_same_v<C, Normal> || std::is_same_v<C, IndirectDirection> ||
                                        std::is_base_of_v<WorldPoint, C> || std::is_base_of_v<ScreenVector, C>;

/// Puts accumulated values in the place of a frame's own, where those are values.
template <class From, class To> struct SteadyJob {
    static constexpr auto name = "steady guide";
    From from;
    To to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const own = load_pixels<Real>(to, x, y);
        store_pixels<Real>(to, x, y, select(all_finite(own), load_pixels<Real>(from, x, y), own), count);
    }
};
} // namespace detail

/// Guides that are noisy themselves, made steady before a pipeline reads them: each is accumulated along its motion. For pictures whose
/// samples of a pixel see different things, frame by frame: out of focus, behind a pane or a veil, in fur. There a pixel's depth jumps, and
/// history and neighbours are refused that would have been right.
///
///     SteadyGuides<Channels<Depth>> steady{size};
///     for (;;) { render(frame); steady.apply(frame); show(run(denoise, frame, history)); }
///
/// It has no test of its own, so that what moves before other things leaves a trail of `cap` frames in these guides. Don't use it where
/// guides have no noise.
/// @tparam Set     Channels<...>: guides that are never negative, such as Depth, Albedo and Roughness
/// @tparam Storage of the histories
template <class Set, ImageStorage Storage = Planar<>> class SteadyGuides;
/// Guides that are noisy themselves, accumulated along their motion.
template <class... Cs, class Storage> class SteadyGuides<Channels<Cs...>, Storage> {
    static_assert(
        !(detail::may_be_negative<Cs> || ...),
        "SteadyGuides<Channels<...>>: guides that may be negative, such as normals, positions and motion, cannot be accumulated so");
    template <class C> static constexpr auto accumulation(float cap) {
        return Pipeline{C{}, Temporal{SurfaceMotion<AllOf<>>{}, RunningMean{.cap = cap}}};
    }
    template <class C> using HistoryOf = History<decltype(accumulation<C>(1.f)), Storage>;

    std::tuple<HistoryOf<Cs>...> histories;

public:
    float cap = 8.f; ///< frames that guides are the mean of, at most

    /// Histories of guides.
    /// @param size of the frames, in pixels
    /// @throws Error for a size of no pixels
    explicit SteadyGuides(Extent size) : histories(HistoryOf<Cs>{size, accumulation<Cs>(1.f), Storage{}}...) {}

    /// Replaces the frame's guides. What is not finite stays: the depth where nothing is seen.
    /// @param frame    with images of its own, and motion
    /// @param executor runs the kernels
    /// @throws Error as run() does
    template <class Set, class FrameStorage, class E = Simd> void apply(Frame<Set, FrameStorage>& frame, E const& executor = {}) {
        static_assert(owns_memory<FrameStorage>(),
                      "SteadyGuides: apply(frame) writes the frame's guides: it must have images of its own, and "
                      "not Borrowed ones");
        (apply_to<Cs>(frame, executor), ...);
    }
    /// Drops what it remembers: for cuts.
    void forget() { (std::get<HistoryOf<Cs>>(histories).forget(), ...); }
    /// What its histories take.
    [[nodiscard]] std::size_t bytes() const { return (std::size_t{0} + ... + std::get<HistoryOf<Cs>>(histories).bytes()); }

private:
    template <class C> void apply_to(auto& frame, auto const& executor) {
        auto const from = run(accumulation<C>(cap), frame, std::get<HistoryOf<C>>(histories), executor);
        auto const to = frame[C{}].view();
        detail::run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height},
                               detail::SteadyJob<std::remove_const_t<decltype(from)>, std::remove_const_t<decltype(to)>>{from, to});
        detail::submit_queue(executor);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/pipeline/stand_ins.hpp>
#include <quell/pipeline/unfinished.hpp>
#include <quell/pipeline/window.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What the denoiser before has made, in a pipeline that stands behind it in a Chain.
struct Denoised : Colour {
    static constexpr auto name = "denoised"; ///< of the channel
};
inline constexpr Denoised denoised; ///< of a frame, and of a pixel

namespace detail {
template <class P> inline constexpr bool is_link = false;
template <class... Parts> inline constexpr bool is_link<Pipeline<Denoised, Parts...>> = true;
} // namespace detail

/// Denoisers one behind the other. The first is a Pipeline, a Composite, a ByEvidence or a TwoSided, each of the others a Pipeline of the
/// channel `denoised`: what the one before has made, at every pixel. Their policies read the frame's channels too, such as the samples.
/// Used like a Pipeline:
///
///     constexpr auto denoise = Chain{presets::general(radiance), Pipeline{denoised, Spatial{Sharpen{}}}};
///     Frame frame{size, denoise};    History history{size, denoise};    run(denoise, frame, history);
///
/// All have one pool of images. Passes of a link are the same types behind any first denoiser with the same storage.
/// @tparam First a Pipeline, a Composite, a ByEvidence or a TwoSided, of three components
/// @tparam Links Pipelines of `denoised`
template <class First, class... Links> struct Chain {
    static_assert((detail::PlainPipeline<First> || detail::is_two_sided<First>)&&(detail::is_link<Links> && ...) && sizeof...(Links) > 0,
                  "Chain{first, links...}: the first is a Pipeline, a Composite, a ByEvidence or a TwoSided, each of the others a "
                  "Pipeline{quell::denoised, ...}");
    static_assert(First::Output::components == 3, "Chain{first, links...}: the first must make a colour, of three components");
    using Output = typename First::Output; ///< channel of the picture
    using reads = decltype(typename First::reads{} |
                           without<reads_of<Links...>, Channels<Denoised>>{});      ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = First::motion_convention; ///< what the host's motion vectors mean: see Supplied
    static_assert(((!Links::reads::template has<Motion> || Links::motion_convention == motion_convention) && ...),
                  "Chain{first, links...}: one frame has vectors of one convention: give each pipeline the same Supplied<>");
    static constexpr bool needs_camera = First::needs_camera || (Links::needs_camera || ...); ///< whether frame.camera must be set
    static constexpr bool checks_jitter =
        First::checks_jitter || (Links::checks_jitter || ...); ///< whether frame.camera.jitter must be in range

    First first;                ///< the denoiser
    std::tuple<Links...> links; ///< what stands behind, in order

    /// @param f the denoiser
    /// @param l what stands behind it
    constexpr explicit Chain(First const& f, Links const&... l) : first(f), links(l...) {}
};

namespace detail {
/// A denoiser and one more link behind it.
template <class D, class Link> constexpr auto with_link(D const& denoiser, Link const& link) { return Chain{denoiser, link}; }
template <class First, class... Links, class Link> constexpr auto with_link(Chain<First, Links...> const& chain, Link const& link) {
    return std::apply([&](auto const&... links) { return Chain{chain.first, links..., link}; }, chain.links);
}
} // namespace detail

/// The histories of all denoisers of a Chain. They share their memory.
template <class First, class... Links, ImageStorage Storage> class History<Chain<First, Links...>, Storage> {
public:
    /// @param size    of the frames
    /// @param chain   what it is of
    /// @param storage of history and scratch
    /// @throws Error for a size without pixels
    explicit History(Extent size, Chain<First, Links...> const& chain, Storage const& storage = {})
        : first(size, chain.first, storage), links(History<Links, Storage>(OpenHistory::shared_pool(first))...) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() {
        for_each([](auto& history) { history.forget(); });
    }
    /// Gives scratch back: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() {
        for_each([](auto& history) { history.release_scratch(); });
    }
    /// Those of the first.
    [[nodiscard]] Statistics statistics() const { return first.statistics(); }
    /// Memory of history and scratch, in bytes. Complete after the second frame, or when all frames that are kept are there.
    [[nodiscard]] std::size_t bytes() const { return first.bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return first.bytes_per_pixel(); }

private:
    friend struct detail::OpenHistory;
    friend struct detail::ChainRun;
    friend struct detail::Inspect;
    using OpenHistory = detail::OpenHistory;

    History<First, Storage> first;
    std::tuple<History<Links, Storage>...> links;

    void for_each(auto const& f) {
        f(first);
        std::apply([&](auto&... history) { (f(history), ...); }, links);
    }
};

namespace detail {
struct ChainRun {
    /// @param given a frame, or a window
    template <class First, class... Links, class Given, class Storage, class E, class Into>
    static auto all(Chain<First, Links...> const& chain, Given& given, History<Chain<First, Links...>, Storage>& history, E const& executor,
                    Into const& into) {
        auto const& frame = first_frame(given);
        // Checked before any denoiser runs: an error must leave all histories at the same frame.
        check_frame<Chain<First, Links...>>(frame);
        Unfinished unfinished(history);
        auto const made = run(chain.first, given, history.first, executor);
        auto const output = through<0>(made, chain.links, frame, history, executor, into);
        unfinished.finish();
        return output;
    }

private:
    template <std::size_t i, class... Links, class Set, class FrameStorage>
    static auto through(auto const& made, std::tuple<Links...> const& links, Frame<Set, FrameStorage> const& frame, auto& histories,
                        auto const& executor, auto const& into) {
        using Link = std::tuple_element_t<i, std::tuple<Links...>>;
        auto& history = std::get<i>(histories.links);
        bool const follows = OpenHistory::frames(histories.first) > 1;
        auto const seen = frame_of<Link>(made, frame, history);
        constexpr auto stages = StageOrder<Link>::count;
        if constexpr (i + 1 == sizeof...(Links))
            return run_stages<stages>(std::get<i>(links), seen, history, executor, into, follows);
        else
            return through<i + 1>(run_stages<stages>(std::get<i>(links), seen, history, executor, NoTarget{}, follows), links, frame,
                                  histories, executor, into);
    }
    template <class Link, class Storage> static auto frame_of(auto const& made, auto const& frame, History<Link, Storage> const&) {
        return with_stand_ins<typename Link::reads, Channels<Denoised>, Storage>(frame, [&](auto) { return made; });
    }
};
} // namespace detail

namespace detail {
template <class First, class... Links>
inline constexpr int kept_frames_of<Chain<First, Links...>> = std::max({kept_frames_of<First>, kept_frames_of<Links>...});
template <class First, class... Links> struct RunOf<Chain<First, Links...>> : ChainRun {};
} // namespace detail

/// Denoises one frame by all denoisers of a chain. Returns a view of the picture, valid until the next run with this history.
/// @throws Error as run() of a Pipeline does
template <class First, class... Links, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(Chain<First, Links...> const& chain, Frame<Set, FrameStorage> const& frame, History<Chain<First, Links...>, Storage>& history,
         E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename Chain<First, Links...>::reads, Set>;
    static_assert(has_channels,
                  "run(chain, frame, ...): the frame lacks a channel that the chain reads; construct the frame with this chain");
    if constexpr (!has_channels)
        return detail::NoOutput{};
    else
        return detail::ChainRun::all(chain, frame, history, executor, detail::NoTarget{});
}

/// Like run(), but writes the picture through a view of the host's, as run_into() of a Pipeline does.
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class First, class... Links, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, Chain<First, Links...> const& chain, Frame<Set, FrameStorage> const& frame,
              History<Chain<First, Links...>, Storage>& history, E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename Chain<First, Links...>::reads, Set>;
    static_assert(
        has_channels,
        "run_into(target, chain, frame, ...): the frame lacks a channel that the chain reads; construct the frame with this chain");
    static_assert(Target::components == 3, "run_into(target, chain, frame, ...): the target must have three components");
    if constexpr (has_channels && Target::components == 3) {
        detail::check_target(target.size, frame.size);
        detail::ChainRun::all(chain, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/frame/repair.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/unfinished.hpp>
#include <quell/pipeline/window.hpp>
#include <quell/resolve/anti_alias.hpp>
#include <quell/resolve/check_jitter.hpp>
#include <quell/resolve/kept_frames.hpp>

#include <algorithm>
#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Whether something stands behind a pipeline already.
template <class P> inline constexpr bool is_followed = false;
template <class P, class Policy> inline constexpr bool is_followed<Resolved<P, Policy>> = true;
template <class P, int frames> inline constexpr bool is_followed<Remodulated<P, frames>> = true;
} // namespace detail

/// A pipeline, or a Composite, whose picture is put together with anti-aliased colours: its light is what the albedo leaves of the picture,
/// and is multiplied by albedos of this frame and of those before it (AntiAliased). Edges between surfaces become as mixed as their pixels
/// are covered, those before the sky and of emitters too, whose albedo is 1.
///
///     constexpr auto denoise = presets::anti_aliased(presets::general(radiance, Demodulate{})); // a Remodulated
///     Frame frame{size, denoise};
///     History history{size, denoise};
///     auto const picture = run(denoise, frame, history);
///
/// Samples of other places come by motion, or by frame.camera.jitter.
/// @tparam P      a Pipeline or Composite whose output has three components
/// @tparam frames how many frames of the past are kept, 0 to AntiAliased::most_frames. Each takes 24 bytes a pixel, and time; the first
/// brings most. Without any, edges are smoothed by the 3x3 around alone.
template <class P, int frames = 1> struct Remodulated {
    static_assert(detail::is_pipeline<P> && !detail::is_followed<P>,
                  "Remodulated{pipeline, policy}: the first must be a Pipeline or a Composite");
    static_assert(P::Output::components == 3, "Remodulated{pipeline, policy}: the pipeline's output must be a colour of three components");
    static_assert(frames >= 0 && frames <= AntiAliased::most_frames, "Remodulated<P, frames>: it keeps 0 to 4 frames");
    using Output = typename P::Output;                                               ///< the channel of the picture
    using reads = decltype(typename P::reads{} | Channels<Albedo, Depth, Motion>{}); ///< channels that the host must supply
    static constexpr MotionConvention motion_convention = P::motion_convention;      ///< what the host's motion vectors mean: see Supplied
    static constexpr bool needs_camera = P::needs_camera; ///< whether frame.camera must be set; its jitter is used anyway
    static constexpr int past_frames = frames;            ///< that are kept
    static constexpr float most_jitter = 8.f;             ///< how far samples may lie from their pixels' centres, in pixels

    P pipeline;         ///< runs first
    AntiAliased policy; ///< how colours are anti-aliased

    /// @param p      the pipeline
    /// @param colours how its colours are anti-aliased
    constexpr explicit Remodulated(P const& p, AntiAliased const& colours = AntiAliased::of_samples(1)) : pipeline(p), policy(colours) {}
};
/// @cond
template <class P> Remodulated(P) -> Remodulated<P>;
template <class P> Remodulated(P, AntiAliased) -> Remodulated<P>;
/// @endcond

namespace detail {
struct RemodulatedRun;

/// A pixel of which nothing but the albedo is known: what a Demodulate looks at.
template <class R> struct AlbedoPixel {
    using Real = R;
    vec3<R> value;
    QUELL_KERNEL vec3<R> operator[](Albedo) const { return value; }
};

/// What is kept of a frame.
template <class Frame, class Conversion, class Kept> struct PrepareRemodulation {
    static constexpr auto name = "prepare anti-aliasing";
    Frame host;
    Conversion vectors; ///< what the host's motion means
    Kept kept;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        AlbedoPixel<Real> const px{Repair<Albedo>::repaired(vec3<Real>(load_pixels<Real>(host.view(albedo), x, y)))};
        store_pixels<Real>(kept.colour, x, y, Demodulate{}.outward(px, splat<vec3<Real>>(Real(1.f))), count);
        store_pixels<Real>(kept.depth, x, y, Repair<Depth>::repaired(load_pixels<Real>(host.view(depth), x, y)), count);
        store_pixels<Real>(kept.motion, x, y, vec2<Real>(vectors(vec2<Real>(load_pixels<Real>(host.view(motion), x, y)))), count);
    }
};
template <class Frame, class Conversion, class Kept>
PrepareRemodulation(Frame, Conversion, Kept) -> PrepareRemodulation<Frame, Conversion, Kept>;
} // namespace detail

/// The pipeline's history, and colours, depth and motion of the last frames. These lie among the pipeline's images: what it needs while it
/// runs is free afterwards.
template <class P, int frames, ImageStorage Storage> class History<Remodulated<P, frames>, Storage> {
    struct Kept {
        detail::PooledImage colour, depth, motion;
        glm::vec2 jitter{0.f};

        void take(detail::ImagePool& pool) {
            colour = pool.take(detail::format_of<Storage, Albedo>);
            depth = pool.take(detail::format_of<Storage, Depth>), motion = pool.take(detail::format_of<Storage, Motion>);
        }
        [[nodiscard]] ColouredFrame<Storage> view() const {
            using detail::view_in;
            return {view_in<Storage, Albedo>(colour), view_in<Storage, Depth>(depth), view_in<Storage, Motion>(motion), {}, jitter, false};
        }
    };

public:
    /// @param size_       of the frames
    /// @param remodulated a pipeline whose colours are anti-aliased
    /// @param storage     of the pipeline's images and of what is kept
    /// @throws Error for a size without pixels
    explicit History(Extent size_, Remodulated<P, frames> const& remodulated, Storage const& storage = {})
        : pipeline(size_, remodulated.pipeline, storage), size(size_) {}

    /// Drops all history before the next frame: for scene cuts and teleports.
    void forget() { pipeline.forget(), kept.forget(); }
    /// Gives scratch back, and what run() returned: for a host of several histories that run in turn. The next frame takes it again.
    void release_scratch() {
        output = {};
        pipeline.release_scratch();
    }
    /// Those of the pipeline.
    [[nodiscard]] Statistics statistics() const { return pipeline.statistics(); }
    /// Memory of history, scratch and output, in bytes. Complete when one frame more has run than are kept.
    [[nodiscard]] std::size_t bytes() const { return pipeline.bytes(); }
    /// The same per pixel of the frame.
    [[nodiscard]] double bytes_per_pixel() const { return static_cast<double>(bytes()) / static_cast<double>(size.pixels()); }

private:
    friend struct detail::RemodulatedRun;

    History<P, Storage> pipeline;
    KeptFrames<Kept, std::size_t{frames}> kept{};
    detail::PooledImage output{};
    Extent size; ///< of the last frame
};

namespace detail {
struct RemodulatedRun {
    static auto& of_pipeline(auto& history) { return history.pipeline; }
    /// Runs the pipeline, then multiplies its light by anti-aliased colours. Returns a view of the output; that is `target`, if it isn't
    /// NoTarget.
    /// @param given a frame, or a window
    template <class P, int frames, class Given, class Storage, class E, class Target>
    static auto all(Remodulated<P, frames> const& remodulated, Given& given, History<Remodulated<P, frames>, Storage>& history,
                    E const& executor, Target const& target) {
        auto const& frame = first_frame(given);
        check_frame<Remodulated<P, frames>>(frame);
        check_jitter(frame.camera.jitter, Remodulated<P, frames>::most_jitter);
        if (!(history.size == frame.size)) history.kept = {};
        history.size = frame.size;
        history.kept.start(frame.number);
        auto& kept = history.kept.place();
        history.output = {}, kept = {}; // while the pipeline runs, they are its scratch
        Unfinished unfinished(history);
        auto const picture = run(remodulated.pipeline, given, history.pipeline, executor);

        auto& pool = OpenHistory::pool(history.pipeline);
        kept.take(pool), kept.jitter = frame.camera.jitter;
        // Before the first pass, since it may fail for want of memory: passes in a queue are those of a whole frame.
        auto const output = [&] {
            if constexpr (std::is_same_v<Target, NoTarget>) {
                history.output = pool.take(format_of<Storage, typename P::Output>);
                return view_in<Storage, typename P::Output>(history.output);
            } else
                return target;
        }();
        auto const now = kept.view();
        auto const past = history.kept.before();
        VectorConversion<P::motion_convention> const vectors(frame.size, kept.jitter, (past.empty() ? kept : past[0]).jitter);
        run_or_enqueue(executor, Region{0, 0, frame.size.width, frame.size.height},
                       PrepareRemodulation{frame.views(Channels<Albedo, Depth, Motion>{}), vectors, now});

        std::array<ColouredFrame<Storage>, std::size_t{frames}> before;
        std::transform(past.begin(), past.end(), before.begin(), [](auto const& each) { return each.view(); });
        run_anti_alias<E, Storage>(remodulated.policy, executor, now, std::span(before).first(past.size()), {},
                                   LightOfPicture{picture, now.colour}, output);
        submit_queue(executor);
        history.kept.finish();
        unfinished.finish();
        return output;
    }
};
} // namespace detail

namespace detail {
template <class P, int frames> struct RunOf<Remodulated<P, frames>> : RemodulatedRun {};
template <class P, int frames> inline constexpr int kept_frames_of<Remodulated<P, frames>> = frames;
template <class P, int frames> struct PassesOf<Remodulated<P, frames>> {
    static void append(auto& passes, Remodulated<P, frames> const& remodulated, auto& history) {
        PassesOf<P>::append(passes, remodulated.pipeline, RemodulatedRun::of_pipeline(history));
        auto const picture = passes.back().denoises;
        passes.push_back({.name = "prepare anti-aliasing",
                          .denoises = picture,
                          .reads = {Albedo::name, Depth::name, Motion::name},
                          .writes = {"colours", Depth::name, Motion::name},
                          .keeps = {"colours", Depth::name, Motion::name}});
        passes.push_back({.name = "anti-alias",
                          .denoises = picture,
                          .farthest_tap = anywhere,
                          .reads = {"output", "colours", Depth::name, Motion::name},
                          .reads_past = {"colours", Depth::name, Motion::name},
                          .writes = {"output"}});
    }
};
} // namespace detail

/// Denoises one frame and anti-aliases its colours. Returns a view of the picture, valid until the next run with this history.
/// @param remodulated the pipeline, and how its colours are anti-aliased
/// @param frame    its camera's jitter says where its samples lie
/// @param history  of this Remodulated
/// @param executor as that of run() of a Pipeline
/// @throws Error as run() of a Pipeline does, and for a jitter of more than 8 pixels or one that is not finite
template <class P, int frames, class Set, class FrameStorage, class Storage, Executor E = Simd>
auto run(Remodulated<P, frames> const& remodulated, Frame<Set, FrameStorage> const& frame,
         History<Remodulated<P, frames>, Storage>& history, E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename Remodulated<P, frames>::reads, Set>;
    static_assert(has_channels, "run(remodulated, frame, ...): the frame lacks a channel that the pipeline or the anti-aliasing reads "
                                "(albedo, depth, motion); construct the frame with this Remodulated");
    if constexpr (!has_channels)
        return detail::NoOutput{};
    else
        return detail::RemodulatedRun::all(remodulated, frame, history, executor, detail::NoTarget{});
}

/// Like run(), but writes the picture through a view of the host's, as run_into() of a Pipeline does.
/// @param target      where the picture goes
/// @param remodulated as for run()
/// @param frame       as for run()
/// @param history     as for run()
/// @param executor    as for run()
/// @throws Error as run() does, and for a target that is not of the frame's size
template <class P, int frames, class Set, class FrameStorage, class Storage, ImageView Target, Executor E = Simd>
void run_into(Target const& target, Remodulated<P, frames> const& remodulated, Frame<Set, FrameStorage> const& frame,
              History<Remodulated<P, frames>, Storage>& history, E const& executor = {}) {
    constexpr bool has_channels = contained_in<typename Remodulated<P, frames>::reads, Set>;
    static_assert(has_channels, "run_into(target, remodulated, frame, ...): the frame lacks a channel that the pipeline or the "
                                "anti-aliasing reads (albedo, depth, motion); construct the frame with this Remodulated");
    static_assert(Target::components == 3, "run_into(target, remodulated, frame, ...): the target must have three components");
    if constexpr (has_channels && Target::components == 3) {
        detail::check_target(target.size, frame.size);
        detail::RemodulatedRun::all(remodulated, frame, history, executor, target);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

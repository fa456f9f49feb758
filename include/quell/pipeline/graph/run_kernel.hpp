#pragma once

#include <quell/pipeline/fill_holes.hpp>
#include <quell/pipeline/graph/check_frame.hpp>
#include <quell/pipeline/graph/complete_ingest.hpp>
#include <quell/pipeline/graph/copy_jobs.hpp>
#include <quell/pipeline/graph/frame_pass.hpp>
#include <quell/pipeline/graph/frame_views.hpp>
#include <quell/pipeline/graph/job.hpp>
#include <quell/pipeline/pipeline.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The functions that run a pipeline's passes, for one type of frame, storage, executor and target.
template <class P, class FrameT, class Storage, class E, class Into> struct Kernels;
template <class P, class Set, class FrameStorage, class Storage, class E, class Into>
struct Kernels<P, Frame<Set, FrameStorage>, Storage, E, Into> {
    using FrameT = Frame<Set, FrameStorage>;
    using SignalView = ViewOf<Storage, typename P::Signal>;
    static constexpr bool queued = QueueExecutor<E>;
    using Vectors = VectorConversion<P::motion_convention>;

    /// What a pass sees: views of exactly the channels that it declares.
    /// @tparam marks whether it sees marks of missing samples
    template <class Pass, bool marks>
    using ScopeOf =
        Scope<Views<FrameStorage, common_to<decltype(reads_of<Pass>{} | typename P::known_samples{}), Set>>,
              Views<Storage, common_to<reads_of<Pass>, typename P::made>>, SignalView, SignalView,
              Views<Storage, decltype(keeps_of<Pass>{} | reads_kept_of<Pass>{})>, RememberedViewsOf<Storage, remembers_of<Pass>>,
              PassTraits{.marks_missing = marks,
                         .has_camera = needs_camera_of<Pass>,
                         .reads_past_signal = is_temporal<Pass> || says_reads_past_signal<Pass>,
                         .fraction = fraction_of<Pass>},
              Vectors>;
    /// For the end of the last pass: what demodulation reads, and what the history remembers.
    using EndScope =
        Scope<Views<FrameStorage, decltype(reads_of<typename P::Form>{} | typename P::remembers{})>, Views<Storage, Channels<>>, SignalView,
              SignalView, Views<Storage, Channels<>>, RememberedViewsOf<Storage, Channels<>>, PassTraits{}, Vectors>;

    template <class Pass> static constexpr bool makes_signal = makes_signal_of<Pass, ScopeOf<Pass, true>>;

    /// @param repaired copies that stand in for the host's guides
    template <class Pass, bool marks> static auto job_of(PassArguments const& a, ImageTable const& repaired) {
        using S = ScopeOf<Pass, marks>;
        using Made = decltype(emits_of<Pass>{} | keeps_of<Pass>{});
        constexpr bool keeps_marks = marks && P::has_temporal && !is_temporal<Pass> && !std::is_same_v<Pass, FillHoles>;
        auto const made = a.images.made_out.template views<Storage>(Made{});
        auto const scope = scope_of<S, Pass>(a, repaired);
        auto const end = finish(a, repaired);
        return PassJob<Pass, S, SignalView, std::remove_const_t<decltype(made)>, std::remove_const_t<decltype(end)>, typename P::remembers,
                       keeps_marks>{.pass = kernel<Pass>(a),
                                    .scope = scope,
                                    .signal = view_in<Storage, typename P::Signal>(a.images.signal_out),
                                    .made = made,
                                    .finish = end,
                                    .store_signal = a.stores.signal,
                                    .store_output = a.stores.output,
                                    .store_remembered = a.stores.guides,
                                    .stored_channels = stored(Made{}, a.images.made_out),
                                    .counts = a.counts};
    }
    /// Whether only the device knows what a pass reads: it reads guides, itself or in the last pass's end, in a queue. The ingest reads the
    /// host's.
    template <class Pass>
    static constexpr bool is_late =
        queued && !std::is_same_v<Pass, decltype(P::ingest)> &&
        (common_to<CopiedGuides, reads_of<Pass>>::size > 0 ||
         (makes_signal<Pass> && common_to<CopiedGuides, decltype(reads_of<typename P::Form>{} | typename P::remembers{})>::size > 0));
    template <class Pass, bool marks> static auto listed_job_of(PassArguments const& a) {
        auto const job = job_of<Pass, marks>(a, a.images.repaired);
        if constexpr (is_late<Pass>)
            return LateJob<std::remove_const_t<decltype(job)>>{job_of<Pass, marks>(a, ImageTable{}), job, &a.queued->first.guides};
        else
            return job;
    }
    template <class Pass, bool marks> using JobOf = decltype(listed_job_of<Pass, marks>(std::declval<PassArguments const&>()));

    template <class Pass, bool marks> static void make_job(PassArguments const& a, std::byte* to) {
        auto const job = listed_job_of<Pass, marks>(a);
        static_assert(std::is_trivially_copyable_v<JobOf<Pass, marks>>, "views, policies and camera of a pass are plain data");
        std::memcpy(to, &job, sizeof(job));
    }
    template <class Pass, bool marks> static void run(Region region, std::byte const* job, void const* executor) {
        run_or_enqueue(*static_cast<E const*>(executor), region, from_bytes<JobOf<Pass, marks>>(job));
    }

    template <ChannelTag C> static void repair(TypedByKernel const& typed, PooledImage const& copy) {
        auto const& frame = frame_in(typed);
        static_cast<E const*>(typed.executor)
            ->for_each_pixel(Region{0, 0, frame.size.width, frame.size.height}, repair_job<C>(typed, copy));
    }

    /// What repairs a guide; null for a queue, which does it on the device.
    template <ChannelTag C> static constexpr auto repair_of() -> void (*)(TypedByKernel const&, PooledImage const&) {
        if constexpr (queued)
            return nullptr;
        else
            return &repair<C>;
    }
    /// What completes the ingest in a queue; null for other executors.
    static constexpr auto complete_ingest_of() -> void (*)(IngestCompletionArguments const&) {
        if constexpr (queued)
            return &complete_ingest;
        else
            return nullptr;
    }

    /// What copies that which is carried; null where images are handed on, as all executors do but those that need each frame to have
    /// images of its own.
    static constexpr auto carry_of() -> decltype(PassList::carry) {
        if constexpr (P::carries::size > 0 && requires { requires E::needs_own_images; })
            return [](TypedByKernel const& typed, ImagePool& pool, ImageTable const& then, ImageTable& now, bool has_past) {
                copy_carried(typed, pool, then, now, has_past, typename P::carries{});
            };
        else
            return nullptr;
    }

private:
    template <class... Cs>
    static void copy_carried(TypedByKernel const& typed, ImagePool& pool, ImageTable const& then, ImageTable& now, bool has_past,
                             Channels<Cs...> carried) {
        ((now[&channel_info<Cs>] = pool.take(format_of<Storage, Cs>)), ...);
        auto const size = frame_in(typed).size;
        static_cast<E const*>(typed.executor)
            ->for_each_pixel(Region{0, 0, size.width, size.height},
                             CarryJob{then.template views<Storage>(union_of<Channels<typename Cs::later>...>{}),
                                      now.template views<Storage>(union_of<Channels<typename Cs::kept>...>{}),
                                      now.template views<Storage>(carried), has_past});
    }
    static void complete_ingest(IngestCompletionArguments const& a) {
        auto const again = job_of<decltype(P::ingest), false>(a.ingest, a.ingest.images.repaired);
        auto const fill = job_of<FillHoles, true>(a.fill, ImageTable{}), fill_back = job_of<FillHoles, true>(a.fill_back, ImageTable{});
        constexpr bool changes_samples = reads_of<typename P::Form>::template has<Albedo>;
        auto const enqueue = [&](auto const& repairs) {
            auto const size = a.ingest.facts.size;
            static_cast<E const*>(a.ingest.typed.executor)
                ->enqueue_grid(Region{0, 0, size.width, size.height},
                               IngestCompletion<std::remove_const_t<decltype(again)>, std::remove_const_t<decltype(fill)>,
                                                std::remove_cvref_t<decltype(repairs)>>{
                                   repairs, again, fill, fill_back, a.ingest.queued, changes_samples ? number_of_guide<Albedo>() : -1,
                                   size.pixels(), a.ingest.facts.has_past && P::has_temporal});
        };
        if constexpr (std::is_void_v<StorageOfCopies<FrameStorage>>)
            enqueue(guide_repairs());
        else
            [&]<class... Cs>(Channels<Cs...>) {
                enqueue(guide_repairs(repair_job<Cs>(a.ingest.typed, *a.ingest.images.repaired.find(&channel_info<Cs>))...));
            }(common_to<CopiedGuides, typename P::reads>{});
    }
    template <ChannelTag C> static auto repair_job(TypedByKernel const& typed, PooledImage const& copy) {
        auto const to = view_in<StorageOfCopies<FrameStorage>, C>(copy);
        return RepairJob<C, ViewOf<FrameStorage, C>, std::remove_const_t<decltype(to)>>{frame_in(typed)[C{}].view(), to};
    }
    static FrameT const& frame_in(TypedByKernel const& typed) { return *static_cast<FrameT const*>(typed.frame); }

    template <class Pass> static Pass kernel(PassArguments const& a) {
        if constexpr (std::is_same_v<Pass, FillHoles>)
            return {a.step};
        else
            return from_bytes<Pass>(a.kernel);
    }
    template <class T> static T from_bytes(std::byte const* memory) {
        alignas(T) std::array<std::byte, sizeof(T)> bytes;
        std::memcpy(bytes.data(), memory, sizeof(T));
        return std::bit_cast<T>(bytes);
    }
    /// A bit for each channel, in order: whether it has an image.
    template <class... Cs> static unsigned stored(Channels<Cs...>, ImageTable const& images) {
        unsigned bits = 0, next = 1;
        ((bits |= images.find(&channel_info<Cs>) ? next : 0, next <<= 1), ...);
        return bits;
    }
    template <class S, class Pass> static S scope_of(PassArguments const& a, ImageTable const& repaired) {
        auto const& facts = a.facts;
        auto const& then = a.images.then;
        FrameViews<Set, FrameStorage> const given{frame_in(a.typed), repaired};
        return {.size = divided(facts.size, S::fraction),
                .frame_size = facts.size,
                .frame = given.of(typename S::frame_channels{}),
                .made = a.images.made.template views<Storage>(typename S::made_channels{}),
                .signal = view_in<Storage, typename P::Signal>(a.images.signal),
                .signal_then = view_in<Storage, typename P::Signal>(then.signal),
                .kept_then = then.kept.template views<Storage>(typename S::kept_channels{}),
                .remembered = then.guides.template views<Storage>(typename StoredChannels<remembers_of<Pass>>::type{}),
                .clip_from_world = facts.clip_from_world,
                .clip_from_world_then = facts.clip_from_world_then,
                .rays = facts.rays,
                .rays_then = facts.rays_then,
                .jitter = facts.jitter,
                .jitter_then = facts.jitter_then,
                .shutter = facts.shutter,
                .shutter_then = facts.shutter_then,
                .frame_index = facts.frame_index,
                .has_past = facts.has_past && (then.signal || !P::has_temporal) && then.kept.has_all(typename S::kept_channels{}),
                .vectors = vectors(facts)};
    }
    static Vectors vectors(FrameFacts const& facts) { return {facts.size, facts.jitter, facts.jitter_then}; }

    static auto finish(PassArguments const& a, ImageTable const& repaired) {
        FrameViews<Set, FrameStorage> const given{frame_in(a.typed), repaired};
        EndScope const scope{.size = a.facts.size, .frame = given.of(typename EndScope::frame_channels{}), .vectors = vectors(a.facts)};
        auto const guides = a.images.guides_out.template views<Storage>(typename StoredChannels<typename P::remembers>::type{});
        auto const ending = [&]<class Target>(Target const& target) {
            return Finish<typename P::Form, EndScope, Target, std::remove_const_t<decltype(guides)>>{
                .modulation = static_cast<P const*>(a.typed.pipeline)->ingest.modulation,
                .scope = scope,
                .output = target,
                .remembered = guides};
        };
        if constexpr (std::is_same_v<Into, NoTarget>)
            return ending(view_in<Storage, typename P::Output>(a.images.output));
        else
            return ending(*static_cast<Into const*>(a.typed.target));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

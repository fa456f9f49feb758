#pragma once

#include <quell/pipeline/graph/history_images.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What run() takes of the host's frame, beside its images.
struct FrameInput {
    Extent size;
    Camera const& camera;
    std::optional<long long> number;
    float shutter;
    bool needs_camera; ///< whether passes look at the camera
    bool follows;      ///< whether passes without a past of their own count as behind the frame before
};

/// Runs one frame through a list of passes: takes images for what each makes, and gives them back behind the last pass that reads them.
class PassRunner {
    PassList const& list;
    HistoryImages& history;
    TypedByKernel const& typed;
    FrameFacts facts;
    PooledImage signal;
    bool nothing_seen = false; ///< whether all samples are missing
    bool is_complete = false;  ///< else an error has ended the frame

public:
    PassRunner(HistoryImages& h, TypedByKernel const& t, FrameInput const& frame) : list(h.passes.list()), history(h), typed(t) {
        facts.has_past = history.start(frame.size, frame.number) || (frame.follows && !list.has_past);
        auto const& then = history.then;
        auto const& camera_then = facts.has_past ? then.camera : frame.camera;
        facts.size = frame.size;
        facts.clip_from_world = frame.camera.clip_from_world(), facts.clip_from_world_then = camera_then.clip_from_world();
        if (frame.needs_camera) facts.rays = PixelRays(frame.camera, frame.size), facts.rays_then = PixelRays(camera_then, frame.size);
        facts.jitter = frame.camera.jitter, facts.jitter_then = then.camera.jitter;
        facts.shutter = frame.shutter, facts.shutter_then = then.shutter;
        facts.frame_index = static_cast<std::int32_t>(frame.number.value_or(history.counted.frames));
        history.now.camera = frame.camera, history.now.shutter = frame.shutter, history.now.number = frame.number;
    }
    ~PassRunner() {
        if (typed.queue && !is_complete) drop_queued();
        history.drop_scratch();
    }
    PassRunner(PassRunner const&) = delete;
    PassRunner& operator=(PassRunner const&) = delete;

    void run() {
        // What the next frame sees of frames farther back: the images are handed on.
        if (!list.carry)
            for (ChannelId const each : list.carries)
                if (auto const* const its = history.then.kept.find(each->later)) history.now.kept[each] = *its;
        if (typed.queue)
            enqueue_ingest();
        else
            ingest();
        history.listed.clear();
        for (std::size_t i = 0; i < list.passes.size(); ++i) run_listed(i);
        if (typed.run_list) typed.run_list(typed.executor, history.listed.complete());
        if (typed.queue) typed.queue->submit(typed.executor);
        end();
        is_complete = true;
    }

private:
    /// What waits in a queue must not run: the host may release its images.
    void drop_queued() {
        typed.queue->drop(typed.executor);
        history.late.queue = nullptr;
    }
    void ingest() {
        auto &first = history.counts->first, &again = history.counts->again;
        first.reset(), again.reset();
        run_pass(list.ingest, {.signal = true}, &first);
        bool const repeat = repair(first.guides);
        if (repeat) run_pass(list.ingest, {.signal = true}, &again);
        auto& counts = repeat ? again : first;
        history.note(first.guides, counts);
        nothing_seen = counts.missing == facts.size.pixels();
        if (nothing_seen && history.then.signal) run_pass(list.fill_holes, {.signal = true}, nullptr, 0);
        for (int step = 2; counts.holes > 0 && !nothing_seen; step *= 2)
            counts.holes = 0, run_pass(list.fill_holes, {.signal = true}, &counts, step);
    }
    /// The same without looking at counts: the queue does.
    void enqueue_ingest() {
        auto* const counts = history.counts.get();
        typed.queue->clear(typed.executor, counts, sizeof(*counts));
        run_pass(list.ingest, {.signal = true}, &counts->first);
        for (auto const& each : list.repairs) history.repaired[each.id] = history.pool->take(each.format);
        auto const other = history.pool->take(list.signal);
        auto const images = [&](PooledImage const& from, PooledImage const& to) {
            return PassImages{.repaired = history.repaired,
                              .made = history.made,
                              .signal = from,
                              .then = history.then,
                              .signal_out = to,
                              .made_out = history.made_out,
                              .guides_out = history.now.guides,
                              .output = history.output};
        };
        auto const again = images(other, signal), fill = images(signal, other), fill_back = images(other, signal);
        auto const arguments = [&](FramePass const& pass, PassImages const& of, Counts* counted) {
            return PassArguments{list.kernels.data() + pass.kernel, facts, typed, of, {.signal = true}, counted, 0, counts};
        };
        list.complete_ingest({arguments(list.ingest, again, &counts->again), arguments(list.fill_holes, fill, counts->filled),
                              arguments(list.fill_holes, fill_back, counts->filled)});
        history.late.await(typed);
        // Whether the next frame has a past hangs on what this one sees, if it has none itself.
        if (list.has_past && !facts.has_past) {
            history.take_late_counts();
            history.late.await(typed); // the rest of the frame is to come
            nothing_seen = history.counted.missing_samples == facts.size.pixels();
        }
    }
    /// Repairs each guide of which one is counted. Returns whether samples change by it.
    bool repair(GuideCounts const& impossible) {
        bool samples_change = false;
        for (auto const& each : list.repairs) {
            if (impossible.of(each.number) == 0) continue;
            auto& copy = history.repaired[each.id];
            copy = history.pool->take(each.format);
            each.run(typed, copy);
            samples_change = samples_change || each.changes_samples;
        }
        return samples_change;
    }

    void run_listed(std::size_t i) {
        auto const& pass = list.passes[i];
        bool const last = i + 1 == list.passes.size();
        for (auto const& each : pass.makes)
            if (list.is_wanted(each.id, i)) history.made_out[each.id] = history.pool->take(each.format, each.id->fraction);
        PassStores stores{.signal = list.stores_signal(i)};
        if (last) {
            take_guides(pass);
            stores.guides = list.guide_count > 0;
        }
        run_pass(pass, stores, nullptr, 0, true, last);
        if (pass.feeds_history) history.now.signal = signal;
        for (auto const& each : pass.makes) history.made[each.id] = std::exchange(history.made_out[each.id], {});
        drop_unread(i);
    }
    /// @param listed whether a ListExecutor may run it later
    void run_pass(FramePass const& pass, PassStores stores, Counts* counts, int step = 0, bool listed = false, bool last = false) {
        auto next = signal;
        if (pass.makes_signal) next = stores.signal ? history.pool->take(list.signal) : PooledImage{};
        if (last) take_output(next, stores);
        PassImages const images{.repaired = history.repaired,
                                .made = history.made,
                                .signal = signal,
                                .then = history.then,
                                .signal_out = next,
                                .made_out = history.made_out,
                                .guides_out = history.now.guides,
                                .output = history.output};
        PassArguments const arguments{list.kernels.data() + pass.kernel,           facts, typed, images, stores, counts, step,
                                      typed.queue ? history.counts.get() : nullptr};
        if (listed && typed.run_list)
            history.listed.add(pass, arguments);
        else
            run_now(pass, arguments);
        signal = next;
    }
    void run_now(FramePass const& pass, PassArguments const& arguments) {
        history.job.resize(std::max(history.job.size(), pass.job_bytes));
        pass.make_job(arguments, history.job.data());
        auto const size = divided(facts.size, pass.fraction);
        pass.run({0, 0, size.width, size.height}, history.job.data(), typed.executor);
    }
    /// The last pass also writes the guides for the next frame. Those of the last frame that it doesn't read are overwritten in place,
    /// unless a copy of that frame's state holds them too.
    void take_guides(FramePass const& last) {
        if (facts.has_past && last.reads_remembered.size() == 0 && !history.then.guides.is_shared())
            history.now.guides.swap(history.then.guides);
        else
            for (int i = 0; i < list.guide_count; ++i) {
                auto const& guide = list.guides[static_cast<std::size_t>(i)];
                history.now.guides[guide.id] = history.pool->take(guide.format, guide.id->fraction);
            }
    }
    /// And the output, unless that is the signal's image.
    void take_output(PooledImage const& next, PassStores& stores) {
        if (!list.has_target) {
            if (!list.demodulates) history.output = next;
            if (!history.output) history.output = history.pool->take(list.output);
        }
        stores.output = list.demodulates || list.has_target || !(history.output == next);
    }

    /// Gives back what no pass behind pass i reads.
    void drop_unread(std::size_t i) {
        history.made.drop_if([&](ChannelId made) { return !list.keeps.has(made) && !list.is_read_behind(made, i); });
        for (auto next = i + 1; next < list.passes.size(); ++next)
            if (list.passes[next].reads_past()) return;
        history.then.signal = {};
        if (!list.carry) history.then.kept.drop_all();
    }

    void end() {
        for (ChannelId const kept : list.keeps) history.now.kept[kept] = history.made[kept];
        if (list.carry) list.carry(typed, *history.pool, history.then.kept, history.now.kept, facts.has_past);
        // Where there are not as many frames yet, the first stands for those before it.
        for (ChannelId const each : list.carries)
            if (auto const its = history.now.kept[each->later]; !history.now.kept.find(each)) history.now.kept[each] = its;
        history.advance();
        // What no sample was ever seen of is no past.
        history.empty = !list.has_past || (!facts.has_past && nothing_seen);
        ++history.counted.frames;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/pipeline/composite.hpp>

#include <memory>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Access to the state of a history between runs.
struct Inspect {
    template <class H> static bool has_past(H const& history) { return !history.images.empty; }
    template <class H> static Camera const& camera(H const& history) { return history.images.then.camera; }
    template <class H> static std::optional<long long> number(H const& history) { return history.images.then.number; }
    template <class H> static Extent size(H const& history) { return history.images.size; }
    template <class H> static auto& histories(H& composite) { return composite.histories; }

    // Views, without a size where there is no image.
    template <class P, class Storage> static auto output(History<P, Storage> const& history) {
        return view_in<Storage, typename P::Output>(history.images.output);
    }
    /// The signal that the next frame's Temporal stage finds.
    template <class P, class Storage> static auto signal(History<P, Storage> const& history) {
        return view_in<Storage, typename P::Signal>(history.images.then.signal);
    }
    /// A channel of the last frame that the pipeline remembers as it is.
    template <class P, class Storage, ChannelTag C> static auto remembered(History<P, Storage> const& history, C) {
        return history.images.then.guides.template view<Storage, C>();
    }
    /// A channel that its policies keep.
    template <class P, class Storage, ChannelTag C> static auto kept(History<P, Storage> const& history, C) {
        return history.images.then.kept.template view<Storage, C>();
    }

    template <class H> static DiagnosisNotes& notes(H& history) {
        if (!history.notes) history.notes = std::make_shared<DiagnosisNotes>();
        return *history.notes;
    }
};

/// Calls f(type of the pipeline, history) for a pipeline, or for each pipeline of a composite.
template <class P, class Storage> void for_each_history(History<P, Storage>& history, auto&& f) { f(std::type_identity<P>{}, history); }
template <class... Ps, class Storage> void for_each_history(History<Composite<Ps...>, Storage>& history, auto&& f) {
    [&]<std::size_t... i>(std::index_sequence<i...>) { (f(std::type_identity<Ps>{}, std::get<i>(Inspect::histories(history))), ...); }
    (std::index_sequence_for<Ps...>{});
}

inline Lookup lookup(ImageView auto const& view) {
    return [view](int c, int x, int y) { return view.get(c, x, y); };
}
/// Empty for a view without an image.
Lookup lookup_in(ImageView auto const& view) { return view.size.width > 0 ? lookup(view) : Lookup{}; }

/// Empty if the frame lacks the channel or the pipeline does not read it.
template <class P, ChannelTag C, class Set, class Storage> Lookup lookup_of(Frame<Set, Storage> const& frame, C channel) {
    if constexpr (P::reads::template has<C> && Set::template has<C>)
        return lookup(frame[channel].view());
    else
        return {};
}

template <class P, class F, class H> SignalSeen signal_seen(F const& frame, H& history) {
    using Output = typename P::Output;
    auto const& counted = history.statistics();
    SignalSeen seen{.name = std::string(Output::name), .components = Output::components, .has_past = P::has_temporal};
    seen.has_stages = std::tuple_size_v<decltype(P::stages)> > 0;
    seen.demodulated = P::reads::template has<Albedo> && Output::components == 3;
    seen.blurs = P::reads::template has<Sweep> || P::reads::template has<Time>;
    seen.input = lookup_of<P>(frame, Output{});
    if (Inspect::size(history) == frame.size) seen.output_then = lookup_in(Inspect::output(history));
    seen.frames = counted.frames, seen.resets = counted.resets;
    seen.number_then = Inspect::number(history), seen.size_then = Inspect::size(history);
    seen.notes = &Inspect::notes(history);
    return seen;
}

/// What a pipeline reads and a frame has, quell's channels in the order of AllChannels, then a host's own.
template <class P, class Set>
using SeenChannels = common_to<common_to<decltype(AllChannels{} | typename P::reads{}), typename P::reads>, Set>;

/// Channels that must be finite on every surface. In others, such as Blocker, values that are not finite mean "none". A surface that was
/// behind the camera may have no motion, so channels of two components may lack 10%.
template <class P, class Set, class Storage> std::vector<GuideSeen> finite_guides(Frame<Set, Storage> const& frame) {
    std::vector<GuideSeen> guides;
    for_each_channel(SeenChannels<P, Set>{}, [&]<class C>(C c) {
        if constexpr (C::finite_on_surfaces)
            guides.push_back({std::string(C::name), C::components, lookup(frame[c].view()), C::components == 2 ? 0.1 : 0.001});
    });
    return guides;
}

/// Channels that are points in the world.
/// @tparam hit those of what a ray hit, or the others
template <class P, bool hit, class Set, class Storage> std::vector<GuideSeen> world_points(Frame<Set, Storage> const& frame) {
    std::vector<GuideSeen> guides;
    for_each_channel(SeenChannels<P, Set>{}, [&]<class C>(C c) {
        if constexpr (std::is_base_of_v<WorldPoint, C> && std::is_base_of_v<HitPoint, C> == hit)
            guides.push_back({std::string(C::name), C::components, lookup(frame[c].view()), 0.});
    });
    return guides;
}

/// Camera and depth of the last frame, from the first history that has them.
template <class P, class H> void see_past(Observation& seen, std::type_identity<P>, H const& history) {
    auto const number = Inspect::number(history);
    bool const follows = !seen.number || !number || *seen.number == *number + 1;
    // A past that run() will drop is none.
    if (!Inspect::has_past(history) || !follows || !(Inspect::size(history) == seen.size)) return;
    if (!seen.has_then) seen.has_then = true, seen.camera_then = Inspect::camera(history);
    if constexpr (P::remembers::template has<Depth>)
        if (!seen.depth_then) seen.depth_then = lookup_in(Inspect::remembered(history, depth));
}

/// Motion converted from a convention to quell's.
inline Lookup understood(Lookup const& motion, MotionConvention convention, Extent size, glm::vec2 jitter_change) {
    if (!motion || convention == MotionConvention{}) return motion;
    auto const factor = to_pixels(convention, size);
    auto const offset = convention.jitter == MotionConvention::Jitter::left_in ? jitter_change : glm::vec2(0.f);
    return [=](int c, int x, int y) { return motion(c, x, y) * factor[c] + offset[c]; };
}

template <class P, class Set, class FrameStorage, class H> Observation observe(Frame<Set, FrameStorage> const& frame, H& history) {
    Observation seen{.size = frame.size, .number = frame.number, .camera = frame.camera};
    seen.depth = lookup_of<P>(frame, depth), seen.normal = lookup_of<P>(frame, normal);
    seen.motion = lookup_of<P>(frame, motion), seen.albedo = lookup_of<P>(frame, albedo);
    seen.sweep = lookup_of<P>(frame, sweep), seen.shutter = frame.shutter;
    seen.guides = finite_guides<P>(frame);
    seen.positions = world_points<P, false>(frame);
    seen.hit_points = world_points<P, true>(frame);
    seen.convention = P::motion_convention;
    for_each_history(history, [&]<class Part>(std::type_identity<Part> part, auto& of_part) {
        seen.of_signals.push_back(signal_seen<Part>(frame, of_part));
        seen.of_signals.back().times_albedo = !std::is_same_v<P, Part> && Share<typename Part::Output>::factor::template has<Albedo>;
        see_past(seen, part, of_part);
    });
    seen.motion = understood(seen.motion, seen.convention, seen.size, seen.camera_then.jitter - seen.camera.jitter);
    return seen;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

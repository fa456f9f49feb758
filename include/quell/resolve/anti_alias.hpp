#pragma once

#include <quell/resolve/anti_alias_pass.hpp>

#include <algorithm>
#include <span>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Like anti_alias().
/// @param others a view that takes what the frames around tell, or NoOthers
template <class E, class Storage, class Light, class To, class Others = NoOthers>
void run_anti_alias(AntiAliased const& policy, E const& executor, ColouredFrame<Storage> const& here,
                    std::span<ColouredFrame<Storage> const> before, std::span<ColouredFrame<Storage> const> after, Light const& light,
                    To const& to, Others const& others = {}) {
    AntiAliasJob<Storage, Light, To, Others> job{policy, here, light, to, own_weights_of(policy, here.jitter)};
    job.others = others;
    auto const size = here.depth.size;
    for (auto const& frame : before.first(std::min(before.size(), job.before.size()))) {
        if (!(frame.depth.size == size)) break;
        job.before[static_cast<std::size_t>(job.count_before++)] = {frame.colour,  frame.depth,  frame.motion,
                                                                    frame.to_next, frame.jitter, frame.knows_next};
    }
    bool is_known = here.knows_next;
    for (auto const& frame : after.first(std::min(after.size(), job.after.size()))) {
        if (!is_known || !(frame.depth.size == size)) break;
        job.after[static_cast<std::size_t>(job.count_after++)] = {frame.colour, frame.depth,  frame.to_next,
                                                                  frame.motion, frame.jitter, true};
        is_known = frame.knows_next;
    }
    run_or_enqueue(executor, Region{0, 0, size.width, size.height}, job);
}
} // namespace detail

/// Multiplies light by a frame's colours, anti-aliased by those of frames around it.
///
/// For hosts of several signals, or of light that is added: each signal's light is multiplied by its own colours. What is added, such as
/// emission, is the colour, and 1 its light; it may change by itself, which `policy.change` is for. Hosts of one signal have
/// presets::anti_aliased(), which keeps the frames too.
/// @param policy   how
/// @param executor runs the pass
/// @param here     the frame that the light is of
/// @param before   frames before it, the nearest first, up to the first of another size; AntiAliased::most_frames of them are looked at
/// @param after    the same after it, as far as `to_next` is known; none in real time
/// @param light    a view of three components
/// @param to       a view of three components, other than the others
template <Executor E, class Storage, ImageView Light, ImageView To>
void anti_alias(AntiAliased const& policy, E const& executor, ColouredFrame<Storage> const& here,
                std::span<std::type_identity_t<ColouredFrame<Storage>> const> before,
                std::span<std::type_identity_t<ColouredFrame<Storage>> const> after, Light const& light, To const& to) {
    detail::run_anti_alias(policy, executor, here, before, after, light, to);
    detail::submit_queue(executor);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

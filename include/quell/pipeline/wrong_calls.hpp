#pragma once

#include <quell/execute/executor.hpp>
#include <quell/pipeline/history.hpp>

// Calls of run() and its like that fit none of them. Compilers would list all candidates and why each fails; these give one sentence.
namespace quell::inline QUELL_INSTRUCTION_SET {
/// @cond
namespace detail {
/// Whether these are a pipeline, a frame, a history and what follows, in that order.
template <class... Ts> inline constexpr bool in_order_of_run = false;
template <class P, class F, class H, class... More>
inline constexpr bool in_order_of_run<P, F, H, More...> = is_pipeline<P>&& is_frame<F>&& is_history<H>;
/// Whether a call with these is meant for quell: two of the three are there.
template <class... Ts>
inline constexpr bool meant_for_run = (is_pipeline<Ts> || ...) + (is_frame<Ts> || ...) + (is_history<Ts> || ...) >= 2;

using NoOutput = ViewOf<Planar<>, Radiance>; ///< so that one mistake is one error
template <class... More> NoOutput refuse_history_or_executor() {
    if constexpr (sizeof...(More) > 1)
        static_assert(sizeof...(More) == 0, "run(pipeline, frame, history, executor): there are too many arguments");
    else if constexpr (!(Executor<More> && ...))
        static_assert(sizeof...(More) == 0,
                      "run(pipeline, frame, history, executor): `executor` must have for_each_pixel(region, job), see "
                      "quell/execute/executor.hpp");
    else
        static_assert(sizeof...(More) > 1, "run(pipeline, frame, history, executor): `history` must be a variable that is not const, since "
                                           "run() changes it");
    return {};
}
} // namespace detail

template <class P, class Set, class FrameStorage, class OfHistory, class Storage, class... E>
auto run(P const&, Frame<Set, FrameStorage> const&, History<OfHistory, Storage> const&, E const&...) {
    return detail::refuse_history_or_executor<E...>();
}
template <class P, class Set, class FrameStorage, class OfHistory, class Storage, class... E>
auto accumulate(P const&, Frame<Set, FrameStorage> const&, History<OfHistory, Storage> const&, E const&...) {
    return detail::refuse_history_or_executor<E...>();
}
template <class Target, class P, class Set, class FrameStorage, class OfHistory, class Storage, class... E>
void run_into(Target const&, P const&, Frame<Set, FrameStorage> const&, History<OfHistory, Storage> const&, E const&...) {
    static_assert(ImageView<Target>, "run_into(target, pipeline, frame, history, executor): `target` must be a view of an image, such as "
                                     "image.view(), see quell/image/image_storage.hpp");
    if constexpr (ImageView<Target>) detail::refuse_history_or_executor<E...>();
}
template <class... Args>
    requires(detail::meant_for_run<Args...> && !detail::in_order_of_run<Args...>)
auto run(Args const&...) {
    static_assert(sizeof...(Args) == 0,
                  "run(pipeline, frame, history, executor): it takes a pipeline, a frame and a history, in that order");
    return detail::NoOutput{};
}
template <class... Args>
    requires(detail::meant_for_run<Args...> && !detail::in_order_of_run<Args...>)
auto accumulate(Args const&...) {
    static_assert(sizeof...(Args) == 0,
                  "accumulate(pipeline, frame, history, executor): it takes a pipeline, a frame and a history, in that order");
    return detail::NoOutput{};
}
template <class First, class... Args>
    requires(detail::meant_for_run<First, Args...> && !detail::in_order_of_run<Args...>)
void run_into(First const&, Args const&...) {
    static_assert(
        sizeof...(Args) > 99,
        "run_into(target, pipeline, frame, history, executor): it takes a view, a pipeline, a frame and a history, in that order");
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

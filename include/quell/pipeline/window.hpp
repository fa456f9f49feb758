#pragma once

#include <quell/pipeline/history.hpp>
#include <quell/pipeline/run.hpp>

#include <concepts>
#include <iterator>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// A range of frames, by number: the frame to denoise, and those after it.
template <class W>
concept Window = requires(W& window) {
    { window[0].size } -> std::convertible_to<Extent>;
    { std::size(window) } -> std::convertible_to<std::size_t>;
};
/// The frame to denoise, of a window or by itself.
template <class Given> auto& first_frame(Given& given) {
    if constexpr (Window<Given>) {
        if (std::size(given) == 0) raise_error<Failure>("run: the window", "no frames", "give the frame to denoise and those after it");
        return given[0];
    } else
        return given;
}
template <class Given> using FirstFrame = std::remove_cvref_t<decltype(first_frame(std::declval<Given&>()))>;

/// What runs a denoiser that stands behind others: all(denoiser, frame or window, history, executor, target).
template <class D> struct RunOf;
} // namespace detail

/// Denoises the first frame of a window by a TwoSided, or by what stands behind one, as run() does a frame. The window ends where frame
/// numbers do not follow each other or the size changes; it may be a single frame. The frames are changed during the call and restored;
/// images of the host's that they borrow are not written.
/// @param denoiser a TwoSided, or a Chain or Resolved of one
/// @param window   range of frames with operator[], such as std::deque<Frame<...>>
/// @param history  state between calls, which each move one frame on
/// @param executor what runs the passes
/// @throws Error for a window without frames, and as run() of a frame does
template <class D, detail::Window W, ImageStorage Storage, Executor E = Simd>
    requires detail::is_two_sided<D>
auto run(D const& denoiser, W& window, History<D, Storage>& history, E const& executor = {}) {
    using F = detail::FirstFrame<W>;
    constexpr bool has_channels = contained_in<typename D::reads, typename F::channels>,
                   has_copies = !std::is_void_v<detail::StorageOfCopies<typename F::storage>>;
    static_assert(has_channels, "run(denoiser, window, ...): the frames lack a channel that the denoiser reads, such as motion_next; "
                                "construct them with this denoiser");
    static_assert(has_copies,
                  "run(denoiser, window, ...): the frames must own their memory (Planar<>), or their storage name one that does, "
                  "`Copy`, as Borrowed<> does");
    if constexpr (has_channels && has_copies)
        return detail::RunOf<D>::all(denoiser, window, history, executor, detail::NoTarget{});
    else
        return detail::NoOutput{};
}
/// @cond
template <class D, class Set, class FrameStorage, class Storage, class... E>
    requires detail::is_two_sided<D>
auto run(D const&, Frame<Set, FrameStorage> const&, History<D, Storage>&, E const&...) {
    static_assert(sizeof(D) == 0, "run(denoiser, window, history): `window` must be a range of frames with operator[], such as "
                                  "std::deque<Frame<...>>: the frame to denoise, and those after it");
    return detail::NoOutput{};
}
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

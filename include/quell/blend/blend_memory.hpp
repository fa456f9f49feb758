#pragma once

#include <quell/core/hooks.hpp>
#include <quell/core/kernel.hpp>

#include <algorithm>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// How far back a blend policy remembers. A policy declares it with `constexpr BlendMemory memory() const`.
struct BlendMemory {
    /// After so many frames an old frame has 1/e of its first weight: the cap of a running mean, 1 / alpha of an exponential average.
    float frames = 32.f;
    /// After so many times `frames`, what was before is no longer seen. 9: its noise has to fade. Less where something else hides it.
    float times = 9.f;

    /// The same memory, of which what is hidden sooner is no longer seen: after at most so many times `frames`.
    [[nodiscard]] constexpr BlendMemory hidden_after(float most) const { return {frames, std::min(times, most)}; }
};

/// What is supposed of a blend policy that doesn't declare its memory: as long as the longest of the built-in presets.
inline constexpr BlendMemory undeclared_memory{};

namespace detail {
/// Whether a policy has another one, which it lists among its `parts`, as a member `inner`.
template <class B>
concept decorates = requires {
    requires is_part<B, decltype(B::inner)>;
};
} // namespace detail

/// How far back a blend policy remembers: what it declares; else what its member `inner` does, if that is one of its `parts`; else
/// undeclared_memory.
template <class B> [[nodiscard]] constexpr BlendMemory memory_of(B const& blend) {
    static_assert(detail::check_hooks<B>());
    if constexpr (requires { blend.memory(); }) {
        static_assert(std::is_same_v<decltype(blend.memory()), BlendMemory>,
                      "memory() of a blend policy must be `constexpr BlendMemory memory() const`, see quell/blend/blend_memory.hpp");
        return blend.memory();
    } else if constexpr (detail::decorates<B>)
        return memory_of(blend.inner);
    else
        return undeclared_memory;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

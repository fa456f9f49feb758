#pragma once

#include <quell/frame/frame.hpp>
#include <quell/frame/repair.hpp>
#include <quell/pipeline/graph/image_pool.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The storage of a frame's guides.
template <class Storage> constexpr auto storage_of_guides() {
    if constexpr (requires { typename Storage::Others; })
        return storage_of_guides<typename Storage::Others>();
    else
        return std::type_identity<Storage>{};
}
template <class Storage> using StorageOfGuides = typename decltype(storage_of_guides<Storage>())::type;

/// The storage in which copies of a host's images are made; void where there is none.
template <class Given> constexpr auto storage_of_copies() {
    using Storage = StorageOfGuides<Given>;
    if constexpr (owns_memory<Storage>())
        return std::type_identity<Storage>{};
    else if constexpr (requires { typename Storage::Copy; })
        return std::type_identity<typename Storage::Copy>{};
    else
        return std::type_identity<void>{};
}
template <class Storage> using StorageOfCopies = typename decltype(storage_of_copies<Storage>())::type;

/// Views of a frame's images, or of the copies that stand in for them.
template <class Set, class Storage> struct FrameViews {
    Frame<Set, Storage> const& frame;
    ImageTable const& repaired;

    template <class... Ds> [[nodiscard]] auto of(Channels<Ds...>) const { return Views<Storage, Channels<Ds...>>{{view<Ds>()}...}; }

private:
    using Copy = StorageOfCopies<Storage>;
    template <ChannelTag C> ViewOf<Storage, C> view() const {
        if constexpr (CopiedGuides::has<C> && !std::is_void_v<Copy>)
            if (auto const* const copy = repaired.find(&channel_info<C>)) {
                if constexpr (std::is_same_v<ViewOf<Storage, C>, ViewOf<Copy, C>>)
                    return view_in<Copy, C>(*copy);
                else if constexpr (requires { ViewOf<Storage, C>::of_copy(view_in<Copy, C>(*copy)); })
                    return ViewOf<Storage, C>::of_copy(view_in<Copy, C>(*copy));
            }
        return frame[C{}].view();
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

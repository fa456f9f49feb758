#pragma once

#include <quell/execute/executor.hpp>
#include <quell/frame/repair.hpp>
#include <quell/pipeline/execution/counts.hpp>
#include <quell/pipeline/execution/image_pool.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Copies a guide with its impossible values repaired.
template <ChannelTag C, class From, class To> struct RepairJob {
    static constexpr auto name = "repair guide";
    From from;
    To to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        store_pixels<Real>(to, x, y, Repair<C>::repaired(load_pixels<Real>(from, x, y)), count);
    }
};

/// The storage in which copies of a host's images are made.
template <class Storage> constexpr auto storage_of_copies() {
    if constexpr (owns_memory<Storage>())
        return std::type_identity<Storage>{};
    else if constexpr (requires { typename Storage::Copy; })
        return std::type_identity<typename Storage::Copy>{};
    else
        return std::type_identity<void>{};
}

/// What passes see of a frame: its images, or copies of guides that had to be repaired.
template <class Set, class Storage> class Guides {
    using Copy = typename decltype(storage_of_copies<Storage>())::type;
    /// Without a storage for copies, guides stay as they are.
    static constexpr bool can_copy = !std::is_void_v<Copy>;
    using Copied = std::conditional_t<can_copy, common_to<CopiedGuides, Set>, Channels<>>;

    Frame<Set, Storage> const& frame;
    Handles<std::conditional_t<can_copy, Copy, Planar<>>, Copied> copies{};

public:
    explicit Guides(Frame<Set, Storage> const& f) : frame(f) {}

    template <class... Ds> [[nodiscard]] auto views(Channels<Ds...>) const { return Views<Storage, Channels<Ds...>>{{view<Ds>()}...}; }

    /// Repairs each guide of which one is counted. Returns whether one of `Wanted` was repaired.
    template <class Reads, class Wanted> bool repair(GuideCounts const& impossible, ImagePool& pool, auto const& executor) {
        bool wanted = false;
        for_each_channel(common_to<Copied, Reads>{}, [&]<class C>(C c) {
            if (impossible.of(c) == 0) return;
            copies[c] = pool.template take<ImageOf<Copy, C>>();
            auto const to = copies[c].view();
            RepairJob<C, ViewOf<Storage, C>, std::remove_const_t<decltype(to)>> const job{frame[c].view(), to};
            executor.for_each_pixel(Region{0, 0, frame.size.width, frame.size.height}, job);
            wanted = wanted || Wanted::template has<C>;
        });
        return wanted;
    }

private:
    template <ChannelTag C> auto view() const {
        if constexpr (Copied::template has<C>) {
            auto const& copy = slot<C>(copies);
            if (copy) {
                if constexpr (owns_memory<Storage>())
                    return copy.view();
                else
                    return ViewOf<Storage, C>::of_copy(copy.view());
            }
        }
        return frame[C{}].view();
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

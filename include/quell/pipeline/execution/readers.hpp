#pragma once

#include <quell/core/policy.hpp>
#include <quell/core/record.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Counts, for each channel that passes make, the passes that still have to read it. At 0 its image is free.
template <class Made> class Readers;
template <class... Cs> class Readers<Channels<Cs...>> : Slot<Cs, int>... {
    template <class Pass> using OfPass = common_to<reads_of<Pass>, Channels<Cs...>>;

public:
    Readers() : Slot<Cs, int>{0}... {}
    template <class Pass> void expect() {
        for_each_channel(OfPass<Pass>{}, [&]<class C>(C) { ++slot<C>(*this); });
    }
    template <class Pass> void done() {
        for_each_channel(OfPass<Pass>{}, [&]<class C>(C) { --slot<C>(*this); });
    }
    template <class C> [[nodiscard]] bool any(C) const { return slot<C>(*this) > 0; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

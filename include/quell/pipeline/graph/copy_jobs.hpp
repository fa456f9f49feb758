#pragma once

#include <quell/execute/executor.hpp>
#include <quell/frame/frame.hpp>
#include <quell/frame/repair.hpp>

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

/// Copies what is carried one frame on; where there is no last frame, this one stands for it.
template <class Then, class Kept, class Carried> struct CarryJob {
    static constexpr auto name = "carry";
    Then then; ///< of the last frame
    Kept kept; ///< of this one
    Carried carried;
    bool has_past;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, Coordinate<Real> x, Coordinate<Real> y, int count) const {
        for_each_channel(typename Carried::channels{}, [&]<class C>(C c) QUELL_INLINED {
            store_pixels<Real>(carried.view(c), x, y,
                               has_past ? load_pixels<Real>(then.view(typename C::later{}), x, y)
                                        : load_pixels<Real>(kept.view(typename C::kept{}), x, y),
                               count);
        });
    }
};
template <class Then, class Kept, class Carried> CarryJob(Then, Kept, Carried, bool) -> CarryJob<Then, Kept, Carried>;

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

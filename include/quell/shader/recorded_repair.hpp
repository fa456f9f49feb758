#pragma once

#include <quell/frame/repair.hpp>
#include <quell/shader/pass_recorder.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The pass that repairs guides: each is copied, and later passes read the copy.
template <class F> class RecordedRepair {
    using Guides = common_to<CopiedGuides, typename F::channels>;
    Frame<Guides> copies;
    std::vector<std::pair<void const*, void const*>> stands_in; // planes of the host's, and of the copies

public:
    RecordedRepair(F const& frame, PassRecorder& recorder) : copies(frame.size) {
        for_each_channel(Guides{}, [&]<class C>(C c) {
            auto const from = frame[c].view(), to = copies[c].view();
            recorder.note(to, C::name, C::fraction);
            for (int k = 0; k < C::components; ++k) stands_in.emplace_back(from.planes[k], to.planes[k]);
        });
    }
    static constexpr bool has_some = Guides::size > 0;
    void record(F const& frame, PassRecorder& recorder) const {
        recorder.record_steps("repair guides", 1, [&](RecordedInteger x, RecordedInteger y) {
            for_each_channel(Guides{}, [&]<class C>(C c) {
                store_pixels<Recorded>(copies[c].view(), x, y, Repair<C>::repaired(load_pixels<Recorded>(frame[c].view(), x, y)), 1);
            });
        });
    }
    /// Lets all passes but the first one read the copies.
    void redirect(std::vector<RecordedPass>& passes) const {
        for (std::size_t p = 1; p < passes.size(); ++p)
            for (auto& memory : passes[p].memory)
                for (auto const& [from, to] : stands_in)
                    if (memory == from && !passes[p].takes_given_guides) memory = to;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

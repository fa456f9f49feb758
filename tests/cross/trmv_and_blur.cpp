#include "../views.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/presets/blur.hpp>

using namespace quell;

namespace {
template <class P> void same_in_packs(P const& denoise, double allowed) {
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        auto const seen = [&](auto const& executor) {
            return tests::sequence(denoise, size, executor, [&](auto& frame, unsigned i) {
                frame.camera = tests::View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
            });
        };
        auto const serial = seen(Serial{});
        CHECK(tests::all_finite(serial));
        CHECK(tests::difference(serial, seen(Outlined<>{})) < allowed);
    }
}
} // namespace

TEST_CASE("trmv computes the same one by one and in packs") { same_in_packs(presets::trmv(), 2e-4); }
TEST_CASE("blur computes the same one by one and in packs") { same_in_packs(presets::blur(radiance), 2e-5); }

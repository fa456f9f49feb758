#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/pipeline/plan.hpp>

using namespace quell;

namespace {
constexpr Extent size{61, 37};
constexpr auto give_back = light_given_back(radiance, 4.f);
} // namespace

TEST_CASE("light given back: every executor and storage makes the same picture, and as many bytes as planned") {
    auto const wanted = tests::sequence(give_back, size, Serial{});
    auto const in_packs = tests::sequence(give_back, size, Simd{});
    CHECK(tests::all_finite(wanted));
    CHECK(tests::difference(wanted, in_packs) < 1e-4);
    for (int const threads : {1, 2, 3}) CHECK(tests::sequence(give_back, size, Threads<>{.count = threads}) == in_packs);
}

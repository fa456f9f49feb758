#include "../views.hpp"

#include <quell/execute/threads.hpp>
#include <quell/presets/published.hpp>

using namespace quell;

namespace {
/// Seen by a camera that moves.
template <class P> std::vector<float> sequence(P const& denoise, Extent size, auto const& executor) {
    return tests::sequence(denoise, size, executor, [&](auto& frame, unsigned i) {
        frame.camera = tests::View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
    });
}
template <class P> void same_everywhere(P const& denoise) {
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        auto const serial = sequence(denoise, size, Serial{}), simd = sequence(denoise, size, Simd{});
        CHECK(tests::all_finite(serial));
        CHECK(tests::difference(serial, simd) < 2e-5);
        CHECK(sequence(denoise, size, Threads<>{.count = 3, .tile = {5, 3}}) == simd);
        CHECK(sequence(denoise, size, Threads<>{.count = 2, .tile = {256, 32}}) == simd);
    }
}
} // namespace

TEST_CASE("serial, SIMD and threads compute the same: shadow") { same_everywhere(presets::shadow(visibility)); }
TEST_CASE("serial, SIMD and threads compute the same: glossy") { same_everywhere(presets::glossy(glossy)); }
TEST_CASE("serial, SIMD and threads compute the same: glossy_paper") { same_everywhere(presets::glossy_paper(glossy)); }
TEST_CASE("serial, SIMD and threads compute the same: mirror_clamp") { same_everywhere(presets::mirror_clamp(glossy)); }
TEST_CASE("serial, SIMD and threads compute the same: dual_color") { same_everywhere(presets::dual_color(indirect)); }
TEST_CASE("serial, SIMD and threads compute the same: dual_cone") { same_everywhere(presets::dual_cone(indirect)); }
TEST_CASE("serial, SIMD and threads compute the same: dual_cone_paper") { same_everywhere(presets::dual_cone_paper(indirect)); }
TEST_CASE("serial, SIMD and threads compute the same: asvgf") { same_everywhere(presets::asvgf(radiance, Demodulate{})); }
TEST_CASE("serial, SIMD and threads compute the same: general") {
    same_everywhere(presets::general(radiance, Demodulate{}));
    same_everywhere(presets::general(visibility, KnownSamples{}));
    same_everywhere(presets::final_frame(radiance, Demodulate{}));
}
TEST_CASE("serial, SIMD and threads compute the same: trmv") { same_everywhere(presets::trmv()); }

#include "../frames.hpp"

#include <quell/presets/resolve.hpp>

using namespace quell;

// Compiled with -ffp-contract=off. Without it, compilers contract a * b + c of a float and of a pack in different places.
namespace {
constexpr auto pipelines = std::tuple{
    presets::surface_clamp(radiance),
    presets::svgf(radiance, Demodulate{}, SuppressFireflies{}),
    Pipeline{visibility, Temporal{FirstValid{SurfaceMotion{}, StillMotion{}}, Clamped{WithCleanUp{Adaptive{}}}, CatmullRom{}},
             Spatial{Bilateral<>{.radius = 7}}},
    presets::resolve(presets::none(radiance)),
};
} // namespace

TEST_CASE("without contraction, serial and SIMD compute the same bits") {
    auto const check = [](auto const& denoise) {
        Extent const size{45, 19};
        auto const serial = tests::sequence(denoise, size, Serial{});
        CHECK(tests::all_finite(serial));
        CHECK(serial == tests::sequence(denoise, size, Simd{}));
    };
    std::apply([&](auto const&... denoise) { (check(denoise), ...); }, pipelines);
}

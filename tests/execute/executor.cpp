#include "../frames.hpp"
#include "../threads.hpp"

#include <atomic>
#include <mutex>

using namespace quell;
using tests::sequence;

namespace {
/// Counts how often each pixel is computed.
struct Count {
    std::vector<std::atomic<int>>* hits;
    int width;
    template <class Real> void operator()(AtOnce<Real>, int x, int y, int count) const {
        for (int i = 0; i < count; ++i) ++(*hits)[static_cast<std::size_t>(y * width + x + i)];
    }
};

/// The same of a job that has a use for so many lanes.
template <int lanes> struct CountFew : Count {
    static constexpr int max_lanes = lanes;
    template <class Real> void operator()(AtOnce<Real> at_once, int x, int y, int count) const {
        // There are packs of 4 and 8 wherever there are wider ones, and none of 3.
        static_assert(lanes == 3 || width_of<Real> <= lanes);
        CHECK(count <= width_of<Real>);
        Count::operator()(at_once, x, y, count);
    }
};

template <class Job = Count, class E> void covers_once(E const& executor, Region r, Extent size) {
    std::vector<std::atomic<int>> hits(static_cast<std::size_t>(size.pixels()));
    executor.for_each_pixel(r, Job{&hits, size.width});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            bool const inside = x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
            CHECK(hits[static_cast<std::size_t>(y * size.width + x)] == (inside ? 1 : 0));
        }
}
} // namespace

static_assert(Executor<Serial> && Executor<Simd>);
#if defined(QUELL_TEST_THREADS)
static_assert(Executor<Threads<>>);
#endif

TEST_CASE("every executor computes each pixel of a region once and none outside") {
    for (Region const r : {Region{0, 0, 61, 17}, Region{3, 2, 4, 3}, Region{5, 1, 60, 16}, Region{7, 7, 7, 9}}) {
        covers_once(Serial{}, r, {61, 17});
        covers_once(Simd{}, r, {61, 17});
        covers_once<CountFew<8>>(Simd{}, r, {61, 17});
        covers_once<CountFew<4>>(Simd{}, r, {61, 17});
        covers_once<CountFew<3>>(Simd{}, r, {61, 17});
#if defined(QUELL_TEST_THREADS)
        for (Extent const tile : {Extent{256, 32}, Extent{1, 1}, Extent{13, 5}, Extent{8, 64}, Extent{0, -1}})
            covers_once(Threads<>{.count = 3, .tile = tile}, r, {61, 17});
        for (int const count : {-1, 0, 1025, 2000000000}) covers_once(Threads<>{.count = count, .tile = {16, 4}}, r, {61, 17});
#endif
    }
}

namespace {
// Every policy of the house, several to a pipeline.
constexpr auto everything = std::tuple{
    presets::none(radiance, Demodulate{}, SuppressFireflies{}),
    presets::surface(visibility),
    presets::surface_clamp(radiance),
    presets::atrous(radiance),
    presets::svgf(radiance, Demodulate{}),
    Pipeline{radiance, Spatial{Gaussian{.radius = 3}}, Temporal{StillMotion{}, Clamped{RunningMean{.cap = 4}, MinMax{}, YCoCg{}}}},
    Pipeline{visibility,
             Temporal{FirstValid{SurfaceMotion{AllOf{SameDepth{}, SameInstance{}}}, StillMotion{}}, Clamped{WithCleanUp{Adaptive{}}},
                      CatmullRom{}},
             Spatial{CleanUp{}}},
    Pipeline{radiance, Supplied<MotionConvention{.unit = MotionConvention::Unit::uv, .jitter = MotionConvention::Jitter::left_in}>{},
             Temporal{SurfaceMotion{}, Exponential{}}, Spatial{Bilateral<>{.radius = 7}},
             Spatial{Atrous{Product{NormalEdge{}, LuminanceEdge{.sigma = 0.5f}}, 2}}},
};
} // namespace

TEST_CASE("serial, SIMD and threads compute the same image, for every policy") {
    std::apply(
        [](auto const&... denoise) {
            (
                [&] {
                    Extent const size{45, 19};
                    auto const serial = sequence(denoise, size, Serial{}), simd = sequence(denoise, size, Simd{});
                    CHECK(tests::all_finite(serial));
                    CHECK(tests::difference(serial, simd) < 2e-5);
#if defined(QUELL_TEST_THREADS)
                    for (Extent const tile : {Extent{256, 32}, Extent{5, 3}, Extent{16, 1}})
                        for (int const count : {1, 2, 3}) CHECK(sequence(denoise, size, Threads<>{.count = count, .tile = tile}) == simd);
#endif
                }(),
                ...);
        },
        everything);
}

TEST_CASE("every width from 1 to 3 packs and 1") {
    constexpr auto svgf = presets::svgf(radiance, Demodulate{});
    constexpr auto clamp = presets::surface_clamp(radiance);
    for (int width = 1; width <= 3 * width_of<Pack> + 1; ++width) {
        Extent const size{width, 7};
        CHECK(tests::difference(sequence(svgf, size, Serial{}), sequence(svgf, size, Simd{})) < 2e-5);
        CHECK(tests::difference(sequence(clamp, size, Serial{}), sequence(clamp, size, Simd{})) < 2e-5);
#if defined(QUELL_TEST_THREADS)
        CHECK(sequence(svgf, size, Threads<>{.count = 2, .tile = {3, 2}}) == sequence(svgf, size, Simd{}));
#endif
    }
}

#include "../frames.hpp"

#include <baselines/presets.hpp>
#include <quell/execute/threads.hpp>

#include <algorithm>

using namespace quell;

namespace {
float const infinite = std::bit_cast<float>(0x7f800000u), not_a_number = std::bit_cast<float>(0x7fc00000u);

/// Runs a pipeline once. `fill` gets a frame in which nothing moves and all is black.
template <class P> std::vector<float> once(P const& pipeline, Extent size, auto&& fill) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    fill(frame);
    return tests::copy_of(run(pipeline, frame, history));
}
template <class F> void fill_depth([[maybe_unused]] F& frame, [[maybe_unused]] auto&& f) {
    if constexpr (F::channels::template has<Depth>) tests::fill(frame[depth], f);
}
float red(std::vector<float> const& all, Extent size, int x, int y) { return all[static_cast<std::size_t>(y * size.width + x) * 3]; }

constexpr GatherBlur gather;
constexpr TileMaxBlur tile_max;
template <class F> constexpr auto alone(F const& filter) { return Pipeline{radiance, Spatial{filter}}; }

/// Sweeps of all lengths and directions; every third pixel stands still.
auto const any_sweeps = [](auto& frame, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> pixels(-30.f, 30.f);
    tests::fill(frame[sweep], [&](int x, int y) { return (x + y) % 3 == 0 ? glm::vec2(0) : glm::vec2(pixels(random), pixels(random)); });
};
template <class P> void same_everywhere(P const& denoise) {
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        auto const serial = tests::sequence(denoise, size, Serial{}, any_sweeps), simd = tests::sequence(denoise, size, Simd{}, any_sweeps);
        CHECK(tests::all_finite(serial));
        CHECK(tests::difference(serial, simd) < 2e-5);
        CHECK(tests::sequence(denoise, size, Threads<>{.count = 3, .tile = {5, 3}}, any_sweeps) == simd);
        CHECK(tests::sequence(denoise, size, Threads<>{.count = 2, .tile = {256, 32}}, any_sweeps) == simd);
    }
}

/// The mean of the pixels that lie `step` apart on a line, as many as `count` of them around the middle one, without those outside.
double mean_along(auto const& picture, Extent size, glm::ivec2 at, glm::ivec2 step, int count) {
    double sum = 0;
    int inside = 0;
    for (int i = -count / 2; i <= count / 2; ++i) {
        auto const p = at + step * i;
        if (p.x < 0 || p.y < 0 || p.x >= size.width || p.y >= size.height) continue;
        sum += picture(p.x, p.y), ++inside;
    }
    return sum / inside;
}

/// Makes the sweep that TileMaxBlur looks along the output.
struct ShowDominant {
    using reads = Channels<DominantSweep>;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const v = px[dominant_sweep];
        return vec3<Real>{quell::abs(v.x), quell::abs(v.y), Real(0.f)};
    }
};
} // namespace

TEST_CASE("serial, SIMD and threads compute the same: gather_blur") { same_everywhere(presets::gather_blur(radiance)); }
TEST_CASE("serial, SIMD and threads compute the same: tilemax_blur") { same_everywhere(presets::tilemax_blur(radiance)); }

TEST_CASE("a constant picture stays constant, however things move, and where a sample is missing") {
    constexpr Extent size{61, 24};
    auto const check = [&](auto const& pipeline) {
        auto const out = once(pipeline, size, [](auto& frame) {
            tests::fill_randomly(frame, 1);
            any_sweeps(frame, 2);
            tests::fill(frame[radiance], [](int x, int y) { return glm::vec3(x == 20 && y == 9 ? not_a_number : 0.7f); });
        });
        for (float const a : out) REQUIRE(std::abs(a - 0.7f) < 1e-6f);
    };
    check(alone(gather)), check(alone(tile_max));
}

TEST_CASE("where nothing moves the picture keeps every bit") {
    constexpr Extent size{61, 24};
    auto const check = [&](auto const& pipeline) {
        for (auto const v : {glm::vec2(0), glm::vec2(0.3f, -0.3f), glm::vec2(not_a_number, 9.f)}) {
            std::vector<float> in;
            auto const out = once(pipeline, size, [&](auto& frame) {
                tests::fill_randomly(frame, 3);
                tests::fill(frame[sweep], [&](int, int) { return v; });
                in = tests::copy_of(frame[radiance].view());
            });
            CHECK(out == in);
        }
    };
    check(alone(gather)), check(alone(tile_max));
}

TEST_CASE("gather: a picture that moves as a whole becomes a box blur along the motion, of what the image has of it") {
    constexpr Extent size{61, 24};
    std::mt19937 random(5);
    std::vector<float> values(static_cast<std::size_t>(size.pixels()));
    for (float& v : values) v = std::uniform_real_distribution<float>(0.f, 3.f)(random);
    auto const picture = [&](int x, int y) { return values[static_cast<std::size_t>(y * size.width + x)]; };
    // As many samples as the sweep has pixels lie one pixel apart.
    auto const check = [&](glm::ivec2 step, int count) {
        auto const out = once(alone(GatherBlur{.samples = count}), size, [&](auto& frame) {
            tests::fill(frame[sweep], [&](int, int) { return glm::vec2(step * count); });
            tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(picture(x, y)); });
        });
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                REQUIRE(red(out, size, x, y) == doctest::Approx(mean_along(picture, size, {x, y}, step, count)).epsilon(1e-5));
    };
    check({1, 0}, 15), check({0, -1}, 9), check({-1, 1}, 21), check({2, 1}, 7), check({3, 0}, 41);
}

TEST_CASE("gather: an even number of samples lies evenly around the middle too") {
    constexpr Extent size{40, 3};
    auto const out = once(alone(GatherBlur{.samples = 4}), size, [](auto& frame) {
        tests::fill(frame[sweep], [](int, int) { return glm::vec2(8.f, 0.f); });
        tests::fill(frame[radiance], [](int x, int) { return glm::vec3(static_cast<float>(x)); });
    });
    for (int x = 4; x < 36; ++x) REQUIRE(red(out, size, x, 1) == doctest::Approx(static_cast<double>(x)).epsilon(1e-5));
}

TEST_CASE("a bar that moves before what stands still: tile-max spreads it half a sweep beyond its outline, gather not at all") {
    constexpr Extent size{64, 16};
    constexpr int from = 24, to = 40;
    auto const bar = [](int x) { return x >= from && x < to; };
    auto const blurred = [&](auto const& filter, float depth_of_bar) {
        return once(alone(filter), size, [&](auto& frame) {
            tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(bar(x) ? 1.f : 0.f); });
            tests::fill(frame[sweep], [&](int x, int) { return glm::vec2(bar(x) ? 12.f : 0.f, 0.f); });
            fill_depth(frame, [&](int x, int) { return bar(x) ? depth_of_bar : 5.f; });
        });
    };
    auto const gathered = blurred(gather, 3.f), spread = blurred(tile_max, 3.f), hidden = blurred(tile_max, 8.f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            if (!bar(x)) {
                CHECK(red(gathered, size, x, y) == 0.f);
                CHECK(red(hidden, size, x, y) == 0.f);
            }
        // Both thin the bar out at its ends, where half of the time something else is seen.
        for (auto const* out : {&gathered, &spread}) {
            CHECK(red(*out, size, from, y) < 0.9f);
            CHECK(red(*out, size, from, y) > 0.3f);
            CHECK(red(*out, size, to - 1, y) < 0.9f);
            CHECK(red(*out, size, (from + to) / 2, y) == doctest::Approx(1.f));
        }
        for (int const x : {from - 1, from - 2, to, to + 1}) CHECK(red(spread, size, x, y) > 0.1f);
        for (int const x : {from - 7, from - 12, to + 6, to + 12}) CHECK(red(spread, size, x, y) == 0.f);
    }
}

TEST_CASE("tile-max spreads a slow thing by its own sweep, also where a fast one says how far to look") {
    constexpr Extent size{64, 5};
    auto const bar = [](int x) { return x >= 24 && x < 40; };
    auto const out = once(alone(tile_max), size, [&](auto& frame) {
        tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(bar(x) ? 1.f : 0.f); });
        tests::fill(frame[sweep], [&](int x, int) { return glm::vec2(bar(x) ? 4.f : x == 10 || x == 54 ? 30.f : 0.f, 0.f); });
        tests::fill(frame[depth], [&](int x, int) { return bar(x) ? 3.f : 5.f; });
    });
    for (int y = 0; y < size.height; ++y)
        for (int const distance : {3, 4, 6, 9}) {
            CHECK(red(out, size, 24 - distance, y) == 0.f);
            CHECK(red(out, size, 39 + distance, y) == 0.f);
        }
    // Few of the samples, if any, land on the pixel next to it.
    float beside = 0;
    for (int y = 0; y < size.height; ++y) beside += red(out, size, 23, y) + red(out, size, 40, y);
    CHECK(beside > 0.f);
}

TEST_CASE("tile-max looks along the longest sweep that is no farther away than a tile") {
    for (int const tile : {1, 2, 3, 5, 20})
        for (Extent const size : {Extent{61, 24}, Extent{13, 5}, Extent{1, 9}}) {
            std::vector<glm::vec2> sweeps;
            auto const out = tests::sequence(Pipeline{radiance, Spatial{TileMaxBlur{.tile = tile}}, Spatial{ShowDominant{}}}, size, Simd{},
                                             [&](auto& frame, unsigned i) {
                                                 any_sweeps(frame, i);
                                                 sweeps.clear();
                                                 for (int y = 0; y < size.height; ++y)
                                                     for (int x = 0; x < size.width; ++x) sweeps.push_back(frame[sweep].get(x, y));
                                             });
            auto const longest = [&](int x, int y) {
                glm::vec2 best(0);
                for (int j = std::max(0, y - tile); j <= std::min(size.height - 1, y + tile); ++j)
                    for (int i = std::max(0, x - tile); i <= std::min(size.width - 1, x + tile); ++i) {
                        auto const v = sweeps[static_cast<std::size_t>(j * size.width + i)];
                        if (v.x * v.x + v.y * v.y > best.x * best.x + best.y * best.y) best = v;
                    }
                return best;
            };
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    auto const k = static_cast<std::size_t>(y * size.width + x) * 3;
                    auto const wanted = longest(x, y);
                    REQUIRE(out[k] == std::abs(wanted.x));
                    REQUIRE(out[k + 1] == std::abs(wanted.y));
                }
        }
}

TEST_CASE("sweeps and depths that are no numbers, or longer than the image, give something between the darkest and the brightest pixel") {
    auto const check = [](auto const& pipeline) {
        for (Extent const size : {Extent{1, 1}, Extent{1, 5}, Extent{40, 9}})
            for (float const bad : {0.f, not_a_number, infinite, -infinite, 100.f, -1e6f, 3e38f}) {
                auto const out = once(pipeline, size, [&](auto& frame) {
                    tests::fill(frame[radiance],
                                [](int x, int y) { return glm::vec3(0.25f + 0.5f * static_cast<float>((x * 7 + y * 3) % 5) / 4.f); });
                    tests::fill(frame[sweep], [&](int x, int y) { return glm::vec2((x + y) % 2 ? 7.f : bad, (x + y) % 3 ? bad : 0.f); });
                    fill_depth(frame, [&](int x, int) { return x % 4 ? 5.f : bad; });
                });
                CHECK(tests::all_finite(out));
                auto const [least, most] = std::minmax_element(out.begin(), out.end());
                CHECK(*least >= 0.25f * 0.999f);
                CHECK(*most <= 0.75f * 1.001f);
            }
    };
    check(alone(gather)), check(alone(tile_max));
    check(alone(GatherBlur{.samples = 1})), check(alone(TileMaxBlur{.tile = 1, .samples = 1}));
    check(alone(GatherBlur{.samples = 4}));
}

#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/pipeline/steady_guides.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/by_evidence.hpp>
#include <quell/presets/resolve.hpp>

using namespace quell;

// What stands behind a pipeline, or before it, in pairs: one way of calling, whatever the two are.
namespace {

constexpr Extent size{37, 23};
constexpr Pipeline plain{radiance, Demodulate{}, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous<>{.levels = 1}}};
constexpr auto chosen = presets::by_evidence(plain);
constexpr auto give_back = light_given_back(radiance, 4.f, true);

/// What comes out of frames whose guides are made steady first.
template <class P> std::vector<float> steadied(P const& pipeline, auto const& executor) {
    SteadyGuides<Channels<Depth>> steady{size};
    return tests::sequence(pipeline, size, executor, [&](auto& frame, unsigned) { steady.apply(frame, executor); });
}
/// Pictures of single pixels, packs and threads, of which those of packs are returned.
std::vector<float> by_all_executors(auto const& picture_by) {
    auto const single = picture_by(Serial{}), packs = picture_by(Simd{});
    CHECK(tests::all_finite(packs));
    CHECK(tests::difference(single, packs) < 1e-3);
#if defined(QUELL_TEST_THREADS)
    for (int const threads : {1, 3}) CHECK(picture_by(Threads<>{.count = threads}) == packs);
#endif
    return packs;
}
template <class P> std::vector<float> made(P const& pipeline) {
    return by_all_executors([&](auto const& executor) { return tests::sequence(pipeline, size, executor); });
}

} // namespace

TEST_CASE("pairs: each of two stages changes the picture, the same by every executor") {
    auto const alone = made(plain), with_evidence = made(chosen), with_light = made(Chain{plain, give_back});
    auto const differ = [](std::vector<float> const& pair, std::vector<float> const& one, std::vector<float> const& other) {
        CHECK(tests::difference(pair, one) > 1e-3);
        CHECK(tests::difference(pair, other) > 1e-3);
    };
    SUBCASE("evidence and light") { differ(made(Chain{chosen, give_back}), with_evidence, with_light); }
    SUBCASE("evidence and colours") { differ(made(presets::anti_aliased(chosen)), with_evidence, made(presets::anti_aliased(plain))); }
    SUBCASE("evidence and resolve") { differ(made(presets::resolve(chosen)), with_evidence, made(presets::resolve(plain))); }
    SUBCASE("light and colours") {
        differ(made(presets::anti_aliased(Chain{plain, give_back})), with_light, made(presets::anti_aliased(plain)));
    }
    SUBCASE("light and resolve") { differ(made(presets::resolve(Chain{plain, give_back})), with_light, made(presets::resolve(plain))); }
    SUBCASE("steady guides and any") {
        auto const steady = [](auto const& pipeline) {
            return by_all_executors([&](auto const& executor) { return steadied(pipeline, executor); });
        };
        auto const with_steady = steady(plain);
        CHECK(tests::difference(with_steady, alone) > 1e-3);
        differ(steady(chosen), with_steady, with_evidence);
        differ(steady(Chain{plain, give_back}), with_steady, with_light);
        differ(steady(presets::anti_aliased(plain)), with_steady, made(presets::anti_aliased(plain)));
        differ(steady(presets::resolve(plain)), with_steady, made(presets::resolve(plain)));
    }
    SUBCASE("three of them") { CHECK(tests::all_finite(made(presets::resolve(Chain{chosen, give_back})))); }
}

#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/steady_guides.hpp>
#include <quell/pipeline/two_sided.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/by_evidence.hpp>
#include <quell/presets/resolve.hpp>

using namespace quell;

// What stands behind a pipeline, or before it, in pairs: one way of calling, whatever the two are.
namespace {

constexpr Extent size{37, 23};
constexpr Pipeline general_of_known_samples{radiance, KnownSamples{}, Demodulate{}, Temporal{SurfaceMotion{}, WithVariance{RunningMean{}}},
                                            Spatial{Atrous<>{.levels = 1}}};
constexpr Pipeline plain{radiance, Demodulate{}, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous<>{.levels = 1}}};
constexpr TwoSided from_both_sides{general_of_known_samples};
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
/// What comes out of the second of four frames, with the frames after it.
template <class P> std::vector<float> two_sided(P const& denoiser, auto const& executor) {
    History history{size, denoiser};
    std::vector<decltype(Frame{size, denoiser})> window;
    for (unsigned i = 0; i < 4; ++i) tests::fill_randomly(window.emplace_back(size, denoiser), i);
    std::vector<float> picture;
    for (int i = 0; i < 2; ++i, window.erase(window.begin())) picture = tests::copy_of(run(denoiser, window, history, executor));
    return picture;
}
template <class P> std::vector<float> two_sided(P const& denoiser) {
    return by_all_executors([&](auto const& executor) { return two_sided(denoiser, executor); });
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
    SUBCASE("two-sided time and any behind it") {
        auto const both_sides = two_sided(from_both_sides);
        differ(two_sided(Chain{from_both_sides, give_back}), both_sides, with_light);
        differ(two_sided(presets::anti_aliased(from_both_sides)), both_sides, made(presets::anti_aliased(plain)));
        differ(two_sided(presets::resolve(from_both_sides)), both_sides, made(presets::resolve(plain)));
    }
    SUBCASE("three of them") { CHECK(tests::all_finite(made(presets::resolve(Chain{chosen, give_back})))); }
}

namespace {

/// Names of the passes that are run, in order.
struct Names {
    std::vector<std::string_view>* names;
    template <class Job> void for_each_pixel(Region, Job const& job) const { names->push_back(job.name); }
};
template <class P> void check_plan(P const& denoiser) {
    std::vector<std::string_view> run_names, planned;
    Names const executor{&run_names};
    History history{size, denoiser};
    decltype(Frame{size, denoiser}) window[]{Frame{size, denoiser}, Frame{size, denoiser}};
    for (int i = 0; i < 9; ++i) { // as many as are kept
        run_names.clear();
        if constexpr (detail::is_two_sided<P>)
            run(denoiser, window, history, executor);
        else
            run(denoiser, window[0], history, executor);
    }
    auto const plan = plan_of(denoiser);
    for (auto const& pass : plan.passes) planned.push_back(pass.name);
    CHECK(planned == run_names);
    CHECK(history.bytes_per_pixel() > .9 * plan.bytes_per_pixel); // rows of small images are padded
}

} // namespace

TEST_CASE("a plan lists what is run, whatever stands behind what") {
    check_plan(Chain{chosen, give_back});
    check_plan(from_both_sides);
    check_plan(Chain{from_both_sides, give_back});
    check_plan(presets::resolve(chosen));
    check_plan(presets::resolve(plain, Resolve{GaussianKernel{}, MeanDeviation{}, YCoCg{}, Sharpen{}}));
    check_plan(presets::anti_aliased(Chain{from_both_sides, give_back}));
}

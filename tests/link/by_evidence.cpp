#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/chain.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/by_evidence.hpp>

#include <limits>
#include <random>

using namespace quell;
using tests::copy_of;

namespace {

constexpr Pipeline accumulate_light{radiance, Temporal{SurfaceMotion{}, RunningMean{.cap = 32}}, Spatial{Atrous<>{.levels = 3}}};
constexpr auto denoise = presets::by_evidence(accumulate_light);
constexpr Extent size{64, 48};
/// With fewer levels: another judge.
constexpr Pipeline cheaper{radiance, Temporal{SurfaceMotion{}, RunningMean{.cap = 32}}, Spatial{Atrous<>{.levels = 2}}};

/// Light of one sample per pixel on two walls.
template <class F> void fill_noisy(F& frame, unsigned number, float light) {
    tests::fill_still(frame);
    std::mt19937 random(number);
    std::exponential_distribution<float> noise(1.f);
    auto const is_left = [&](int x) { return x < frame.size.width / 2; };
    tests::fill(frame[depth], [&](int x, int) { return is_left(x) ? 4.f : 8.f; });
    tests::fill(frame[radiance], [&](int, int) { return light * glm::vec3(noise(random), noise(random), noise(random)); });
    frame.number = number;
}
/// The root mean square of what a picture of constant light is off by, as a part of the light.
double error_of(ImageView auto const& picture, float light) {
    auto const pixels = copy_of(picture);
    return tests::root_mean_square(pixels, std::vector<float>(pixels.size(), light)) / static_cast<double>(light);
}
/// What a pipeline's errors are after so many frames of light 1, and then one of another light.
template <class P> double error_after(P const& pipeline, unsigned frames, float light) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    for (unsigned i = 0; i < frames; ++i) fill_noisy(frame, i, 1.f), run(pipeline, frame, history);
    fill_noisy(frame, frames, light);
    return error_of(run(pipeline, frame, history), light);
}

/// Memory that counts how often it is asked for.
struct CountedMemory {
    inline static int count = 0;
    static void* allocate(std::size_t bytes) { return ++count, HostMemory::allocate(bytes); }
    static void release(void* memory) { HostMemory::release(memory); }
};

} // namespace

TEST_CASE("by evidence: history has the say where nothing changes") {
    double const with = error_after(accumulate_light, 24, 1.f), alone = error_after(accumulate_light, 0, 1.f);
    CHECK(with < .4 * alone);
    CHECK(error_after(denoise, 24, 1.f) < 1.15 * with);
    CHECK(error_after(presets::by_evidence(accumulate_light, cheaper), 24, 1.f) < 1.15 * with);
}

TEST_CASE("by evidence: the frame alone has the say where light has jumped") {
    for (float const light : {.1f, 6.f}) {
        CAPTURE(light);
        double const with = error_after(accumulate_light, 24, light), alone = error_after(accumulate_light, 0, 1.f);
        CHECK(with > 4. * alone);
        CHECK(error_after(denoise, 24, light) < 1.6 * alone);
        CHECK(error_after(presets::by_evidence(accumulate_light, cheaper), 24, light) < 1.6 * alone);
    }
}

TEST_CASE("by evidence: constant light stays as it is") {
    Frame frame{size, denoise};
    History history{size, denoise};
    for (int i = 0; i < 4; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [](int, int) { return glm::vec3(.25f, .5f, .75f); });
        auto const picture = run(denoise, frame, history);
        for (int c = 0; c < 3; ++c) CHECK(picture.get(c, 11, 7) == doctest::Approx(.25 * (c + 1)).epsilon(1e-5));
    }
    CHECK(history.statistics().frames == 4);
    CHECK(history.statistics().resets == 1);
    history.forget();
    run(denoise, frame, history);
    CHECK(history.statistics().frames == 1);
}

TEST_CASE("by evidence: after a gap in the numbers nothing is left of the frames before") {
    Frame frame{size, denoise};
    History history{size, denoise}, fresh{size, denoise};
    for (unsigned i = 0; i < 4; ++i) fill_noisy(frame, i, 1.f), run(denoise, frame, history);
    fill_noisy(frame, 9, 1.f);
    CHECK(copy_of(run(denoise, frame, history)) == copy_of(run(denoise, frame, fresh)));
    CHECK(history.statistics().frames == 1);
}

TEST_CASE("by evidence: what is sure beforehand is one of the two, whose history nothing has changed") {
    constexpr float sure = 1e-12f;
    auto const random_motion = [](auto const& pipeline) { return tests::sequence(pipeline, {37, 23}, Simd{}); };
    auto const with = random_motion(presets::by_evidence(accumulate_light, Evidence{.at_first = 1.f, .spread = sure}));
    CHECK(tests::difference(random_motion(accumulate_light), with) < 1e-5);
    auto const alone = random_motion(presets::by_evidence(accumulate_light, Evidence{.at_first = 0.f, .spread = sure}));
    Frame frame{Extent{37, 23}, accumulate_light};
    History history{Extent{37, 23}, accumulate_light};
    tests::fill_randomly(frame, 2);
    CHECK(tests::difference(copy_of(run(accumulate_light, frame, history)), alone) < 1e-5);
    CHECK(tests::difference(with, alone) > .01);
}

namespace {
/// Holds the choice of a judge against one by hand, of what the judge makes of samples that are held out. The judge's accumulated light is
/// that of the pipeline, which its own history has too.
template <class Judge> void check_as_by_hand(Judge const& judge) {
    constexpr Evidence rule{.at_first = .5f, .spread = .1f};
    auto const judged = presets::by_evidence(accumulate_light, judge, rule);
    static_assert(!decltype(judged)::is_own_judge);
    enum Half { even, odd, none };
    /// What a pipeline makes of the last of so many frames, of which that half is held out.
    auto const made = [](auto const& pipeline, unsigned first, Half half) {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        std::vector<float> out;
        for (unsigned i = first; i < 4; ++i) {
            fill_noisy(frame, i, i < 3 ? 1.f : 1.5f);
            for (int y = 0; y < size.height && i == 3; ++y)
                for (int x = 0; x < size.width; ++x)
                    if ((x + y) % 2 == half) frame[radiance].set(x, y, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
            out = copy_of(run(pipeline, frame, history));
        }
        return out;
    };
    Frame estimates{size, judged.choice, judged};
    fill_noisy(estimates, 3, 1.5f);
    auto const give = [&](auto channel, std::vector<float> const& picture) {
        for (std::size_t i = 0; i < picture.size(); ++i)
            estimates[channel].view().set(int(i % 3), int(i / 3) % size.width, int(i / 3) / size.width, picture[i]);
    };
    give(FirstEstimate<3>{}, made(accumulate_light, 0, none)), give(SecondEstimate<3>{}, made(accumulate_light, 3, none));
    give(FirstWithoutEven<3>{}, made(judge, 0, even)), give(FirstWithoutOdd<3>{}, made(judge, 0, odd));
    give(SecondWithoutEven<3>{}, made(judge, 3, even)), give(SecondWithoutOdd<3>{}, made(judge, 3, odd));
    give(SecondJudged<3>{}, made(judge, 3, none));
    History history{size, judged.choice};
    CHECK(tests::difference(copy_of(run(judged.choice, estimates, history)), made(judged, 0, none)) < 1e-5);
}
} // namespace

TEST_CASE("by evidence: a judge chooses as by hand, by what it makes of samples that are held out") {
    SUBCASE("of another type") {
        check_as_by_hand(Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{.cap = 32}}, Spatial{Atrous<>{.levels = 1}},
                                  Spatial{Atrous<>{.levels = 1}}});
    }
    SUBCASE("of the pipeline's type, with other numbers") {
        check_as_by_hand(Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{.cap = 32}}, Spatial{Atrous<>{.levels = 1}}});
    }
    SUBCASE("the pipeline itself") { check_as_by_hand(accumulate_light); }
}

TEST_CASE("by evidence: the pipeline as its own judge has the bits of the same one as another judge, in fewer passes") {
    constexpr auto by_another = presets::by_evidence(accumulate_light, accumulate_light);
    CHECK(tests::sequence(denoise, {37, 23}, Simd{}) == tests::sequence(by_another, {37, 23}, Simd{}));
    CHECK(plan_of(by_another).passes.size() == plan_of(denoise).passes.size() + plan_of(accumulate_light).passes.size());
    CHECK(warm_up_frames(by_another) == warm_up_frames(denoise));
}

TEST_CASE("by evidence: any bits in, finite numbers out") {
    for (Extent const each : {Extent{1, 1}, Extent{2, 1}, Extent{1, 5}, Extent{19, 17}}) {
        CAPTURE(to_string(each));
        auto const picture = tests::sequence(denoise, each, Simd{}, [](auto& frame, unsigned number) {
            std::mt19937 random(number + 9);
            std::uniform_int_distribution<std::uint32_t> bits;
            for_each_channel(typename std::remove_reference_t<decltype(frame)>::channels{}, [&]<class C>(C channel) {
                tests::fill(frame[channel], [&](int x, int y) {
                    Value<C::components, float> value = frame[channel].get(x, y);
                    if (random() % 3 == 0) value = value * std::bit_cast<float>(bits(random));
                    return value;
                });
            });
        });
        CHECK(tests::all_finite(picture));
    }
    auto const nothing = tests::sequence(denoise, {9, 9}, Simd{}, [](auto& frame, unsigned) {
        tests::fill(frame[radiance], [](int, int) { return glm::vec3(std::numeric_limits<float>::quiet_NaN()); });
    });
    CHECK(tests::all_finite(nothing));
}

TEST_CASE("by evidence: the executor does not change what comes out") {
    for (Extent const each : {Extent{1, 3}, Extent{33, 21}, size}) {
        CAPTURE(to_string(each));
        auto const packs = tests::sequence(denoise, each, Simd{});
        CHECK(tests::difference(packs, tests::sequence(denoise, each, Serial{})) < 2e-5);
#if defined(QUELL_TEST_THREADS)
        CHECK(packs == tests::sequence(denoise, each, Threads<>{.count = 1}));
        CHECK(packs == tests::sequence(denoise, each, Threads<>{.count = 3, .tile = {16, 5}}));
#endif
    }
}

TEST_CASE("by evidence: the storage of the frame does not change what comes out, and nothing is allocated in warm frames") {
    constexpr Extent small{31, 18};
    Frame frame{small, denoise};
    Frame<decltype(denoise)::reads, Interleaved<>> interleaved(small);
    History history{small, denoise}, of_other{small, denoise};
    History counted{small, denoise, Planar<Float32, CountedMemory>{}};
    ImageOf<Interleaved<>, Radiance> target(small);
    int before = 0;
    std::size_t bytes = 0;
    for (unsigned i = 0; i < 6; ++i) {
        tests::fill_randomly(frame, i), tests::fill_randomly(interleaved, i);
        auto const picture = copy_of(run(denoise, frame, history));
        run_into(target.view(), denoise, interleaved, of_other);
        CHECK(picture == copy_of(target.view()));
        CHECK(picture == copy_of(run(denoise, frame, counted)));
        if (i > 2) CHECK((CountedMemory::count == before && counted.bytes() == bytes));
        before = CountedMemory::count, bytes = counted.bytes();
    }
    counted.release_scratch();
    CHECK(counted.bytes() < bytes / 2);
    CHECK(copy_of(run(denoise, frame, history)) == copy_of(run(denoise, frame, counted)));
}

TEST_CASE("by evidence: colours are anti-aliased behind it") {
    constexpr auto smooth = presets::anti_aliased(denoise);
    constexpr auto plain = presets::anti_aliased(accumulate_light);
    auto const constant = [](auto const& pipeline) {
        return tests::sequence(pipeline, {12, 9}, Simd{}, [](auto& frame, unsigned) {
            tests::fill_still(frame);
            tests::fill(frame[radiance], [](int, int) { return glm::vec3(.5f); });
        });
    };
    CHECK(tests::difference(constant(smooth), constant(plain)) < 1e-5);
}

TEST_CASE("by evidence: its plan lists what is run, in as many bytes as the history takes; a chain goes on from it") {
    auto const plan = plan_of(denoise);
    auto const of_pipeline = plan_of(accumulate_light).passes.size(), of_choice = plan_of(denoise.choice).passes.size();
    CHECK(plan.passes.size() == 6 * of_pipeline + of_choice + 4);
    CHECK(plan_of(presets::by_evidence(accumulate_light, Evidence{.both_halves = false})).passes.size() == 4 * of_pipeline + of_choice + 3);
    auto const of_cheaper = plan_of(cheaper).passes.size();
    CHECK(plan_of(presets::by_evidence(accumulate_light, cheaper)).passes.size() == 2 * of_pipeline + 5 * of_cheaper + of_choice + 4);
    CHECK(warm_up_frames(denoise) == warm_up_frames(accumulate_light));
    constexpr Extent wide{1024, 16};
    Frame frame{wide, denoise};
    History history{wide, denoise};
    for (unsigned i = 0; i < 3; ++i) tests::fill_randomly(frame, i), run(denoise, frame, history);
    CHECK(history.bytes_per_pixel() == doctest::Approx(plan.bytes_per_pixel));
    constexpr auto chain = Chain{denoise, Pipeline{denoised, Spatial{Atrous<>{.levels = 1}}}};
    constexpr auto behind = Chain{accumulate_light, Pipeline{denoised, Spatial{Atrous<>{.levels = 1}}}};
    auto const of = [](auto const& pipeline) { return tests::sequence(pipeline, {37, 23}, Simd{}); };
    CHECK(tests::difference(of(chain), of(behind)) > 1e-3);
    constexpr auto sure = presets::by_evidence(accumulate_light, Evidence{.at_first = 1.f, .spread = 1e-12f});
    CHECK(tests::difference(of(Chain{sure, Pipeline{denoised, Spatial{Atrous<>{.levels = 1}}}}), of(behind)) < 1e-5);
}

#include "../frames.hpp"
#include "../shader/own_policies.hpp"
#include "../threads.hpp"

#include <quell/pipeline/history_contents.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/pipeline/warm_up.hpp>

using namespace quell;
using tests::look_back;

// What a channel was in frames farther back than the last.
namespace {

constexpr Extent size{37, 5};
constexpr Pipeline with_history{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{tests::KeepLight{}},
                                Spatial{tests::AddLightBefore{}}};

/// The digits of a frame's picture where each frame's light is its number.
template <class Executor, class Storage = Planar<>>
std::vector<float> digits_of(std::vector<float> const& lights, Executor const& executor) {
    Frame frame{size, look_back};
    History history{size, look_back, Storage{}};
    std::vector<float> digits;
    for (float const light : lights) {
        tests::fill(frame[radiance], [&](int, int) { return glm::vec3(light); });
        auto const picture = run(look_back, frame, history, executor);
        digits.push_back(picture.get(0, 3, 2));
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) CHECK(picture.get(c, x, y) == digits.back());
    }
    return digits;
}

} // namespace

TEST_CASE("earlier: each frame sees those before it, and the first stands for those before the first") {
    std::vector<float> const lights{1, 2, 3, 4, 5, 6, 7}, wanted{1, 1112, 1123, 1234, 1345, 2456, 3567};
    CHECK(digits_of(lights, Serial{}) == wanted);
    CHECK(digits_of(lights, Simd{}) == wanted);
    CHECK(digits_of<Simd, Interleaved<>>(lights, Simd{}) == wanted);
#if defined(QUELL_TEST_THREADS)
    CHECK(digits_of(lights, Threads<>{.count = 3}) == wanted);
#endif
}

TEST_CASE("earlier: at a cut, a gap and another size the frames before are gone") {
    Frame frame{size, look_back}, small{Extent{4, 3}, look_back};
    History history{size, look_back};
    long long number = 0;
    auto const digits = [&](auto& of, float light) {
        tests::fill(of[radiance], [&](int, int) { return glm::vec3(light); });
        of.number = ++number;
        return run(look_back, of, history).get(0, 1, 1);
    };
    for (float const light : {1.f, 2.f, 3.f, 4.f, 5.f}) digits(frame, light);
    history.forget();
    CHECK(digits(frame, 6.f) == 6.f);
    CHECK(digits(frame, 7.f) == 6667.f);
    ++number;
    CHECK(digits(frame, 8.f) == 8.f);
    CHECK(digits(small, 9.f) == 9.f);
    CHECK(digits(small, 1.f) == 9991.f);
}

TEST_CASE("earlier: images are handed on, one a frame, and none is made once all frames are there") {
    Frame frame{size, look_back};
    History history{size, look_back};
    std::vector<std::size_t> bytes;
    for (unsigned i = 0; i < 9; ++i) tests::fill_randomly(frame, i), run(look_back, frame, history), bytes.push_back(history.bytes());
    for (std::size_t i = 5; i < 9; ++i) CHECK(bytes[i] == bytes[4]);
    // The first frame keeps one image, the fifth four more.
    auto const of_images = static_cast<double>(4 * ImageOf<Planar<>, Radiance>(size).bytes());
    CHECK(static_cast<double>(bytes[8] - bytes[0]) == doctest::Approx(of_images).epsilon(.05));
    auto const plan = plan_of(look_back);
    auto const& past = plan.passes.back().reads_past;
    REQUIRE(past.size() == 3);
    CHECK(past[0] == "seen_light");
    CHECK(past[1] == "seen_light, 1 frame earlier");
    CHECK(past[2] == "seen_light, 3 frames earlier");
    CHECK(Earlier<tests::SeenLight, 12>::name == "seen_light, 12 frames earlier");
    CHECK(warm_up_frames(look_back) == 4);
}

TEST_CASE("earlier: behind a frame of which only the stages up to Temporal have run, there is none") {
    constexpr Pipeline accumulated{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
    Frame frame{size, with_history};
    History history{size, with_history};
    History plain{size, accumulated};
    auto const next = [&](unsigned number) {
        tests::fill_randomly(frame, number);
        return std::pair{tests::copy_of(run(with_history, frame, history)), tests::copy_of(run(accumulated, frame, plain))};
    };
    for (unsigned i = 0; i < 3; ++i) next(i);
    tests::fill_randomly(frame, 3);
    accumulate(with_history, frame, history), accumulate(accumulated, frame, plain);
    auto const [made, alone] = next(4);
    CHECK(made == alone);
    auto const [after, by_itself] = next(5);
    CHECK(after != by_itself);
}

TEST_CASE("earlier: contents of a history have it") {
    Frame frame{size, with_history};
    History history{size, with_history}, other{size, with_history};
    for (unsigned i = 0; i < 3; ++i) tests::fill_randomly(frame, i), run(with_history, frame, history);
    put_contents(other, contents_of(history).value());
    for (unsigned i = 3; i < 7; ++i) {
        tests::fill_randomly(frame, i);
        CHECK(tests::copy_of(run(with_history, frame, other)) == tests::copy_of(run(with_history, frame, history)));
    }
}

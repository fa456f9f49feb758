#include "sequences.hpp"

#include <quell/diagnose/debug_images.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr auto clamped =
    Pipeline{radiance, Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, WithMoments{Clamped{RunningMean{.cap = 4}}}}};
constexpr auto debug = watched(clamped);
constexpr Extent size{24, 16};

/// A wall at depth 4 before which a smaller one moves to the right by two pixels a frame.
template <class F> void fill_two_walls(F& frame, int number) {
    int const left = 4 + 2 * number;
    std::mt19937 random(static_cast<unsigned>(number));
    auto const is_near = [=](int x, int y) { return x >= left && x < left + 6 && y >= 4 && y < 12; };
    fill(frame[depth], [&](int x, int y) { return is_near(x, y) ? 2.f : 4.f; });
    fill(frame[normal], [](int, int) { return glm::vec3(0, 0, 1); });
    fill(frame[motion], [&](int x, int y) { return glm::vec2(is_near(x, y) ? -2.f : 0.f, 0.f); });
    fill(frame[radiance], [&](int, int) { return glm::vec3(std::exponential_distribution<float>(1.f)(random)); });
}

struct AfterFrames {
    Frame<decltype(debug)::reads> frame{size};
    History<std::remove_const_t<decltype(debug)>> history{size, debug};

    explicit AfterFrames(int frames) {
        for (int i = 0; i < frames; ++i) fill_two_walls(frame, i), run(debug, frame, history, Serial{});
    }
    template <ChannelTag C> float at(C channel, int x, int y) {
        auto const images = debug_images(channel, history);
        REQUIRE(images.size() == 1);
        CHECK(images[0].signal == "radiance");
        return images[0].values[static_cast<std::size_t>(y * size.width + x)];
    }
};

} // namespace

TEST_CASE("a watched pipeline makes the same picture") {
    Frame frame{size, clamped};
    History plain{size, clamped};
    History history{size, debug};
    for (int i = 0; i < 4; ++i) {
        fill_two_walls(frame, i);
        auto const a = copy_of(run(clamped, frame, plain, Serial{})), b = copy_of(run(debug, frame, history, Serial{}));
        CHECK(difference(a, b) < 1e-5); // not to the last bit: compilers contract as they inline
    }
    static_assert(contained_in<DebugChannels, decltype(debug)::keeps>);
    static_assert(std::is_same_v<decltype(debug)::reads, decltype(clamped)::reads>);
}

TEST_CASE("at first there is no past") {
    AfterFrames first(1);
    CHECK(first.at(debug_length, 3, 3) == 1.f);
    CHECK(first.at(debug_source, 3, 3) == 0.f);
    CHECK(first.at(debug_rejection, 3, 3) == static_cast<float>(Rejection::no_frame));
    CHECK(first.at(debug_clamp, 3, 3) == 0.f);
}

TEST_CASE("later it is told what follows its surface, what was uncovered, and for how long") {
    AfterFrames later(4); // the near wall is at 10 to 15, and was at 8 to 13
    CHECK(later.at(debug_source, 12, 8) == 1.f);
    CHECK(later.at(debug_rejection, 12, 8) == static_cast<float>(Rejection::none));
    CHECK(later.at(debug_length, 12, 8) == 4.f);
    CHECK(later.at(debug_length, 2, 2) == 4.f);
    CHECK(later.at(debug_source, 9, 8) != 1.f);
    CHECK(later.at(debug_rejection, 9, 8) == static_cast<float>(Rejection::depth_test));
    float most = 0.f;
    for (int x = 0; x < size.width; ++x) most = std::max(most, later.at(debug_clamp, x, 2));
    CHECK(most > 0.f);
}

TEST_CASE("other reasons for there being no past are told apart") {
    AfterFrames after(2);
    fill_two_walls(after.frame, 2);
    after.frame[motion].set(1, 1, {-9.f, 0.f});
    after.frame[motion].set(2, 1, {std::nanf(""), 0.f});
    after.frame[normal].set(3, 1, {0, 0, -1});
    run(debug, after.frame, after.history, Serial{});
    CHECK(after.at(debug_rejection, 1, 1) == static_cast<float>(Rejection::outside));
    CHECK(after.at(debug_rejection, 2, 1) == static_cast<float>(Rejection::no_motion));
    CHECK(after.at(debug_rejection, 3, 1) == static_cast<float>(Rejection::normal_test));
}

TEST_CASE("without a clamp there is no image of one, and each pipeline of a composite has its own") {
    constexpr auto two = watched(Composite{presets::surface(radiance), presets::surface(visibility)});
    Frame frame{size, two};
    History history{size, two};
    CHECK(debug_images(debug_length, history).empty());
    fill_still(frame);
    run(two, frame, history, Serial{});
    CHECK(debug_images(debug_clamp, history).empty());
    auto const lengths = debug_images(debug_length, history);
    REQUIRE(lengths.size() == 2);
    CHECK(lengths[1].signal == "visibility");
}

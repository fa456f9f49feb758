#include <doctest/doctest.h>
#include <quell/resolve/kept_frames.hpp>

#include <vector>

using namespace quell;

namespace {
using Kept = KeptFrames<std::optional<int>, 2>;

std::vector<int> known(Kept const& frames) {
    std::vector<int> all;
    for (auto const& each : frames.before()) all.push_back(*each);
    return all;
}
/// Runs a frame and returns what it knows of those before it.
std::vector<int> run(Kept& frames, int number, bool numbered = true) {
    frames.start(numbered ? std::optional<long long>(number) : std::nullopt);
    auto const before = known(frames);
    frames.place() = number;
    frames.finish();
    return before;
}
} // namespace

TEST_CASE("kept frames: as many as wanted, the nearest first, in the place of the oldest") {
    Kept frames;
    CHECK(run(frames, 0).empty());
    CHECK(run(frames, 1) == std::vector{0});
    CHECK(run(frames, 2) == std::vector{1, 0});
    CHECK(frames.place() == 0);
    CHECK(run(frames, 3) == std::vector{2, 1});
    CHECK(frames.place() == 1);
}

TEST_CASE("kept frames: none is known after forget(), a gap and an error, but without numbers all follow") {
    Kept frames;
    run(frames, 0), run(frames, 1);
    CHECK(run(frames, 3).empty());
    CHECK(run(frames, 4) == std::vector{3});
    CHECK(run(frames, 9, false) == std::vector{4, 3});
    CHECK(run(frames, 17) == std::vector{9, 4});
    frames.forget();
    CHECK(run(frames, 18).empty());
    frames.start(19), frames.place() = 19; // and does not end
    CHECK(run(frames, 20).empty());
    CHECK(run(frames, 21) == std::vector{20});
}

TEST_CASE("kept frames: where none is kept, none is known") {
    KeptFrames<std::optional<int>, 0> frames;
    for (int i = 0; i < 3; ++i) {
        frames.start(i);
        CHECK(frames.before().empty());
        frames.place() = i, frames.finish();
    }
}

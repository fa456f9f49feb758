// A stage of a host's own, from one header with its policy and its line: in libquell, in plans, by all executors. recorded.cpp has it as
// shaders; the tests of emulated CUDA and of Python have it too.
#include "own_stage.hpp"
#include "../library/wall.hpp"

#include <quell/execute/threads.hpp>
#include <quell/pipeline/plan.hpp>

#include <algorithm>

using namespace wall_test;

namespace {

constexpr auto own = std::get<0>(own_stages).make({});

std::vector<float> third_with(char const* stages) {
    auto settings = settings_of();
    settings.stages = stages;
    auto const denoiser = made(settings);
    Wall wall;
    for (unsigned i = 0; i < 3; ++i) {
        wall.shine(i);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    }
    return wall.out;
}
std::vector<float> by(auto const& executor) {
    Wall wall;
    quell::Frame frame({width, height}, own);
    quell::History history({width, height}, own);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            auto const* const sample = &wall.rgb[static_cast<std::size_t>(3 * (y * width + x))];
            frame[quell::radiance].set(x, y, {sample[0], sample[1], sample[2]}), frame[quell::denoised].set(x, y, glm::vec3(.25f));
        }
    auto const picture = quell::run(own, frame, history, executor);
    std::vector<float> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) values.push_back(picture.get(c, x, y));
    return values;
}

} // namespace

TEST_CASE("a stage of one's own: libquell lists it, says it in the plan, and puts it behind presets and other stages") {
    std::vector<std::string> names;
    while (char const* const name = quell_stage_name(QUELL_CPU, static_cast<int32_t>(names.size()))) names.emplace_back(name);
    CHECK(std::ranges::count(names, "half") == 1);
    auto settings = settings_of();
    settings.stages = "light,half";
    CHECK(quell::Denoiser(settings).plan().find("Behind it, half:") != std::string::npos);

    for (auto const& [with, without] : {std::pair{"half", ""}, {"half,light", "light"}, {"evidence,half", "evidence"}}) {
        auto const picture = third_with(without), halved = third_with(with);
        Wall wall;
        wall.shine(2);
        for (std::size_t i = 0; i < halved.size(); ++i) CHECK(halved[i] == doctest::Approx(.5f * (picture[i] + wall.rgb[i])));
    }
}

TEST_CASE("a stage of one's own: equal by Serial, Simd and Threads") {
    auto const picture = by(quell::Serial{});
    CHECK(by(quell::Simd{}) == picture);
    CHECK(by(quell::Threads{}) == picture);
    CHECK(to_string(plan_of(own)).find("half of samples") != std::string::npos);
}

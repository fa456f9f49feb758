// Guides that libquell makes steady before a preset reads them: what the headers make of them.
#include "wall.hpp"

#include <quell/pipeline/steady_guides.hpp>

#include <limits>
#include <new>

using namespace wall_test;

namespace {

/// A wall of which no sample says rightly how far it is, and how bright.
struct NoisyWall : Wall {
    void look(unsigned number) {
        shine(number);
        std::mt19937 random(number + 100);
        std::uniform_real_distribution<float> any(0, 1);
        for (std::size_t p = 0; p < pixels; ++p) {
            depth[p] = 3 + 2 * any(random);
            for (std::size_t c = 0; c < 3; ++c) albedo[3 * p + c] = 0.2f + 0.6f * any(random);
            motion[2 * p] = 0.75f, motion[2 * p + 1] = -0.25f;
        }
        depth[number] = std::numeric_limits<float>::infinity(); // nothing is seen there
    }
};

/// What the third of three frames becomes, with the guides of each made steady beforehand.
template <class... Steady> std::vector<float> third_of_steady(Steady... steady) {
    using namespace quell;
    auto const denoiser = made();
    NoisyWall wall;
    for (unsigned i = 0; i < 3; ++i) {
        wall.look(i);
        Frame<Channels<Depth, Albedo, Motion>> frame({width, height});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const p = static_cast<std::size_t>(y * width + x);
                frame[depth].set(x, y, wall.depth[p]), frame[motion].set(x, y, {wall.motion[2 * p], wall.motion[2 * p + 1]});
                frame[albedo].set(x, y, {wall.albedo[3 * p], wall.albedo[3 * p + 1], wall.albedo[3 * p + 2]});
            }
        (steady.apply(frame), ...);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const p = static_cast<std::size_t>(y * width + x);
                wall.depth[p] = frame[depth].view().get(0, x, y);
                for (int c = 0; c < 3; ++c) wall.albedo[3 * p + static_cast<std::size_t>(c)] = frame[albedo].view().get(c, x, y);
            }
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    }
    return wall.out;
}
std::vector<float> third_with(char const* stages) {
    auto settings = settings_of();
    settings.stages = stages;
    auto const denoiser = made(settings);
    NoisyWall wall;
    for (unsigned i = 0; i < 3; ++i) {
        wall.look(i);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    }
    return wall.out;
}

} // namespace

TEST_CASE("steady guides: bit for bit what the headers make of the same guides") {
    using namespace quell;
    CHECK(third_with(nullptr) == third_of_steady());
    CHECK(third_with("steady-depth") == third_of_steady(SteadyGuides<Channels<Depth>>{{width, height}}));
    CHECK(third_with("steady-albedo") == third_of_steady(SteadyGuides<Channels<Albedo>>{{width, height}}));
    CHECK(third_with("steady-albedo,steady-depth") == third_of_steady(SteadyGuides<Channels<Depth, Albedo>>{{width, height}}));
    CHECK(third_with("steady-depth") != third_with(nullptr));
}

TEST_CASE("steady guides: the plan says them, and what the headers' histories take") {
    using namespace quell;
    Frame<Channels<Depth, Albedo, Motion>> frame({width, height});
    SteadyGuides<Channels<Depth>> of_depth{{width, height}};
    SteadyGuides<Channels<Albedo>> of_albedo{{width, height}};
    for (int i = 0; i < 2; ++i) of_depth.apply(frame), of_albedo.apply(frame);
    std::size_t const plane = Planar<>::Image<1>({width, height}).bytes(); // a float a pixel
    auto const plan_with = [&](char const* stages) {
        auto settings = settings_of();
        settings.stages = stages;
        return std::string(quell_plan(made(settings).get()));
    };
    auto const plan = plan_with(nullptr);
    auto const sentence = [&](auto guide, std::size_t bytes) {
        auto const floats = static_cast<std::size_t>(guide.components + Motion::components) + bytes / plane;
        return "Before it, " + std::string(guide.name) + " is accumulated along the motion, over 8 frames at most, which takes " +
               std::to_string(4 * floats) + " bytes a pixel of the frames.\n\n";
    };
    CHECK(plan.find("accumulated along") == plan.npos);
    CHECK(plan_with("steady-depth") == sentence(depth, of_depth.bytes()) + plan);
    CHECK(plan_with("steady-albedo") == sentence(albedo, of_albedo.bytes()) + plan);
    CHECK(plan_with("steady-depth,steady-albedo") == sentence(depth, of_depth.bytes()) + sentence(albedo, of_albedo.bytes()) + plan);
}

TEST_CASE("steady guides: without memory for what stands behind them, all begins anew") {
    auto settings = settings_of();
    settings.stages = "steady-depth";
    NoisyWall wall;
    wall.look(1);
    REQUIRE(quell_run(made(settings).get(), wall.ready()) == QUELL_OK);
    auto const first = wall.out;
    long long left = 0;
    settings.memory_user = &left;
    settings.allocate = [](void* user, std::size_t bytes, std::size_t alignment) -> void* {
        return (*static_cast<long long*>(user))-- > 0 ? ::operator new (bytes, std::align_val_t{alignment}, std::nothrow) : nullptr;
    };
    settings.release = [](void*, void* memory) { ::operator delete (memory, std::align_val_t{64}); };
    bool failed = true;
    int failures = 0;
    for (; failed; ++failures) {
        left = 1LL << 40;
        auto const denoiser = made(settings);
        left = failures;
        wall.look(0);
        failed = quell_run(denoiser.get(), wall.ready()) == QUELL_NO_MEMORY;
        left = 1LL << 40;
        wall.look(1);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        CHECK((wall.out == first) == failed);
    }
    CHECK(failures > 4);
}

TEST_CASE("steady guides: anti-aliased too; forget() drops them; what cannot be is refused with a sentence") {
    auto settings = settings_of();
    settings.stages = "steady-depth,steady-albedo,resolve";
    auto const denoiser = made(settings);
    NoisyWall wall;
    quell_camera const camera{};
    wall.frame.camera = &camera;
    wall.look(1);
    REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    auto const first = wall.out;
    REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    CHECK(wall.out != first);
    REQUIRE(quell_forget(denoiser.get()) == QUELL_OK);
    REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    CHECK(wall.out == first);
    wall.frame.has_number = 1;
    for (int const number : {5, 7}) { // the second does not follow
        wall.frame.number = number;
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        CHECK((wall.out == first) == (number == 7));
    }

    quell_denoiser* none = nullptr;
    settings.stages = "steady-colour";
    check_refused(quell_create(&settings, &none), QUELL_INVALID_ARGUMENT, {"settings.stages", "'steady-colour'", "steady-depth"});
    settings.stages = "steady-depth,resolve,steady-depth";
    check_refused(quell_create(&settings, &none), QUELL_INVALID_ARGUMENT, {"settings.stages", "'steady-depth'", "twice"});
    settings = settings_of("general"), settings.stages = "steady-depth,two-sided";
    auto const with_later = quell_create(&settings, &none);
    if (with_later != QUELL_UNKNOWN_PRESET)
        check_refused(with_later, QUELL_NOT_SUPPORTED, {"settings.stages", "steady-depth", "two-sided"});
    settings = settings_of("none"), settings.stages = "steady-depth";
    auto const refused = quell_create(&settings, &none);
    if (refused != QUELL_UNKNOWN_PRESET) check_refused(refused, QUELL_NOT_SUPPORTED, {"settings.stages", "'none'", "depth"});
}

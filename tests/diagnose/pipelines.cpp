#include "sequences.hpp"

#include <baselines/presets.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{96, 54};

/// What is found in five frames that `good` has filled and `copy` brings into another frame, for another pipeline.
template <class P, class H> std::vector<Finding> findings_of(P const& pipeline, auto& frame, H& history, auto&& change) {
    std::vector<Finding> all;
    for (int i = 0; i < 5; ++i) {
        GoodFrame good(size);
        fill_well(good, {.size = size}, i);
        change(good);
        frame.camera = good.camera, frame.number = good.number;
        for_each_channel(common_to<typename std::remove_cvref_t<decltype(frame)>::channels, GoodFrame::channels>{},
                         [&](auto c) { fill(frame[c], [&](int x, int y) { return good[c].get(x, y); }); });
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(pipeline, frame, history, Serial{});
    }
    return all;
}
void flip(GoodFrame& frame) {
    each(frame, motion, [](glm::vec2 m) { return -m; });
}

} // namespace

TEST_CASE("composites, half-precision histories and interleaved frames are diagnosed like any others") {
    constexpr auto both = Composite{presets::surface(radiance), presets::surface(visibility)};
    std::mt19937 random(1);
    for (bool wrong : {false, true}) {
        Frame frame{size, both, Interleaved<>{}};
        History history{size, both, Planar<Float16>{}};
        auto const found = findings_of(both, frame, history, [&](GoodFrame& good) {
            if (wrong) flip(good);
            fill(frame[visibility], [&](int, int) { return std::uniform_real_distribution<float>(0.f, 1.f)(random); });
            fill(frame[direct], [](int, int) { return glm::vec3(1.f); });
        });
        check_found(found, wrong ? std::set{Mistake::motion_sign} : std::set<Mistake>{});
    }
}

TEST_CASE("a history that never lasts is named where only the second part of a composite has one") {
    constexpr auto both = Composite{presets::atrous(visibility), presets::surface(radiance)};
    Frame frame{size, both};
    History history{size, both};
    std::mt19937 random(1);
    auto const found = findings_of(both, frame, history, [&](GoodFrame& good) {
        good.number = 7;
        fill(frame[visibility], [&](int, int) { return std::uniform_real_distribution<float>(0.f, 1.f)(random); });
        fill(frame[direct], [](int, int) { return glm::vec3(1.f); });
    });
    check_found(found, {Mistake::resets_every_frame});
}

TEST_CASE("every guide that a pipeline reads must be finite on surfaces; what tells of a miss need not be") {
    constexpr auto reflections = presets::glossy_paper(quell::glossy);
    constexpr auto in_mirrors = presets::mirror_clamp(radiance);
    Frame frame{size, reflections, in_mirrors};
    static_assert(decltype(frame)::channels::has<Position> && decltype(frame)::channels::has<Roughness>);
    for (int wrong = 0; wrong < 3; ++wrong) {
        std::mt19937 random(1);
        History history{size, reflections};
        auto const found = findings_of(reflections, frame, history, [&](GoodFrame& good) {
            auto const nowhere = glm::vec3(std::nanf(""));
            fill(frame[position], [&](int, int) { return wrong == 1 ? nowhere : glm::vec3(1.f); });
            fill(frame[receiver_previous], [&](int, int) { return glm::vec3(1.f); });
            fill(frame[roughness], [&](int, int) { return wrong == 2 ? std::nanf("") : 0.2f; });
            fill(frame[glossy_hit], [&](int, int) { return nowhere; });
            fill(frame[glossy_hit_previous], [&](int, int) { return nowhere; });
            fill(frame[quell::glossy], [&](int, int) { return glm::vec3(std::uniform_real_distribution<float>(0.f, 1.f)(random)); });
            good.number.reset();
        });
        check_found(found, wrong > 0 ? std::set{Mistake::bad_guides} : std::set<Mistake>{});
    }
}

TEST_CASE("a host's own memory is read in place, and asked for where there is none") {
    Frame frame{size, denoise, Borrowed<>{}};
    History history{size, denoise};
    auto const refused = diagnose(frame, history);
    REQUIRE(refused.size() == 1);
    CHECK(to_string(refused[0]) ==
          "run() refuses the frame: channel 'radiance': no memory; point the channel at the host's image before run()");
    GoodFrame good(size);
    fill_well(good, {.size = size}, 0);
    std::vector<std::vector<float>> memory;
    for_each_channel(GoodFrame::channels{}, [&](auto c) {
        memory.push_back(copy_of(good[c].view()));
        frame[c] = {memory.back().data(), size, c.components, c.components * size.width};
    });
    frame.camera = good.camera;
    CHECK(diagnose(frame, history).empty());
    for (auto& value : memory[0]) value = -1.f;
    CHECK(mistakes(diagnose(frame, history)).contains(Mistake::bad_samples));
}

TEST_CASE("a pose in place of a view shows in motion alone, where there are no normals") {
    constexpr auto by_depth = Pipeline{radiance, Temporal{SurfaceMotion<SameDepth>{}, RunningMean{}}};
    Frame frame{size, by_depth};
    History history{size, by_depth};
    auto const found = findings_of(by_depth, frame, history, [](GoodFrame& good) { good.camera.view = glm::inverse(good.camera.view); });
    check_found(found, {Mistake::view_inverted});
}

TEST_CASE("a pipeline without history has none that starts afresh, and one without stages may give back what it gets") {
    constexpr auto none = presets::none(radiance);
    constexpr auto space = Pipeline{radiance, Spatial{Gaussian{}}};
    Frame frame{size, none, space};
    History first{size, none};
    check_found(findings_of(none, frame, first, [](GoodFrame&) {}), {});
    History second{size, space};
    check_found(findings_of(space, frame, second, [](GoodFrame&) {}), {});
}

TEST_CASE("of pictures without noise nothing is said: they come out as they went in, and tiles repeat") {
    constexpr auto denoise = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
    auto const waves = [](int x, int y) { return 0.5f + 0.4f * std::sin(static_cast<float>(x) / 6) * std::cos(static_cast<float>(y) / 5); };
    auto const tiles = [](int x, int y) { return 0.1f + 0.2f * static_cast<float>((99 + x) / 4 % 5 + y / 4 % 3); };
    auto const check = [&](auto const& picture) {
        Frame frame{size, denoise};
        History history{size, denoise};
        std::vector<Finding> all;
        for (int i = 0; i < 6; ++i) {
            frame.number = i;
            fill(frame[depth], [](int, int) { return 5.f; });
            fill(frame[normal], [](int, int) { return glm::vec3(0, 0, 1); });
            fill(frame[motion], [](int, int) { return glm::vec2(-3, 0); });
            fill(frame[radiance], [&](int x, int y) { return glm::vec3(picture(x - 3 * i, y)); });
            std::ranges::move(diagnose(frame, history), std::back_inserter(all));
            run(denoise, frame, history, Serial{});
        }
        check_found(all, {});
    };
    check(waves);
    check(tiles);
}

TEST_CASE("vectors of a convention that the pipeline declares are no mistake; others are, pixels too") {
    using C = MotionConvention;
    constexpr C declared{.points = C::Points::from_previous, .unit = C::Unit::uv, .y = C::Y::up, .jitter = C::Jitter::left_in};
    constexpr auto other = Pipeline{radiance, Supplied<declared>{}, Temporal{FirstValid{SurfaceMotion{}, StillMotion{}}, RunningMean{}}};
    glm::vec2 jitter_then{0.f};
    auto const as_declared = [&](GoodFrame& good) {
        auto const change = good.camera.jitter - std::exchange(jitter_then, good.camera.jitter);
        each(good, motion, [&](glm::vec2 m) { return (m + change) / detail::to_pixels(declared, size); });
    };
    Frame frame{size, other};
    {
        History history{size, other};
        check_found(findings_of(other, frame, history, as_declared), {});
    }
    History history{size, other};
    auto const found = findings_of(other, frame, history, [](GoodFrame& good) { good.camera.jitter = {}; });
    REQUIRE(mistakes(found).contains(Mistake::motion_unit));
    CHECK(found[0].remedy.find("Supplied<MotionConvention{}>") != std::string::npos);
}

TEST_CASE("what was not checked is said once, with the reason") {
    for (bool const known : {true, false}) {
        Frame frame{size, denoise};
        History history{size, denoise};
        auto const found = findings_of(denoise, frame, history, [&](GoodFrame& good) {
            if (!known) good.camera = {};
        });
        REQUIRE(found.size() == (known ? 0 : 1));
        if (!known)
            CHECK(to_string(found[0]).starts_with("not checked: frame.camera is not set: motion, depth and normals were not compared"));
    }
    constexpr auto by_motion = Pipeline{radiance, Temporal{SurfaceMotion<SameInstance>{}, RunningMean{}}};
    Frame frame{size, by_motion};
    History history{size, by_motion};
    auto const found = findings_of(by_motion, frame, history, [](GoodFrame&) {});
    REQUIRE(found.size() == 1);
    CHECK(to_string(found[0]).starts_with("not checked: the pipeline reads no depth"));
}

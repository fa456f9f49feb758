#include "sequences.hpp"

#include <quell/presets/blur.hpp>

#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

using tracer::Jitter;

/// Calls use() with these frames of a scene.
template <class F>
void trace(tracer::PreparedScene& prepared, auto& frame, int first, int count, float shutter, F&& use, Jitter jitter = Jitter::none) {
    for (int number = first; number < first + count; ++number) {
        tracer::trace_frame(prepared, {.frame = number, .threads = 1, .shutter = shutter, .jitter = jitter}, frame);
        use();
    }
}

/// What is said of a scene, frame after frame, for several pipelines.
template <class... Ps>
void check_silent(tracer::PreparedScene& prepared, Extent size, float shutter, Jitter jitter, Ps const&... pipelines) {
    Frame frame{size, pipelines...};
    std::tuple<History<Ps>...> histories(History<Ps>(size, pipelines)...);
    std::vector<Finding> all;
    auto const diagnose_and_run = [&] {
        auto const one = [&](auto const& pipeline, auto& history) {
            for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
            run(pipeline, frame, history, Serial{});
        };
        (one(pipelines, std::get<History<Ps>>(histories)), ...);
    };
    trace(prepared, frame, 20, 11, shutter, diagnose_and_run, jitter);
    check_found(all, {});
}

/// What is said of some frames of a scene, each with the same mistake.
template <class P>
void check_named(std::string const& scene, P const& pipeline, Extent size, int first, int count, float shutter,
                 std::set<Mistake> const& mistakes, auto&& change) {
    INFO(scene);
    tracer::PreparedScene prepared(tracer::built_in_scene(scene));
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::vector<Finding> all;
    trace(prepared, frame, first, count, shutter, [&] {
        change(frame);
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(pipeline, frame, history, Serial{});
    });
    check_found(all, mistakes);
}
/// Of sharp frames.
void check_named(std::string const& scene, Mistake mistake, auto&& change) {
    check_named(scene, denoise, {96, 54}, 20, 5, 0.f, {mistake}, change);
}
/// Of blurred frames of a scene whose camera moves.
void check_named_when_blurred(std::string const& scene, std::set<Mistake> const& mistakes, auto&& change) {
    check_named(scene, presets::blur(radiance), {64, 36}, 30, 6, 0.5f, mistakes, change);
}

} // namespace

// Every event of a scene is among its frames. To prepare a scene takes longer than to trace it small, so that each is prepared once.
TEST_CASE("nothing is said of any built-in scene, sharp or blurred; blur passes on what stands still as it is") {
    for (auto const& scene : tracer::scene_names()) {
        INFO(scene);
        tracer::PreparedScene prepared(tracer::built_in_scene(scene));
        check_silent(prepared, {64, 36}, 0.f, Jitter::none, denoise, presets::surface_clamp(radiance));
        check_silent(prepared, {48, 27}, 0.5f, Jitter::none, denoise, presets::blur(radiance));
    }
}

TEST_CASE("nothing is said of scenes whose samples lie beside the pixels' centres, a frame's together or each by itself") {
    for (auto const* const name : {"room", "temple", "fence", "boxes"}) {
        tracer::PreparedScene prepared(tracer::built_in_scene(name));
        for (auto const jitter : {Jitter::frame, Jitter::pixel}) {
            INFO(name, " ", tracer::name_of(jitter));
            check_silent(prepared, {64, 36}, 0.f, jitter, presets::svgf(radiance, Demodulate{}), presets::general(radiance, Demodulate{}));
        }
    }
}

TEST_CASE("a frame's jitter is named where it is left in the motion") {
    tracer::PreparedScene prepared(tracer::built_in_scene("fence"));
    GoodFrame frame{{96, 54}, denoise};
    History history{frame.size, denoise};
    std::vector<Finding> all;
    auto const spoil_and_diagnose = [&] {
        auto const left_in = tracer::camera_jitter(Jitter::frame, static_cast<int>(*frame.number) - 1) - frame.camera.jitter;
        each(frame, motion, [&](glm::vec2 m) { return m + left_in; });
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(denoise, frame, history, Serial{});
    };
    trace(prepared, frame, 20, 5, 0.f, spoil_and_diagnose, Jitter::frame);
    check_found(all, {Mistake::motion_jitter});
}

TEST_CASE("mistakes are named in scenes whose camera moves, and where only objects do") {
    for (auto const* const scene : {"temple", "roll", "fence"})
        check_named(scene, Mistake::motion_sign, [](GoodFrame& frame) { each(frame, motion, [](glm::vec2 m) { return -m; }); });
    for (auto const* const scene : {"mixed", "propeller"})
        check_named(scene, Mistake::motion_y,
                    [](GoodFrame& frame) { each(frame, motion, [](glm::vec2 m) { return glm::vec2(m.x, -m.y); }); });
    check_named("boxes", Mistake::motion_unit, [](GoodFrame& frame) {
        glm::vec2 const size(frame.size.width, frame.size.height);
        each(frame, motion, [&](glm::vec2 m) { return m / size; });
    });
    check_named("colonnade", Mistake::motion_zero, [](GoodFrame& frame) { each(frame, motion, [](glm::vec2) { return glm::vec2(0.f); }); });
    check_named("pinkroom", Mistake::depth_not_linear, [](GoodFrame& frame) { each(frame, depth, [](float z) { return 0.1f / z; }); });
    check_named("fence", Mistake::normal_in_view_space,
                [](GoodFrame& frame) { each(frame, normal, [&](glm::vec3 n) { return glm::mat3(frame.camera.view) * n; }); });
}

TEST_CASE("sweeps that lead backwards or last another time than the shutter is open are named where the camera moves") {
    for (auto const* const scene : {"colonnade", "roll"}) {
        check_named_when_blurred(scene, {}, [](auto&) {});
        check_named_when_blurred(scene, {Mistake::sweep_sign}, [](auto& frame) { each(frame, sweep, [](glm::vec2 v) { return -v; }); });
        check_named_when_blurred(scene, {Mistake::shutter_differs}, [](auto& frame) { frame.shutter = 1; });
    }
}

TEST_CASE("sweeps whose y points up are named where the camera moves along more than one axis") {
    check_named_when_blurred("roll", {Mistake::sweep_y},
                             [](auto& frame) { each(frame, sweep, [](glm::vec2 v) { return glm::vec2(v.x, -v.y); }); });
    check_named_when_blurred("roll", {Mistake::sweep_y, Mistake::sweep_sign},
                             [](auto& frame) { each(frame, sweep, [](glm::vec2 v) { return glm::vec2(-v.x, v.y); }); });
}

TEST_CASE("indirect light that has the albedo in it already is named: a composite multiplies it once more") {
    constexpr auto composite = Composite{presets::surface(indirect)};
    for (bool const wrong : {false, true})
        check_named("boxes", composite, {96, 54}, 20, 5, 0.f, wrong ? std::set{Mistake::signal_has_albedo} : std::set<Mistake>{},
                    [&](auto& frame) {
                        if (wrong) fill(frame[indirect], [&](int x, int y) { return frame[indirect].get(x, y) * frame[albedo].get(x, y); });
                    });
}

TEST_CASE("shadows of one seed are named, though they are noisy in penumbrae alone") {
    constexpr auto shadows = presets::surface(visibility);
    tracer::PreparedScene prepared(tracer::built_in_scene("fence"));
    Frame frame{{160, 90}, shadows};
    History history{frame.size, shadows};
    std::vector<Finding> all;
    trace(prepared, frame, 22, 1, 0.f, [] {});
    for (int i = 0; i < 3; ++i) {
        frame.number = i;
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(shadows, frame, history, Serial{});
    }
    check_found(all, {Mistake::identical_frames});
}

#include "sequences.hpp"

#include <tracer/frame_sink.hpp>
#include <tracer/render.hpp>
#include <tracer/scenes/scenes.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

/// Two steps of a built-in scene.
template <class F> std::vector<Finding> findings_in(std::string const& scene, F&& change, float shutter = 0.f) {
    tracer::PreparedScene prepared(tracer::built_in_scene(scene));
    return findings({96, 54}, 3, [&](GoodFrame& frame, int i) {
        int const number = 20 + i;
        tracer::FrameSink<GoodFrame> sink{frame};
        tracer::render<GoodFrame::channels>(prepared, {.size = frame.size, .frame = number, .threads = 1, .shutter = shutter}, sink);
        frame.camera = prepared.description().camera_at(static_cast<float>(number), frame.size), frame.number = number;
        change(frame);
    });
}
template <class F> void check_named(std::string const& scene, Mistake mistake, F&& change) {
    INFO(scene);
    check_found(findings_in(scene, change), {mistake});
}

} // namespace

TEST_CASE("nothing is said of any built-in scene, sharp or blurred") {
    for (auto const& scene : tracer::scene_names()) {
        INFO(scene);
        check_found(findings_in(
                        scene, [](GoodFrame&) {}, scene == "mixed" || scene == "colonnade" ? 0.5f : 0.f),
                    {});
    }
}

TEST_CASE("mistakes are named in scenes whose camera moves, and where only objects do") {
    for (auto const* const scene : {"temple", "roll", "fence"})
        check_named(scene, Mistake::motion_sign, [](GoodFrame& frame) { each(frame, motion, [](glm::vec2 m) { return -m; }); });
    for (auto const* const scene : {"mixed", "propeller"})
        check_named(scene, Mistake::motion_y,
                    [](GoodFrame& frame) { each(frame, motion, [](glm::vec2 m) { return glm::vec2(m.x, -m.y); }); });
    check_named("restaurant", Mistake::motion_unit, [](GoodFrame& frame) {
        glm::vec2 const size(frame.size.width, frame.size.height);
        each(frame, motion, [&](glm::vec2 m) { return m / size; });
    });
    check_named("colonnade", Mistake::motion_zero, [](GoodFrame& frame) { each(frame, motion, [](glm::vec2) { return glm::vec2(0.f); }); });
    check_named("pinkroom", Mistake::depth_not_linear, [](GoodFrame& frame) { each(frame, depth, [](float z) { return 0.1f / z; }); });
    check_named("fence", Mistake::normal_in_view_space,
                [](GoodFrame& frame) { each(frame, normal, [&](glm::vec3 n) { return glm::mat3(frame.camera.view) * n; }); });
}

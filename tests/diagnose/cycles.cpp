#include "../io/files.hpp"
#include "sequences.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

/// Frames of Blender's, read once: a still camera that nobody tells of, and two objects that move.
struct CyclesFrames {
    std::vector<io::ExrImage> images;
    io::SequenceNames names;

    explicit CyclesFrames(int count) {
        auto const folder = shared("data/sequences/cycles_occlusion");
        for (int i = 0; i < count && !folder.empty(); ++i) {
            io::ExrFile const file(folder / ("frame_00" + std::to_string(33 + i) + ".exr"));
            if (i == 0) names = io::recognise(file);
            images.push_back(file.read());
        }
    }
    template <class F> std::vector<Finding> check_named(std::set<Mistake> const& wanted, F&& change) const {
        if (images.empty()) return {};
        auto const make = [&](GoodFrame& frame, int i) {
            io::load(frame, images[static_cast<std::size_t>(i)], names.of_signals[0].channels);
            change(frame, i);
        };
        auto const found = findings(images[0].size, static_cast<int>(images.size()), make);
        check_found(found, wanted);
        return found;
    }
};

} // namespace

TEST_CASE("nothing is said of the Cycles sequence" * doctest::test_suite("shared data")) {
    CyclesFrames(16).check_named({}, [](GoodFrame&, int) {});
}

TEST_CASE("mistakes in the Cycles sequence are named, as far as a still camera shows them" * doctest::test_suite("shared data")) {
    CyclesFrames const frames(4);
    for (auto const convention : detail::motion_conventions({})) {
        // Both objects move sideways, which says nothing about y.
        if (convention.y == MotionConvention::Y::up) continue;
        auto const wrong = detail::mistakes_of(convention, {});
        auto const change = [&](GoodFrame& frame, int) {
            each(frame, motion, [&](glm::vec2 m) { return m / detail::to_pixels(convention, frame.size); });
        };
        auto const found = frames.check_named({wrong.begin(), wrong.end()}, change);
        if (!found.empty()) check_factor(found, detail::to_pixels(convention, frames.images[0].size));
    }
    frames.check_named({Mistake::motion_jitter}, [](GoodFrame& frame, int i) {
        glm::vec2 const offset = i % 2 == 0 ? glm::vec2(0.3f, -0.2f) : glm::vec2(-0.1f, 0.4f);
        each(frame, motion, [&](glm::vec2 m) { return m + offset; });
    });
    frames.check_named({Mistake::depth_not_positive}, [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return -z; }); });
    frames.check_named({Mistake::depth_not_linear}, [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return 0.1f / z; }); });
    frames.check_named({Mistake::depth_not_linear},
                       [](GoodFrame& frame, int) { each(frame, depth, [](float z) { return 1.001f - 0.1001f / z; }); });
    frames.check_named({Mistake::normal_packed},
                       [](GoodFrame& frame, int) { each(frame, normal, [](glm::vec3 n) { return 0.5f * n + 0.5f; }); });
    frames.check_named({Mistake::normal_not_unit}, [](GoodFrame& frame, int) { each(frame, normal, [](glm::vec3 n) { return 3.f * n; }); });
    frames.check_named({Mistake::albedo_above_one},
                       [](GoodFrame& frame, int) { each(frame, albedo, [](glm::vec3 a) { return 2.f * a; }); });
    frames.check_named({Mistake::albedo_black},
                       [](GoodFrame& frame, int) { each(frame, albedo, [](glm::vec3) { return glm::vec3(0.f); }); });
    frames.check_named({Mistake::bad_samples}, [](GoodFrame& frame, int) { frame[radiance].set(3, 4, glm::vec3(std::nanf(""))); });
    frames.check_named({Mistake::resets_every_frame}, [](GoodFrame& frame, int i) { frame.number = 2 * i; });
}

TEST_CASE("a Cycles frame rendered with one seed is named, and a history that nothing enters" * doctest::test_suite("shared data")) {
    CyclesFrames frames(5);
    frames.check_named({Mistake::output_is_input},
                       [](GoodFrame& frame, int) { each(frame, motion, [](glm::vec2) { return glm::vec2(1e6f); }); });
    for (auto& image : frames.images) image = frames.images[0];
    frames.check_named({Mistake::identical_frames}, [](GoodFrame&, int) {});
}

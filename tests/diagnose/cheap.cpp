#include "foreign_host.hpp"

#include <quell/diagnose/cheap_diagnosis.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

/// What CheapDiagnosis says of ten frames whose motion is multiplied by this.
std::set<Mistake> said_of(std::vector<GoodFrame> const& good, glm::vec2 factor, MotionConvention converted_from = {}) {
    CheapDiagnosis check;
    GoodFrame frame(good.front().size, denoise);
    std::vector<Finding> all;
    for (auto const& one : good) {
        copy_frame(one, frame);
        // It needs no camera.
        frame.camera = {};
        each(frame, motion, [&](glm::vec2 m) { return m * factor; });
        for (auto& finding : check(frame, converted_from)) all.push_back(std::move(finding));
    }
    return mistakes(all);
}
std::vector<GoodFrame> frames_of(ForeignShot const& shot) {
    std::vector<GoodFrame> good;
    for (int i = 0; i < 10; ++i) render(good.emplace_back(shot.size, denoise), shot, i);
    return good;
}

} // namespace

TEST_CASE("a cheap diagnosis names motion that is zero, of the wrong sign, unit or length, and says nothing of good motion") {
    for (auto const guides : {GuidesOf::centre, GuidesOf::sample})
        for (auto const path : {Path::dolly, Path::orbit, Path::pan}) {
            ForeignShot const shot{Set::studio, path, guides};
            auto const good = frames_of(shot);
            glm::vec2 const size(shot.size.width, shot.size.height);
            INFO(name_of(guides), " path ", static_cast<int>(path));
            CHECK(said_of(good, {1, 1}) == std::set<Mistake>{});
            CHECK(said_of(good, {0, 0}) == std::set{Mistake::motion_zero});
            CHECK(said_of(good, {-1, -1}) == std::set{Mistake::motion_sign});
            CHECK(said_of(good, {1, -1}) == std::set{Mistake::motion_y});
            CHECK(said_of(good, 1.f / size) == std::set{Mistake::motion_unit});
            CHECK(said_of(good, {2, 2}) == std::set{Mistake::motion_scale});
            // Named in the terms of the convention from which the host converts.
            CHECK(said_of(good, size, {.unit = MotionConvention::Unit::uv}) == std::set{Mistake::motion_unit});
        }
}

TEST_CASE("a cheap diagnosis says nothing of a camera that stands still, nor across a cut that frame.number tells of") {
    for (auto const guides : {GuidesOf::centre, GuidesOf::materials, GuidesOf::sample}) {
        CHECK(said_of(frames_of({Set::plaza, Path::still, guides}), {1, 1}) == std::set<Mistake>{});
        // Things move although vectors say that they don't, but most of the picture does not.
        CHECK(said_of(frames_of({Set::plaza, Path::still, guides}), {0, 0}) == std::set<Mistake>{});
    }
    auto good = frames_of({Set::studio, Path::pan, GuidesOf::centre});
    auto const other = frames_of({Set::plaza, Path::orbit, GuidesOf::centre});
    for (std::size_t i = 5; i < good.size(); ++i) copy_frame(other[i], good[i]), good[i].number = 100 + static_cast<int>(i);
    CHECK(said_of(good, {1, 1}) == std::set<Mistake>{});
}

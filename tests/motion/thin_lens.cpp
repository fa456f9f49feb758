#include "../views.hpp"

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{61, 24};

/// A mirror ball in the middle of the picture, which it fills; everything seen in it is 4 away from it.
struct Ball {
    double radius;
    glm::dvec3 seen_moved{0}; ///< from now to then
    View now{{0, 0, 10}, {0, 0, 0}, size}, then{now};
    glm::dvec3 centre{0, 0, -radius};

    [[nodiscard]] glm::dvec3 surface(View const& view, glm::dvec2 where) const {
        auto const d = view.direction(where), from = view.eye - centre;
        double const b = glm::dot(d, from), c = glm::dot(from, from) - radius * radius;
        return view.eye + d * (-b - std::sqrt(std::max(0.0, b * b - c)));
    }
    [[nodiscard]] glm::dvec3 normal_at(glm::dvec3 s) const { return (s - centre) / radius; }
    [[nodiscard]] glm::dvec3 onward(View const& view, glm::dvec2 where) const {
        return tests::mirrored(view.direction(where), {}, normal_at(surface(view, where)));
    }
    [[nodiscard]] glm::dvec3 hit(int x, int y) const { return surface(now, tests::centre(x, y)) + onward(now, tests::centre(x, y)) * 4.0; }
    /// How far, as seen from the ball, what is seen there then is from a point.
    [[nodiscard]] glm::dvec3 off(glm::dvec2 where, glm::dvec3 point) const {
        return glm::normalize(point - surface(then, where)) - onward(then, where);
    }
    /// Where then shows the same point: by Gauss and Newton.
    [[nodiscard]] glm::dvec2 truth(int x, int y) const {
        auto const point = hit(x, y) + seen_moved;
        glm::dvec2 q = tests::centre(x, y);
        for (int i = 0; i < 20; ++i) {
            double const h = 1e-4;
            auto const f = off(q, point), fx = (off(q + glm::dvec2(h, 0), point) - f) / h, fy = (off(q + glm::dvec2(0, h), point) - f) / h;
            double const a = glm::dot(fx, fx), b = glm::dot(fx, fy), c = glm::dot(fy, fy), u = glm::dot(fx, f), v = glm::dot(fy, f);
            q -= glm::dvec2(c * u - b * v, a * v - b * u) / (a * c - b * b);
        }
        return q;
    }
    template <class M> double error(M const& source) const {
        auto const places = tests::places(
            source, size, [&](auto& frame) { frame.camera = then.camera(); },
            [&](auto& frame) {
                frame.camera = now.camera();
                auto const f = [&](auto&& what) { return [&, what](int x, int y) { return glm::vec3(what(x, y)); }; };
                auto const at = [&](int x, int y) { return surface(now, tests::centre(x, y)); };
                tests::fill(frame[position], f(at));
                tests::fill(frame[receiver_previous], f(at));
                tests::fill(frame[normal], f([&](int x, int y) { return normal_at(at(x, y)); }));
                tests::fill(frame[depth], [&](int x, int y) { return static_cast<float>(now.depth(at(x, y))); });
                tests::fill(frame[glossy_hit], f([&](int x, int y) { return hit(x, y); }));
                tests::fill(frame[glossy_hit_previous], f([&](int x, int y) { return hit(x, y) + seen_moved; }));
            });
        // Near the axis, where lenses are thin.
        double worst = 0;
        for (int y = 8; y < 16; ++y)
            for (int x = 22; x < 39; ++x) {
                auto const& a = places[static_cast<std::size_t>(y * size.width + x)];
                REQUIRE(a.z > 0);
                worst = std::max(worst, glm::length(glm::dvec2(a.x, a.y) - truth(x, y)));
            }
        return worst;
    }
};
View const aside{{0.4, 0.2, 10}, {0, 0, 0}, size};
} // namespace

TEST_CASE("in a convex mirror the thin lens follows the image, where the flat mirror's is far off") {
    for (double const radius : {8.0, 12.0, 30.0}) {
        Ball const camera_moves{.radius = radius, .then = aside}, object_moves{.radius = radius, .seen_moved{0.3, 0.1, 0}};
        CHECK(camera_moves.error(MirrorMotion{ThinLens{}}) < 0.05);
        CHECK(object_moves.error(MirrorMotion{ThinLens{}}) < 0.05);
        CHECK(camera_moves.error(MirrorMotion{ThinLens{}}) < 0.25 * camera_moves.error(MirrorMotion{}));
        CHECK(object_moves.error(MirrorMotion{ThinLens{}}) < 0.25 * object_moves.error(MirrorMotion{}));
        CHECK(object_moves.error(ImageMotion{ThinLens{}}) < 0.25 * object_moves.error(ImageMotion{}));
    }
}

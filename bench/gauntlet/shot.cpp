#include <gauntlet/arithmetic.hpp>
#include <gauntlet/shot.hpp>

namespace quell::gauntlet {

View view_at(Shot const& shot, Extent size, double time) {
    Vec3 eye{0.4, 1.5, 3.2}, target{-0.1, 0.95, -2};
    Lens lens{0.85, {0, 0}};
    auto const goes = [&](Vec3 by) { eye += by * time, target += by * time; };
    if (shot.path == Path::dolly || shot.path == Path::cuts) goes({0.03, 0.004, -0.03});
    if (shot.path == Path::cuts && time >= cut_at) eye += Vec3(-1.9, 0.5, -0.4);
    if (shot.path == Path::turns) {
        double const angle = 0.1 - 0.028 * time;
        auto const way = target - eye;
        target = eye + Vec3(cosine(angle) * way.x + sine(angle) * way.z, way.y, cosine(angle) * way.z - sine(angle) * way.x);
    }
    if (shot.path == Path::zooms) lens.width *= 1.25 - 0.04 * time;
    if (shot.path == Path::shifts) lens.shift = {0.02 * time, 0.004 * time};
    return view_towards(eye, target, lens, size);
}

} // namespace quell::gauntlet

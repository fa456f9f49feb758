#include <gauntlet/arithmetic.hpp>
#include <gauntlet/sample.hpp>

#include <algorithm>

namespace quell::gauntlet {

namespace {

/// The view that vectors believe in.
View believed(Shot const& shot, Extent size, double time, double now) {
    auto view = view_at(shot, size, time);
    if (shot.vectors == Vectors::without_lens) view.lens = view_at(shot, size, now).lens;
    return view;
}

/// The mean of three times the square of a random number is 1: most samples are dark.
constexpr auto skewed = [](double u) { return 3 * u * u; };

} // namespace

Sampler::Sampler(Shot const& s, Extent size, int frame, bool noisy)
    : shot(s), world(s.world), now(time_of(s, frame)), before(time_of(s, frame - 1)), after(time_of(s, frame + 1)), is_noisy(noisy),
      view(view_at(s, size, now)), view_before(believed(s, size, before, now)), view_after(believed(s, size, after, now)) {}

/// One sample of the lamp, which is hidden or not, and one of all else; or what they are in the mean.
Sampler::Seen Sampler::light(Hit const& hit, Random& random) const {
    auto const falling = world.light_at(hit, now);
    if (!is_noisy) return {falling.direct * falling.visible, falling.indirect};
    if (shot.is_baked && hit.of->is_apart) {
        auto const grain = glm::floor(hit.local * 22.);
        Draw const of{7, 0, static_cast<int>(grain.x), static_cast<int>(grain.y), static_cast<int>(grain.z)};
        Random own(of);
        return {falling.direct * falling.visible * (0.3 + 1.4 * own.next()), falling.indirect * skewed(own.next())};
    }
    bool const reaches = happens(falling.visible, random);
    return {falling.direct * (reaches ? 0.4 + 1.2 * random.next() : 0.), falling.indirect * skewed(random.next())};
}

Vec3 Sampler::radiance(Vec3 eye, Vec3 ray, Thing const* but, Random& random) const {
    auto const hit = world.along(eye, ray, now, but);
    if (!hit.of) return world.sky_along(ray, now);
    auto const seen = light(hit, random);
    return hit.colour * (seen.direct + seen.indirect + hit.of->material.glow * world.brightness(now));
}

Vec3 Sampler::mirrored(Hit const& hit, Vec3 ray, Random& random) const {
    auto const unit = glm::normalize(ray);
    Vec3 way = unit - 2 * glm::dot(unit, hit.normal) * hit.normal;
    if (double const off = hit.of->material.roughness; off > 0) {
        double const x = random.next(), y = random.next();
        way += off * Vec3(2 * x - 1, 2 * y - 1, 2 * random.next() - 1);
        if (double const under = glm::dot(way, hit.normal); under < 0.01) way += (0.01 - under) * hit.normal;
    }
    return radiance(hit.point, way, hit.of, random);
}

Vec2 Sampler::motion(Hit const& hit, Vec3 ray, Vec2 place, View const& other, double time) const {
    if (shot.vectors == Vectors::zero || (shot.vectors == Vectors::cut_zero && has_cut(shot, now, time))) return Vec2(0.);
    if (!hit.of) {
        if (shot.vectors == Vectors::sky_zero) return Vec2(0.);
        double const by = shot.vectors == Vectors::rigid ? 0. : world.sky.spin * (now - time);
        double const s = sine(by), c = cosine(by);
        return other.place_along({c * ray.x + s * ray.z, ray.y, -s * ray.x + c * ray.z}) - place;
    }
    if (shot.vectors == Vectors::apart_zero && hit.of->is_apart) return Vec2(0.);
    auto moved = hit.point;
    if (shot.vectors == Vectors::rigid)
        moved = hit.of->place_of(hit.local * (hit.of->growth(now) / hit.of->growth(time)), time);
    else if (shot.vectors != Vectors::things_still)
        moved = hit.of->place_of(hit.local, time);
    auto const to = other.place_of(moved) - place;
    return shot.vectors == Vectors::mirrored ? Vec2(-to.x, to.y) : shot.vectors == Vectors::halved ? to * 0.5 : to;
}

void Sampler::put_guides(Pixel& pixel, Hit const& hit, Vec3 ray, Vec2 place) const {
    pixel.motion = motion(hit, ray, place, view_before, before), pixel.motion_next = motion(hit, ray, place, view_after, after);
    if (!hit.of) return;
    pixel.covered = 1;
    pixel.depth = hit.distance;
    // As Cycles has it: towards the eye.
    pixel.normal = glm::dot(hit.normal, ray) > 0 ? -hit.normal : hit.normal;
}

void Sampler::put_light(Pixel& pixel, Hit const& hit, Vec3 ray, Random& random) const {
    auto const& material = hit.of->material;
    if (material.is_clear) {
        pixel.clear_colour = Vec3(1.), pixel.clear = radiance(view.eye, ray, hit.of, random);
        return;
    }
    pixel.diffuse_colour = hit.colour * (1 - material.gloss);
    pixel.glow += hit.colour * material.glow * world.brightness(now);
    auto const seen = light(hit, random);
    pixel.direct = pixel.diffuse_colour * seen.direct, pixel.indirect = pixel.diffuse_colour * seen.indirect;
    if (material.gloss > 0) pixel.gloss_colour = Vec3(material.gloss), pixel.gloss = material.gloss * mirrored(hit, ray, random);
}

/// A sample is of the fog or of what is behind it, so that colours have the noise of that choice.
void Sampler::put_fog(Pixel& pixel, double distance, Random& random) const {
    double const clear = exponential(-world.fog * distance);
    bool const scatters = is_noisy && !happens(clear, random);
    double const rest = is_noisy ? (scatters ? 0. : 1.) : clear;
    for (auto* const part :
         {&pixel.diffuse_colour, &pixel.direct, &pixel.indirect, &pixel.gloss_colour, &pixel.gloss, &pixel.glow, &pixel.sky})
        *part *= rest;
    if (is_noisy && !scatters) return;
    pixel.volume = world.fog_light * world.brightness(now) * (is_noisy ? skewed(random.next()) : 1 - clear);
    if (is_noisy) pixel.normal = Vec3(0.);
}

bool Sampler::is_broken(Hit const& hit, Vec3 ray) const {
    using enum Part;
    if (shot.part == sky) return !hit.of;
    if (shot.part == things) return hit.of && hit.of->is_apart;
    if (shot.part == flames) return world.flames_along(view.eye, ray, now, 1e10) != Vec3(0.);
    if (shot.part != shadows || !hit.of || hit.of->shape != Shape::floor) return shot.part == shadows && hit.of && hit.of->is_apart;
    for (double const time : {before, now, after})
        if (world.light_at(hit, time).visible < 1) return true;
    return false;
}

Pixel Sampler::at(Vec2 place, Random& random) const {
    auto const ray = view.direction(place);
    auto const hit = world.along(view.eye, ray, now);
    Pixel pixel;
    put_guides(pixel, hit, ray, place);
    if (hit.of)
        put_light(pixel, hit, ray, random), pixel.alpha = 1;
    else if (!shot.is_transparent)
        pixel.sky = world.sky_along(ray, now), pixel.alpha = 1;
    if (!world.flames.empty()) pixel.glow += world.flames_along(view.eye, ray, now, hit.distance) * (is_noisy ? 2 * random.next() : 1.);
    if (world.fog > 0) put_fog(pixel, std::min(hit.distance, 30.) * std::sqrt(glm::dot(ray, ray)), random);
    pixel.broken = is_broken(hit, ray) ? 1 : 0;
    return pixel;
}

std::int64_t Sampler::surface_at(Vec2 place) const {
    auto const ray = view.direction(place);
    auto const hit = world.along(view.eye, ray, now);
    auto const number = [&](Hit const& of, Vec3 way) {
        if (of.of && of.of->material.gloss > 0) return mirror;
        return of.of ? static_cast<std::int64_t>(of.cell) * 64 + (of.of - world.things.data()) : -1 - world.sky_cell(way, now);
    };
    if (hit.of && hit.of->material.is_clear) return number(world.along(view.eye, ray, now, hit.of), ray);
    return number(hit, ray);
}

} // namespace quell::gauntlet

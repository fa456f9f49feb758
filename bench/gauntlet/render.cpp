#include <gauntlet/render.hpp>
#include <gauntlet/sample.hpp>

#include <algorithm>
#include <array>

namespace quell::gauntlet {

namespace {

/// What is added up over the samples of a pixel.
constexpr std::array light_of = {&Pixel::diffuse_colour, &Pixel::direct, &Pixel::indirect, &Pixel::gloss_colour, &Pixel::gloss,
                                 &Pixel::clear_colour,   &Pixel::clear,  &Pixel::volume,   &Pixel::glow,         &Pixel::sky};

void add(Pixel& sum, Pixel const& one, double weight) {
    for (auto const part : light_of) sum.*part += weight * (one.*part);
    sum.alpha += weight * one.alpha, sum.covered += weight * one.covered, sum.normal += weight * one.normal,
        sum.broken += weight * one.broken;
    sum.motion += weight * one.motion, sum.motion_next += weight * one.motion_next;
}

Rendered of_pixels(Extent size, auto const& pixel_at) {
    Rendered made{size, std::vector<Pixel>(static_cast<std::size_t>(size.pixels()))};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) made.at(x, y) = pixel_at(x, y);
    return made;
}

/// Each sample counts for its neighbours too.
Rendered splatted(Rendered const& from) {
    return of_pixels(from.size, [&](int x, int y) {
        auto pixel = from.at(x, y);
        for (auto const part : light_of) {
            Vec3 sum{0.};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    auto const& other = from.at(std::clamp(x + dx, 0, from.size.width - 1), std::clamp(y + dy, 0, from.size.height - 1));
                    sum += (other.*part) * ((dx == 0 ? 2. : 1.) * (dy == 0 ? 2. : 1.) / 16);
                }
            pixel.*part = sum;
        }
        return pixel;
    });
}

/// Each pixel of a half as large picture four times.
Rendered doubled(Rendered const& from, Extent size) {
    return of_pixels(size, [&](int x, int y) {
        auto pixel = from.at(std::min(x / 2, from.size.width - 1), std::min(y / 2, from.size.height - 1));
        pixel.motion *= 2., pixel.motion_next *= 2.;
        return pixel;
    });
}

/// The light that falls on things as its mean over 5x5 pixels of the same normal, as a plain denoiser makes it.
Rendered filtered(Rendered const& from) {
    auto const light = [](Vec3 product, Vec3 colour) { return product / glm::max(colour, Vec3(1e-6)); };
    return of_pixels(from.size, [&](int x, int y) {
        auto pixel = from.at(x, y);
        Vec3 direct{0.}, indirect{0.};
        double count = 0;
        for (int v = std::max(y - 2, 0); v <= std::min(y + 2, from.size.height - 1); ++v)
            for (int u = std::max(x - 2, 0); u <= std::min(x + 2, from.size.width - 1); ++u) {
                auto const& other = from.at(u, v);
                if (glm::dot(other.normal, pixel.normal) < 0.95 || std::abs(other.depth - pixel.depth) > 0.15 * pixel.depth) continue;
                direct += light(other.direct, other.diffuse_colour), indirect += light(other.indirect, other.diffuse_colour), ++count;
            }
        if (count > 0) pixel.direct = pixel.diffuse_colour * direct / count, pixel.indirect = pixel.diffuse_colour * indirect / count;
        return pixel;
    });
}

Extent rendered_size(Shot const& shot, Extent size) {
    return shot.spread == Spread::doubled ? Extent{(size.width + 1) / 2, (size.height + 1) / 2} : size;
}

Rendered spread(Rendered const& from, Shot const& shot, Extent size, bool is_reference) {
    if (shot.spread == Spread::splatted) return splatted(from);
    if (shot.spread == Spread::doubled) return doubled(from, size);
    return shot.spread == Spread::filtered && !is_reference ? filtered(from) : from;
}

/// Places of one pixel, a square of them.
template <class F> void for_each_place(int x, int y, int side, F const& f) {
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) f(Vec2(x + (i + 0.5) / side, y + (j + 0.5) / side), j * side + i);
}

/// Whether a pixel shows one surface, up to its corners, which mirrors nothing.
bool is_plain(Sampler const& sampler, int x, int y) {
    auto const first = sampler.surface_at(Vec2(x + 0.5, y + 0.5));
    if (first == Sampler::mirror) return false;
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 3; ++i)
            if (sampler.surface_at(Vec2(x + i / 3., y + j / 3.)) != first) return false;
    return true;
}

} // namespace

Rendered rendered(Shot const& shot, Making const& making, int frame) {
    auto const size = rendered_size(shot, making.size);
    Sampler const sampler(shot, size, frame, true);
    int const seed_of = shot.has_one_seed ? 0 : time_of(shot, frame);
    auto const pixel_at = [&](int x, int y) {
        int const count = shot.is_adaptive && is_plain(sampler, x, y) ? std::max(making.samples / 8, 1) : making.samples;
        Pixel sum;
        for (int s = 0; s < count; ++s) {
            Random random({making.seed, seed_of, x, y, s, shot.dither});
            double const u = random.next(), v = random.next();
            auto const one = sampler.at(Vec2(x + u, y + v), random);
            if (s == 0) sum.depth = one.depth;
            add(sum, one, 1. / count);
        }
        return sum;
    };
    return spread(of_pixels(size, pixel_at), shot, making.size, false);
}

Rendered reference(Shot const& shot, Making const& making, int frame, int half) {
    auto const size = rendered_size(shot, making.size);
    Sampler const sampler(shot, size, frame, false);
    auto const pixel_at = [&](int x, int y) {
        int const side = is_plain(sampler, x, y) ? 3 : 16;
        Pixel sum;
        for_each_place(x, y, side, [&](Vec2 place, int s) {
            Random random({-1 - half, frame, x, y, s});
            double const u = random.next() - 0.5, v = random.next() - 0.5;
            auto const one = sampler.at(place + Vec2(u, v) / static_cast<double>(side), random);
            if (s == side * side / 2) sum.depth = one.depth;
            add(sum, one, 1. / (side * side));
        });
        return sum;
    };
    return spread(of_pixels(size, pixel_at), shot, making.size, true);
}

} // namespace quell::gauntlet

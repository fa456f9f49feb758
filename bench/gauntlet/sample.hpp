#pragma once

#include <gauntlet/render.hpp>

namespace quell::gauntlet {

/// Samples of one frame.
class Sampler {
public:
    /// @param is_noisy false: light as it is expected to be, at the place of the sample
    Sampler(Shot const& shot, Extent size, int frame, bool is_noisy);

    /// What is seen at a place of the picture.
    [[nodiscard]] Pixel at(Vec2 place, Random& random) const;
    /// Which surface and check is seen there, by a number: one that mirrors others has that of mirrors.
    static constexpr std::int64_t mirror = -1'000'000'000'000;
    [[nodiscard]] std::int64_t surface_at(Vec2 place) const;

private:
    Shot const& shot;
    World const& world;
    double now, before, after;
    bool is_noisy;
    View view, view_before, view_after;

    struct Seen {
        Vec3 direct, indirect;
    };
    [[nodiscard]] bool happens(double chance, Random& random) const { return random.next() < chance; }
    [[nodiscard]] Seen light(Hit const& hit, Random& random) const;
    [[nodiscard]] Vec3 radiance(Vec3 eye, Vec3 ray, Thing const* but, Random& random) const;
    [[nodiscard]] Vec3 mirrored(Hit const& hit, Vec3 ray, Random& random) const;
    [[nodiscard]] bool is_broken(Hit const& hit, Vec3 ray) const;
    void put_guides(Pixel& pixel, Hit const& hit, Vec3 ray, Vec2 place) const;
    void put_light(Pixel& pixel, Hit const& hit, Vec3 ray, Random& random) const;
    void put_fog(Pixel& pixel, double distance, Random& random) const;
    [[nodiscard]] Vec2 motion(Hit const& hit, Vec3 ray, Vec2 place, View const& other, double time) const;
};

} // namespace quell::gauntlet

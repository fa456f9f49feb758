// The renderer of the gauntlet: its frames are, in the mean, what its references are, and its vectors lead to the same point.
#include <doctest/doctest.h>

#include <gauntlet/arithmetic.hpp>
#include <gauntlet/render.hpp>
#include <gauntlet/sample.hpp>
#include <gauntlet/situations.hpp>
#include <gauntlet/worlds.hpp>

#include <array>

using namespace quell::gauntlet;

namespace {

Shot shot_of(std::string const& name) {
    for (auto const& each : situations())
        if (each.name == name) return each.shot;
    FAIL("no situation ", name);
    return {};
}
constexpr quell::Extent small{24, 14};

double square(Vec3 v) { return glm::dot(v, v); }

} // namespace

TEST_CASE("sine, cosine and exponential are those of the standard library") {
    for (int i = -400; i <= 400; ++i) {
        double const x = 0.0371 * i;
        CHECK(sine(x) == doctest::Approx(std::sin(x)).epsilon(1e-12));
        CHECK(cosine(x) == doctest::Approx(std::cos(x)).epsilon(1e-12));
        CHECK(exponential(x) == doctest::Approx(std::exp(x)).epsilon(1e-10));
    }
}

TEST_CASE("random numbers are even, those of a lattice too") {
    for (auto const dither : {Dither::none, Dither::blue}) {
        std::array<int, 10> counts{};
        for (int x = 0; x < 100; ++x)
            for (int y = 0; y < 100; ++y) {
                Random random({5, 3, x, y, 0, dither});
                static_cast<void>(random.next());
                ++counts[static_cast<std::size_t>(random.next() * 10)];
            }
        for (int const count : counts) CHECK(std::abs(count - 1000) < 150);
    }
}

// Of N frames with other noise, the mean lies off by the noise over the root of N. The sum of squares over many numbers is nearly 1.
TEST_CASE("the mean over many seeds is the reference") {
    for (auto const* const name : {"court", "drops", "metal", "reflections", "flames", "glass", "fog", "splatted", "doubled", "blue",
                                   "adaptive", "shadows", "glow-film", "held", "flash"}) {
        INFO("situation: ", std::string(name));
        auto shot = shot_of(name);
        constexpr int count = 60, frame = 5;
        Making making{small, 8, 8};
        auto const exact = reference(shot, making, frame);
        std::vector<Vec3> sums(exact.pixels.size()), squares(exact.pixels.size());
        for (int i = 0; i < count; ++i) {
            making.seed = 100 + i;
            auto const noisy = rendered(shot, making, frame);
            for (std::size_t p = 0; p < sums.size(); ++p) {
                auto const one = noisy.pixels[p].combined();
                sums[p] += one, squares[p] += one * one;
            }
        }
        double off = 0, noise = 0;
        Vec3 bias{0.}, whole{0.};
        for (std::size_t p = 0; p < sums.size(); ++p) {
            auto const mean = sums[p] / static_cast<double>(count);
            auto const variance = (squares[p] - mean * sums[p]) / (count - 1.);
            off += square(mean - exact.pixels[p].combined());
            noise += (variance.x + variance.y + variance.z) / count;
            bias += mean - exact.pixels[p].combined(), whole += exact.pixels[p].combined();
        }
        // One number moves all of a lattice's, so that few of its pixels' errors are independent.
        CHECK(off < (shot.dither == Dither::blue ? 2.5 : 1.5) * noise);
        for (int c = 0; c < 3; ++c) CHECK(std::abs(bias[c]) < 0.006 * whole[c]);
    }
}

TEST_CASE("two references differ by little beside the noise") {
    for (auto const* const name : {"court", "metal", "drops", "sky-turns"}) {
        INFO("situation: ", std::string(name));
        auto const shot = shot_of(name);
        Making const making{{96, 54}, 8, 64};
        auto const one = reference(shot, making, 4, 0), other = reference(shot, making, 4, 1), noisy = rendered(shot, making, 4);
        double between = 0, noise = 0;
        for (std::size_t p = 0; p < one.pixels.size(); ++p) {
            between += square(one.pixels[p].combined() - other.pixels[p].combined());
            noise += square(noisy.pixels[p].combined() - one.pixels[p].combined());
        }
        CHECK(between / 2 < noise / 64); // each has an eighth of the RMSE at 64 samples at most
    }
}

// What vectors lead to, seen from there, is the same point of the same thing.
TEST_CASE("right vectors lead to the same point") {
    for (auto const* const name : {"court", "turning", "zoom", "shift", "drops", "breathing", "fast", "still"}) {
        INFO("situation: ", std::string(name));
        auto const shot = shot_of(name);
        quell::Extent const size{96, 54};
        int checked = 0;
        for (int const step : {-1, 1}) {
            Sampler const sampler(shot, size, 4, false);
            auto const here = view_at(shot, size, 4), there = view_at(shot, size, 4 + step);
            for (int y = 0; y < size.height; y += 3)
                for (int x = 0; x < size.width; x += 3) {
                    Vec2 const place(x + 0.3, y + 0.6);
                    Random random({});
                    auto const pixel = sampler.at(place, random);
                    auto const to = place + (step < 0 ? pixel.motion : pixel.motion_next);
                    auto const hit = shot.world.along(here.eye, here.direction(place), 4);
                    auto const moved = shot.world.along(there.eye, there.direction(to), 4 + step);
                    if (hit.of != moved.of) continue; // hidden there
                    if (!hit.of) {
                        auto const one = glm::normalize(here.direction(place)), other = glm::normalize(there.direction(to));
                        CHECK(glm::length(one - other) < 1e-9);
                    } else if (glm::length(hit.normal - moved.normal) < 0.5 && -glm::dot(moved.normal, there.direction(to)) > 0.15) {
                        // Neither another side, which hides it, nor the rim.
                        CHECK(glm::length(hit.local - moved.local) < 1e-6);
                    }
                    ++checked;
                }
        }
        CHECK(checked > 900);
    }
}

TEST_CASE("where two situations are twins, one thing is broken: the shots differ, and the twin is right") {
    auto const all = situations();
    std::size_t broken = 0, in_part = 0;
    for (auto const& each : all) {
        if (each.twin.empty()) continue;
        INFO("situation: ", each.name);
        ++broken, in_part += each.shot.part != Part::all;
        auto const twin = shot_of(each.twin);
        CHECK_FALSE(each.shot == twin);
        CHECK(twin.vectors == Vectors::right);
        CHECK_FALSE(twin.faults.has(Fault::zero));
    }
    CHECK(broken >= 30);
    CHECK(in_part >= 10);
}

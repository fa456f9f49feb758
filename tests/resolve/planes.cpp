#include <doctest/doctest.h>
#include <quell/execute/executor.hpp>
#include <quell/resolve/gaussian_blur.hpp>
#include <quell/resolve/moved_image.hpp>
#include <quell/resolve/picture_brightness.hpp>

#include <glm/geometric.hpp>

#include <random>

// What agreement and programs make of whole images, against double loops.
namespace {

using namespace quell;
using namespace quell::detail;
using Triple = glm::dvec3;
constexpr Extent size{37, 23};

Planes<3> random_planes(unsigned seed, float most) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-most, most);
    Planes<3> image(size);
    for (int i = 0; i < 3 * size.pixels(); ++i) image.view().set(i % 3, i / 3 % size.width, i / 3 / size.width, number(random));
    return image;
}
Triple at(Planes<3> const& image, int x, int y) { return {image.get(0, x, y), image.get(1, x, y), image.get(2, x, y)}; }
/// The sum over the pixels of a square that lie in the image.
auto sum_around(int x, int y, int radius, auto const& f) {
    auto sum = 0. * f(x, y);
    for (int j = std::max(y - radius, 0); j <= std::min(y + radius, size.height - 1); ++j)
        for (int i = std::max(x - radius, 0); i <= std::min(x + radius, size.width - 1); ++i) sum += f(i, j);
    return sum;
}
/// @param off by how much a pixel is, off(x, y)
void check(auto const& off) {
    double worst = 0.;
    for (int i = 0; i < size.pixels(); ++i)
        if (double const its = off(i % size.width, i / size.width); !(its <= worst)) worst = its;
    CHECK(worst < 1e-4);
}

} // namespace

TEST_CASE("a Gaussian's mean is that of the pixels in the image, to three deviations") {
    auto const image = random_planes(3, 1.f);
    for (auto const& [deviation, radius] : {std::pair{.7f, 3}, std::pair{2.f, 6}}) {
        auto const made = blurred(Simd{}, image.view(), deviation);
        check([&, most = radius, squared = std::pow(static_cast<double>(deviation), 2.)](int x, int y) {
            auto const weight = [&](int i, int j) { return std::exp(-.5 * ((i - x) * (i - x) + (j - y) * (j - y)) / squared); };
            auto const sum = sum_around(x, y, most, [&](int i, int j) { return weight(i, j) * at(image, i, j); });
            return glm::distance(at(made, x, y), sum / sum_around(x, y, most, weight));
        });
    }
}

TEST_CASE("a picture is as bright as its luminance, whatever its sign, and where it is not finite it is black") {
    auto const image = random_planes(3, 1.f);
    image.view().set(1, 20, 10, std::numeric_limits<float>::quiet_NaN());
    Brightness const brightness(Simd{}, image.view());
    auto const wanted = [&](int x, int y) {
        double const light = glm::dot(at(image, x, y), Triple(.2126, .7152, .0722));
        return std::isfinite(light) ? std::abs(light) : 0.;
    };
    double sum = 0.;
    check([&](int x, int y) {
        sum += wanted(x, y);
        return std::abs(static_cast<double>(brightness.of_pixels.get(0, x, y)) - wanted(x, y));
    });
    CHECK(brightness.mean == doctest::Approx(sum / size.pixels()));
}

TEST_CASE("sums over windows are those of each pixel's square, and bright pixels take nothing off dark ones") {
    auto from = random_planes(3, 1.f), to = from;
    from.view().set(0, 20, 10, 1e12f);
    for (int const radius : {0, 1, 6, 16}) {
        WindowSums<1>(size).around<1>(
            Simd{}, radius,
            [in = from.view()]<class Real>(AtOnce<Real>, int x, int y) { return std::array{in.load_component<Real>(0, x, y)}; },
            [out = to.view(), radius]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& around) {
                store_pixels<Real>(out, x, y, {around[0], pixels_in_square<Real>(x, y, radius, size), Real(0.f)}, count);
            });
        check([&](int x, int y) {
            auto const sum = sum_around(x, y, radius, [&](int i, int j) { return Triple(at(from, i, j).x, 1., 0.); });
            return glm::distance(at(to, x, y), sum) / (1. + std::abs(sum.x));
        });
    }
}

TEST_CASE("an image moved is interpolated between pixels, and unknown where its surface was outside") {
    auto const image = random_planes(3, 1.f), motion = random_planes(4, 5.f);
    motion.view().set(0, 11, 11, std::numeric_limits<float>::quiet_NaN());
    std::vector<glm::vec3> pixels(static_cast<std::size_t>(size.pixels()));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) pixels[static_cast<std::size_t>(y * size.width + x)] = image.view().get(x, y);
    auto const now = moved(Simd{}, pixels, motion.view(), glm::vec3(7.f));
    check([&](int x, int y) {
        double const column = x + at(motion, x, y).x, row = y + at(motion, x, y).y;
        bool const is_inside = column > -.5 && row > -.5 && column < size.width - .5 && row < size.height - .5;
        Triple wanted(is_inside ? 0. : 7.); // the sum by each pixel's tent, with the border repeated
        for (int j = -1; j <= size.height && is_inside; ++j)
            for (int i = -1; i <= size.width; ++i)
                wanted += std::max(1. - std::abs(column - i), 0.) * std::max(1. - std::abs(row - j), 0.) *
                          at(image, std::clamp(i, 0, size.width - 1), std::clamp(j, 0, size.height - 1));
        return glm::distance(Triple(now[static_cast<std::size_t>(y * size.width + x)]), wanted);
    });
}

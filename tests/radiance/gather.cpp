#include "../frames.hpp"

#include <baselines/colour_cones.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace quell;

// Cones of neighbours and of the past, against sums over them. What cones are by themselves is in cones.cpp.
namespace {
constexpr Extent size{20, 12};
glm::vec3 at(ImageView auto const& view, int x, int y) { return {view.get(0, x, y), view.get(1, x, y), view.get(2, x, y)}; }
glm::vec3 unit(glm::vec3 a) { return a * (1 / std::sqrt(glm::dot(a, a))); }

/// Calls f(i, j, weight) for taps around a pixel that lie in the image.
template <std::size_t n> void each_tap(int x, int y, float const (&weights)[n], auto const& f) {
    constexpr int radius = n - 1;
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i)
            if (x + i >= 0 && y + j >= 0 && x + i < size.width && y + j < size.height)
                f(x + i, y + j, weights[std::abs(i)] * weights[std::abs(j)]);
}
/// A frame of random light, each pixel's from the axis of a cone of its own.
template <class F> void fill_with_cones(F& frame, auto const& normal_at) {
    tests::fill_still(frame);
    std::mt19937 random(4);
    std::uniform_real_distribution<float> number(0.2f, 3.f);
    tests::fill(frame[normal], normal_at);
    tests::fill(frame[indirect], [&](int, int) { return glm::vec3(1, number(random), number(random)); });
    tests::fill(frame[indirect_direction],
                [&](int x, int y) { return cone::Axes<float>(normal_at(x, y)).at[(x * 5 + y * 3 + x * y) % 6]; });
}
} // namespace

TEST_CASE("a gathered pixel has the mean colour of the 3x3, as bright as their cones shade to, within their colours") {
    constexpr Pipeline denoise{indirect, Temporal{StillMotion{}, WithCones{RunningMean{}}}, Spatial{ConeGather{}}};
    Frame frame{size, denoise};
    History history{size, denoise};
    fill_with_cones(frame, [](int, int) { return glm::vec3(0, 0, 1); });
    auto const out = run(denoise, frame, history);
    int limited = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::vec3 colour(0), low(9), high(0);
            float weight = 0, mean = 0, shaded = 0, sums[6]{}, numbers[6]{};
            each_tap(x, y, {0.5f, 0.25f}, [&](int i, int j, float w) {
                auto const its = at(frame[indirect].view(), i, j);
                colour += w * its, weight += w, low = glm::min(low, its), high = glm::max(high, its);
                int const k = (i * 5 + j * 3 + i * j) % 6;
                sums[k] += w * luminance(its), numbers[k] += w, mean += w * luminance(its);
            });
            for (int k = 0; k < 6; ++k) { // each borrows a thousandth of all samples
                float const lent = 1e-3f * weight;
                shaded += cone::part(k) * (sums[k] + mean / weight * lent) / (numbers[k] + lent);
            }
            auto const wanted = colour * (shaded / mean), within = glm::clamp(wanted, low, high);
            limited += wanted != within;
            for (int c = 0; c < 3; ++c) CHECK(at(out, x, y)[c] == doctest::Approx(within[c]).epsilon(4e-3)); // cones are kept in half
        }
    CHECK(limited > 5);
}

TEST_CASE("a past that is turned is as bright as its cones say within what is seen, and counts for the samples that they have") {
    constexpr Pipeline denoise{indirect, Temporal{StillMotion{}, WithCones{RunningMean{}}, ConeFetch{}}};
    glm::vec3 const up(0, 0, 1);
    cone::Axes<float> const axes(up);
    for (auto const& each : {std::pair{axes.at[1], 1}, {glm::vec3(1, 0, 0), 1}, {axes.at[2], 4}}) {
        auto const turn = each.first;
        Frame frame{size, denoise};
        History history{size, denoise};
        Components<12, float> cones{};
        float mean = 0, seen = 0;
        for (int i = 0; i < 7; ++i) {
            float const light = i == 6 ? 1.f : i == each.second ? 8.f : .5f;
            tests::fill_still(frame);
            tests::fill(frame[normal], [&, n = i < 6 ? up : turn](int, int) { return n; });
            tests::fill(frame[indirect_direction], [&](int, int) { return i < 6 ? axes.at[i] : turn; });
            tests::fill(frame[indirect], [&](int, int) { return glm::vec3(light); });
            if (i < 6) cones.at[2 * i] = light / 6, cones.at[2 * i + 1] = 1.f / 6, mean += light / 6;
            seen = run(denoise, frame, history).get(0, 7, 5);
        }
        auto const turned = cone::transferred(cones, up, turn);
        float const past = std::clamp(cone::mean(turned), std::min(mean, 1.f), std::max(mean, 1.f));
        float const count = 6 * std::min(cone::samples(turned), 1.f);
        CHECK(count < 6);
        CHECK(seen == doctest::Approx((past * count + 1) / (count + 1)).epsilon(2e-3));
    }
}

TEST_CASE("a level of the wavelet adds cones of like normals one to one, and others by their overlap") {
    constexpr Pipeline denoise{indirect, Cones{}, Spatial{ConeAtrous<>{.levels = 1, .min_cosine = 0.5f}}};
    // Of the third kind none is near enough to another.
    glm::vec3 const normals[]{{0, 0, 1}, unit({0.5f, 0.2f, 1}), {0, -1, 0}};
    auto const normal_at = [&](int x, int y) { return normals[(x / 2 + y / 3) % 3]; };
    Frame frame{size, denoise};
    History history{size, denoise};
    fill_with_cones(frame, normal_at);
    auto const out = run(denoise, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            Components<24, float> sum{};
            auto const here = normal_at(x, y);
            each_tap(x, y, {0.375f, 0.25f, 0.0625f}, [&](int i, int j, float w) {
                auto const there = normal_at(i, j);
                if (glm::dot(here, there) < 0.5f) return;
                auto its = cone::deposit(frame[indirect].get(i, j), frame[indirect_direction].get(i, j), there);
                if (here != there) its = cone::transferred(its, there, here);
                for (int c = 0; c < 24; ++c) sum.at[c] += w * its.at[c];
            });
            auto const wanted = cone::shade(sum);
            for (int c = 0; c < 3; ++c) CHECK(at(out, x, y)[c] == doctest::Approx(wanted[c]).epsilon(1e-3));
        }
}

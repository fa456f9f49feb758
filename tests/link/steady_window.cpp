#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/steady_guides.hpp>
#include <quell/pipeline/two_sided.hpp>

#include <deque>

using namespace quell;

namespace {

constexpr Extent size{37, 23};
constexpr TwoSided denoise{presets::general(radiance, KnownSamples{}), presets::general_joining(radiance, KnownSamples{})};
using Seen = decltype(Frame{size, denoise});
constexpr int shown = 12, later = 2;

/// Depth of both things together, of whichever a sample has met, or that of samples made steady as each frame enters the window.
enum class Guides { clean, noisy, steady };

/// The mean light of a pane and the wall behind it, which move a pixel to the left in each frame.
float light_at(int x, int y, int number) {
    return .6f + .1f * std::sin(.2f * static_cast<float>(x + number)) * std::cos(.3f * static_cast<float>(y));
}
/// Each sample meets one of the two. The pane's light is three times the wall's.
void fill(Seen& frame, int number, bool is_noisy) {
    tests::fill_still(frame);
    std::mt19937 random(static_cast<unsigned>(number));
    std::bernoulli_distribution meets_pane(.5);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            bool const pane = meets_pane(random);
            frame[radiance].set(x, y, glm::vec3(light_at(x, y, number) * (pane ? 1.5f : .5f)));
            frame[depth].set(x, y, !is_noisy ? 5.f : pane ? 2.f : 8.f);
        }
    tests::fill(frame[sample_count], [](int, int) { return 1.f; });
    tests::fill(frame[motion], [](int, int) { return glm::vec2(1.f, 0.f); });
    tests::fill(frame[motion_next], [](int, int) { return glm::vec2(-1.f, 0.f); });
    frame.number = number;
}
/// What a host makes of a frame with those before it and two behind.
std::vector<float> made(Guides guides, auto const& executor) {
    History history{size, denoise};
    SteadyGuides<Channels<Depth>> steady{size};
    std::deque<Seen> window;
    std::vector<float> picture;
    for (int number = 0, next = 0; number <= shown; ++number, window.pop_front()) {
        for (; next <= number + later; ++next) {
            fill(window.emplace_back(size, denoise), next, guides != Guides::clean);
            if (guides == Guides::steady) steady.apply(window.back(), executor);
        }
        picture = tests::copy_of(run(denoise, window, history, executor));
    }
    return picture;
}
double error_of(std::vector<float> const& picture) {
    std::vector<float> clean;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) clean.insert(clean.end(), 3, light_at(x, y, shown));
    return tests::root_mean_square(picture, clean);
}

} // namespace

TEST_CASE("guides that are made steady as each frame enters the window are those that two-sided time reads") {
    double const clean = error_of(made(Guides::clean, Simd{})), noisy = error_of(made(Guides::noisy, Simd{})),
                 steady = error_of(made(Guides::steady, Simd{}));
    CHECK(clean < .5 * noisy);
    CHECK(steady < .7 * noisy);
}

TEST_CASE("steady guides and two-sided time have the same bits by every executor") {
    auto const packs = made(Guides::steady, Simd{});
    CHECK(packs != made(Guides::noisy, Simd{}));
    CHECK(tests::difference(made(Guides::steady, Serial{}), packs) < 2e-5); // the same bits where nothing is contracted
#if defined(QUELL_TEST_THREADS)
    CHECK(packs == made(Guides::steady, Threads{}));
    CHECK(packs == made(Guides::steady, Threads<>{.count = 3, .tile = {16, 5}}));
#endif
}

#include "../frames.hpp"
#include "../jitter.hpp"
#include "../threads.hpp"

#include <quell/link/resolve/resolve.hpp>
#include <quell/presets/resolve.hpp>

using namespace quell;
using tests::copy_of;

// Resolve as a link, which has frames of its own size.
namespace {

constexpr Extent size{45, 21};
constexpr auto plain = presets::none(radiance);
constexpr Chain by_link{plain, Pipeline{denoised, Spatial{Resolve{}}}};
constexpr auto by_any_size = presets::resolve(plain);

/// The last of some frames in which things move by their own ways, away from the border.
template <class P> std::vector<float> last_of(P const& denoiser, unsigned frames, auto const& executor) {
    Frame frame{size, denoiser};
    History history{size, denoiser};
    std::vector<float> made;
    for (unsigned i = 0; i < frames; ++i) {
        tests::fill_randomly(frame, i);
        tests::fill(frame[depth], [](int x, int y) { return 2.f + static_cast<float>((x / 5 + y / 4) % 3); });
        tests::fill(frame[motion], [&](int x, int y) {
            return glm::vec2(.7f - static_cast<float>((x / 5 + y / 4) % 3), .3f * static_cast<float>(i % 3) - .4f);
        });
        frame.camera.jitter = tests::jitter_of(static_cast<int>(i));
        made = copy_of(run(denoiser, frame, history, executor));
    }
    return made;
}
std::vector<float> inner(std::vector<float> const& picture, int border) {
    std::vector<float> all;
    for (int y = border; y < size.height - border; ++y)
        for (int x = border; x < size.width - border; ++x)
            for (int c = 0; c < 3; ++c) all.push_back(picture[static_cast<std::size_t>((y * size.width + x) * 3 + c)]);
    return all;
}

} // namespace

TEST_CASE("resolve: a link makes of frames of its own size what presets::resolve makes") {
    for (unsigned const frames : {1u, 2u, 3u, 5u, 9u}) {
        CAPTURE(frames);
        // What leaves the image is told apart by the places of samples here, by those of pixels there.
        CHECK(tests::difference(inner(last_of(by_link, frames, Simd{}), 6), inner(last_of(by_any_size, frames, Simd{}), 6)) < 1e-4);
    }
}

TEST_CASE("resolve: a link has the same picture by single pixels, packs and threads") {
    auto const packs = last_of(by_link, 9, Simd{});
    CHECK(tests::all_finite(packs));
    CHECK(tests::difference(last_of(by_link, 9, Serial{}), packs) < 1e-3);
#if defined(QUELL_TEST_THREADS)
    CHECK(last_of(by_link, 9, Threads<>{.count = 3}) == packs);
#endif
}

TEST_CASE("resolve: a link sharpens as presets::resolve does") {
    constexpr Resolve sharp{GaussianKernel{}, MeanDeviation{.sigmas = 1.5f}, YCoCg{}, Sharpen{}};
    constexpr Chain link{plain, Pipeline{denoised, Spatial{sharp}}};
    auto const made = last_of(link, 4, Simd{});
    CHECK(tests::difference(inner(made, 7), inner(last_of(presets::resolve(plain, sharp), 4, Simd{}), 7)) < 1e-4);
    CHECK(tests::difference(made, last_of(by_link, 4, Simd{})) > 1e-2);
    // To the border where nothing moves.
    auto const still = [](auto const& denoiser) {
        Frame frame{size, denoiser};
        History history{size, denoiser};
        tests::fill_randomly(frame, 1);
        return copy_of(run(denoiser, frame, history));
    };
    CHECK(tests::difference(still(link), still(presets::resolve(plain, sharp))) < 1e-4);
}

TEST_CASE("resolve: a link begins anew at a cut, and refuses wrong jitter") {
    Frame frame{size, by_link};
    History history{size, by_link}, fresh{size, by_link};
    for (unsigned i = 0; i < 4; ++i) tests::fill_randomly(frame, i), run(by_link, frame, history);
    history.forget();
    for (unsigned i = 4; i < 7; ++i) {
        tests::fill_randomly(frame, i);
        CHECK(copy_of(run(by_link, frame, history)) == copy_of(run(by_link, frame, fresh)));
    }
    frame.camera.jitter = {9.f, 0.f};
    CHECK(tests::message([&] { run(by_link, frame, history); }).find("frame.camera.jitter") != std::string::npos);
}

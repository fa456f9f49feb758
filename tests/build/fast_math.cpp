#include <quell/quell.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <vector>

// Under -ffast-math a compiler may delete every test for NaN, and the numbers below may not be compared as floats: everything here is
// made from bits and judged by bits.

namespace {

constexpr quell::Extent size{37, 21}; // not a whole number of packs
constexpr float light = 0.5f;

float number(std::uint32_t bits) { return std::bit_cast<float>(bits); }
bool finite(float a) { return (std::bit_cast<std::uint32_t>(a) & 0x7f800000u) != 0x7f800000u; }

constexpr std::uint32_t not_a_number = 0x7fc00000u, signalling = 0xff800001u, infinity = 0x7f800000u, minus_infinity = 0xff800000u,
                        minus_one = 0xbf800000u, enormous = 0x7149f2cau /* 1e30 */, denormal = 0x00000123u;

/// Sets all components of a pixel.
void put(auto& image, int x, int y, std::uint32_t bits) {
    auto const view = image.view();
    for (int c = 0; c < view.components; ++c) view.set(c, x, y, number(bits));
}

/// A wall in even light, head-on; nothing moves.
template <class F> void fill(F& frame) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame[quell::radiance].set(x, y, {light, light, light});
            quell::for_each_channel(typename F::channels{}, [&](auto c) {
                if constexpr (std::is_same_v<decltype(c), quell::Albedo>) frame[c].set(x, y, {0.8f, 0.4f, 0.2f});
                if constexpr (std::is_same_v<decltype(c), quell::Normal>) frame[c].set(x, y, {0.f, 0.f, 1.f});
                if constexpr (std::is_same_v<decltype(c), quell::Depth>) frame[c].set(x, y, 3.f);
                if constexpr (std::is_same_v<decltype(c), quell::Motion>) frame[c].set(x, y, {0.f, 0.f});
            });
        }
}

/// Where samples go missing: a lone pixel, all four corners, a whole row, and a block wider than any filter of one pass.
bool in_burst(int x, int y) {
    bool const corner = (x == 0 || x == size.width - 1) && (y == 0 || y == size.height - 1);
    return (x == 5 && y == 5) || corner || y == 12 || (x >= 18 && x < 27 && y >= 2 && y < 10);
}

template <class F> long long spoil_radiance(F& frame) {
    constexpr std::uint32_t kinds[] = {not_a_number, infinity, minus_one, enormous, minus_infinity, signalling};
    long long spoilt = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (in_burst(x, y)) put(frame[quell::radiance], x, y, kinds[spoilt++ % 6]);
    return spoilt;
}

/// NaN in every channel but the signal.
template <class F> void spoil_guides(F& frame) {
    quell::for_each_channel(typename F::channels{}, [&](auto c) {
        if constexpr (!std::is_same_v<decltype(c), quell::Radiance>)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    if (in_burst(x, y)) put(frame[c], x, y, x % 2 == 0 ? not_a_number : infinity);
    });
}

struct Seen {
    bool finite = true;
    float low = 1e9f, high = -1e9f;
};
Seen look(auto const& image) {
    Seen seen;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) {
                float const a = image.get(c, x, y);
                seen.finite = seen.finite && finite(a);
                seen.low = a < seen.low ? a : seen.low;
                seen.high = a > seen.high ? a : seen.high;
            }
    return seen;
}

void check_even(Seen const& seen) {
    CHECK(seen.finite);
    CHECK(seen.low > light * 0.999f);
    CHECK(seen.high < light * 1.001f);
}

/// A burst after clean frames, a burst in the very first frame, spoilt guides, and denormals: nothing may show once they are over.
template <class P> void survive(P const& denoise) {
    quell::Frame frame{size, denoise};
    quell::History history{size, denoise};
    for (bool const from_the_start : {true, false}) {
        history.forget();
        fill(frame);
        if (!from_the_start) check_even(look(quell::run(denoise, frame, history)));

        auto const spoilt = spoil_radiance(frame);
        for (int i = 0; i < 3; ++i) {
            CHECK(look(quell::run(denoise, frame, history)).finite);
            CHECK(history.statistics().missing_samples == spoilt);
        }
        spoil_guides(frame);
        CHECK(look(quell::run(denoise, frame, history)).finite);
        fill(frame);
        spoil_guides(frame);
        CHECK(look(quell::run(denoise, frame, history)).finite);
        CHECK(history.statistics().missing_samples == 0);

        fill(frame);
        auto const after = look(quell::run(denoise, frame, history));
        CHECK(after.finite);
        CHECK(history.statistics().missing_samples == 0);
        for (int i = 0; i < 3; ++i) check_even(look(quell::run(denoise, frame, history)));
    }
    for (int i = 0; i < 3; ++i) {
        for (int x = 0; x < size.width; ++x) put(frame[quell::radiance], x, 7, denormal);
        auto const seen = look(quell::run(denoise, frame, history));
        CHECK(seen.finite);
        CHECK(seen.low >= 0.f);
        CHECK(seen.high < light * 1.001f);
        CHECK(history.statistics().missing_samples == 0);
    }
}

} // namespace

TEST_CASE("bad samples and guides never spread: none") { survive(quell::presets::none(quell::radiance)); }
TEST_CASE("bad samples and guides never spread: surface") { survive(quell::presets::surface(quell::radiance)); }
TEST_CASE("bad samples and guides never spread: surface_clamp") { survive(quell::presets::surface_clamp(quell::radiance)); }
TEST_CASE("bad samples and guides never spread: atrous") { survive(quell::presets::atrous(quell::radiance, quell::Demodulate{})); }
TEST_CASE("bad samples and guides never spread: svgf") { survive(quell::presets::svgf(quell::radiance, quell::Demodulate{})); }

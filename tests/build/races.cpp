#include <quell/quell.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <thread>

// For ThreadSanitizer. It can't follow oneTBB, whose library is not instrumented: the beginning and end of every parallel loop look like
// races. Threads of the standard library it does follow, and what must be free of races is the same: that one pass's job may run
// on any pixels at once. It also overlooks whatever is wider than 16 bytes, so its preset compiles for no particular machine (QUELL_NATIVE
// off), which gives packs of four.

namespace {

/// Small tiles dealt to two threads in turn, so that every tile's neighbours belong to the other thread.
struct TwoThreads {
    quell::Extent tile{13, 3}; // no whole number of packs: the last of a row must leave the neighbouring tile alone

    void for_each_pixel(quell::Region r, auto const& job) const {
        std::thread other([&] { every_second_tile(r, job, 1); });
        every_second_tile(r, job, 0);
        other.join();
    }

private:
    void every_second_tile(quell::Region r, auto const& job, int which) const {
        int row = 0;
        for (int y = r.y0; y < r.y1; y += tile.height, ++row) {
            int column = 0;
            for (int x = r.x0; x < r.x1; x += tile.width, ++column)
                if ((row + column) % 2 == which)
                    quell::Simd{}.for_each_pixel({x, y, least(x + tile.width, r.x1), least(y + tile.height, r.y1)}, job);
        }
    }
    static int least(int a, int b) { return a < b ? a : b; }
};

constexpr quell::Extent size{53, 17};
constexpr auto denoise = quell::presets::svgf(quell::radiance, quell::Demodulate{}, quell::SuppressFireflies{});

/// Noise over a slope that moves by a fraction of a pixel; a few samples are missing.
void render(auto& frame, std::uint32_t& state) {
    auto const random = [&] { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) * 0x1p-24f; };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const missing = random() < 0.02f ? -1.f : 1.f;
            frame[quell::radiance].set(x, y, {random() * missing, random(), random() * 4.f});
            frame[quell::albedo].set(x, y, {0.5f, 0.25f, 1.f});
            frame[quell::normal].set(x, y, {0.f, 0.6f, 0.8f});
            frame[quell::depth].set(x, y, 3.f + 0.01f * static_cast<float>(y));
            frame[quell::motion].set(x, y, {0.3f, -0.4f});
        }
}

long long differences(auto const& a, auto const& b) {
    long long count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) count += a.get(c, x, y) != b.get(c, x, y);
    return count;
}

} // namespace

TEST_CASE("the passes of svgf may run on any pixels at once") {
    quell::Frame frame{size, denoise};
    quell::History one{size, denoise}, two{size, denoise};
    std::uint32_t state = 1;
    for (int i = 0; i < 4; ++i) {
        render(frame, state);
        auto const expected = quell::run(denoise, frame, one, quell::Simd{});
        auto const shared = quell::run(denoise, frame, two, TwoThreads{});
        CHECK(differences(expected, shared) == 0);
        CHECK(one.statistics().missing_samples == two.statistics().missing_samples);
        CHECK(one.statistics().suppressed == two.statistics().suppressed);
    }
}

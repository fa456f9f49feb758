#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/two_sided.hpp>

#include <deque>

using namespace quell;

namespace {
constexpr Extent size{64, 48};
constexpr auto one_sided = presets::general(radiance, KnownSamples{});
constexpr TwoSided denoise{one_sided, presets::general_joining(radiance, KnownSamples{})};
using P = std::remove_const_t<decltype(one_sided)>;
using OneFrame = Frame<decltype(denoise)::reads>;

/// Light that `truth(x, y, number)` says, with noise; nothing moves.
OneFrame frame_of(long long number, auto&& truth) {
    OneFrame frame{size};
    tests::fill_still(frame);
    std::mt19937 random(static_cast<unsigned>(number) + 100);
    std::exponential_distribution<float> noise(1.f);
    tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(truth(x, y, number) * (0.5f + 0.5f * noise(random))); });
    tests::fill(frame[sample_count], [](int, int) { return 1.f; });
    frame.number = number;
    return frame;
}
/// What is made of frame `last`, with so many frames after it.
std::vector<float> made(int last, int after, auto&& truth, auto const& executor, auto&& change) {
    History history{size, denoise};
    std::vector<float> out;
    for (int i = 0; i <= last; ++i) {
        std::deque<OneFrame> window;
        for (int k = 0; k <= (i == last ? after : 0); ++k) window.push_back(frame_of(i + k, truth));
        change(window);
        out = tests::copy_of(run(denoise, window, history, executor));
    }
    return out;
}
std::vector<float> made(int last, int after, auto&& truth) {
    return made(last, after, truth, Simd{}, [](auto&) {});
}

double error(std::vector<float> const& out, int number, auto&& truth) {
    double sum = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double const off = out[static_cast<std::size_t>(3 * (y * size.width + x))] - truth(x, y, number);
            sum += off * off;
        }
    return std::sqrt(sum / static_cast<double>(size.pixels()));
}
float still(int x, int y, long long) {
    return 1.f + 0.3f * std::sin(0.2f * static_cast<float>(x)) * std::cos(0.3f * static_cast<float>(y));
}
/// Light that moves two pixels a frame.
float moving(int x, int, long long number) { return 1.f + 0.8f * std::sin(0.2f * static_cast<float>(x - 2 * number)); }
} // namespace

TEST_CASE("without its scratch a history is smaller, and the next frame the same") {
    History kept{size, denoise}, released{size, denoise};
    std::size_t most = 0, least = 0;
    for (int i = 0; i < 4; ++i) {
        std::deque<OneFrame> window;
        for (int k = 0; k < 3; ++k) window.push_back(frame_of(i + k, moving));
        auto const expected = tests::copy_of(run(denoise, window, kept));
        CHECK(tests::copy_of(run(denoise, window, released)) == expected);
        most = released.bytes();
        CHECK(most <= kept.bytes());
        released.release_scratch();
        least = released.bytes();
        CHECK(released.after.bytes() == 0);
    }
    CHECK(least > 0);
    CHECK(least < most / 2);
}

TEST_CASE("frames without numbers follow each other, and those after one are accumulated anew in each call") {
    History numbered{size, denoise}, plain{size, denoise};
    for (int i = 0; i < 3; ++i) {
        std::deque<OneFrame> window;
        for (int k = 0; k < 3; ++k) window.push_back(frame_of(i + k, moving));
        auto const expected = tests::copy_of(run(denoise, window, numbered));
        for (auto& frame : window) frame.number.reset();
        CHECK(tests::copy_of(run(denoise, window, plain)) == expected);
    }
}

TEST_CASE("frames from after lower the noise of one that has few before it, and the lag of light that moves") {
    CHECK(error(made(0, 2, still), 0, still) < 0.85 * error(made(0, 0, still), 0, still));
    CHECK(error(made(8, 2, moving), 8, moving) < 0.95 * error(made(8, 0, moving), 8, moving));
}

TEST_CASE("a window of one frame is run()") {
    Frame<P::reads> frame{size};
    History history{size, one_sided};
    std::vector<float> out;
    for (int i = 0; i < 3; ++i) {
        auto const source = frame_of(i, still);
        for_each_channel(P::reads{}, [&](auto c) {
            tests::fill(frame[c], [&](int x, int y) {
                return make_value<decltype(c)::components, float>([&](auto k) { return source[c].view().get(k, x, y); });
            });
        });
        frame.number = i;
        out = tests::copy_of(run(one_sided, frame, history));
    }
    CHECK(made(2, 0, still) == out);
}

TEST_CASE("a gap in the numbers or another size ends the window, and an empty one is refused") {
    auto const gap = [](auto& window) {
        if (window.size() > 1) window[1].number = 100;
    };
    CHECK(made(3, 2, still, Simd{}, gap) == made(3, 0, still));
    auto const larger = [](auto& window) {
        if (window.size() > 2) window[2] = OneFrame{Extent{8, 8}};
    };
    CHECK(made(3, 2, still, Simd{}, larger) == made(3, 1, still));
    auto const next_is_smaller = [](auto& window) {
        if (window.size() > 1) window[1] = OneFrame{Extent{8, 8}};
    };
    CHECK(made(3, 2, still, Simd{}, next_is_smaller) == made(3, 0, still));
    std::deque<OneFrame> none;
    History history{size, denoise};
    CHECK(tests::message([&] { run(denoise, none, history); }).find("no frames") != std::string::npos);
}

TEST_CASE("frames from after a cut change next to nothing") {
    auto const cut = [](int x, int y, long long number) { return number > 3 ? 8.f : still(x, y, number); };
    auto const with = made(3, 2, cut), without = made(3, 0, cut);
    CHECK(error(with, 3, cut) < 1.3 * error(without, 3, cut));
}

TEST_CASE("frames are left as they were, and threads compute the same") {
    std::deque<OneFrame> window;
    for (int i = 0; i < 3; ++i)
        window.push_back(frame_of(i, moving)), tests::fill(window.back()[motion_next], [](int, int) { return glm::vec2(0.5f); });
    std::vector<std::vector<float>> before, after;
    auto const keep = [&](auto& where) {
        for (auto& frame : window)
            for_each_channel(OneFrame::channels{}, [&](auto c) { where.push_back(tests::copy_of(frame[c].view())); });
    };
    keep(before);
    History history{size, denoise};
    run(denoise, window, history);
    keep(after);
    CHECK(before == after);
    CHECK(window[1].number == 1);
#if defined(QUELL_TEST_THREADS)
    CHECK(made(2, 2, moving) == made(2, 2, moving, Threads<>{.count = 3, .tile = {7, 5}}, [](auto&) {}));
#endif
}

TEST_CASE("motion that is not finite towards the next frame, all-zero samples and bad values harm nothing") {
    float const nan = std::bit_cast<float>(0x7fc00000u);
    auto const spoil = [&](auto& window) {
        for (auto& frame : window) {
            tests::fill(frame[motion_next], [&](int x, int) { return glm::vec2(x % 2 ? nan : 1e30f); });
            tests::fill(frame[sample_variance], [&](int x, int) { return x % 3 ? nan : -1.f; });
        }
    };
    CHECK(tests::all_finite(made(2, 2, still, Simd{}, spoil)));
    auto const dark = [](int, int, long long) { return 0.f; };
    for (float const a : made(2, 2, dark)) CHECK(a == 0.f);
}

TEST_CASE("what a host says of the variance of a single sample is not passed on") {
    auto const says = [](auto& window) { tests::fill(window[0][sample_variance], [](int, int) { return 3.f; }); };
    CHECK(made(0, 2, still, Simd{}, says) == made(0, 2, still));
}

TEST_CASE("frames in the host's memory give the same, and stay as they are") {
    using HostFrame = Frame<OneFrame::channels, Borrowed<>>;
    auto const truth = [](int x, int y, long long) { return still(x, y, 0); };
    std::deque<OneFrame> own;
    for (int i = 0; i < 3; ++i) own.push_back(frame_of(i, truth));
    auto const before = tests::copy_of(own[0][radiance].view());
    std::deque<HostFrame> borrowed;
    for (auto& frame : own) {
        auto& other = borrowed.emplace_back(size);
        other.number = frame.number;
        for_each_channel(OneFrame::channels{}, [&](auto c) {
            auto const view = frame[c].view();
            auto const apart = c.components > 1 ? view.planes[c.components - 1] - view.planes[c.components - 2] : 1;
            other[c] = {view.planes[0], size, 1, view.row_stride(), apart};
        });
    }
    History history{size, denoise}, host_history{size, denoise};
    auto const out = tests::copy_of(run(denoise, borrowed, host_history, Simd{}));
    CHECK(tests::copy_of(own[0][radiance].view()) == before);
    CHECK(out == tests::copy_of(run(denoise, own, history, Simd{})));
}

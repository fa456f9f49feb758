#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{43, 27};
constexpr auto general = presets::general(radiance, Demodulate{});
template <SamplePattern pattern> using Fewer = Subsampled<pattern, Channels<Radiance>>;

/// Two surfaces side by side under a light that fades across them, without noise.
glm::vec3 smooth_light(int x, int) {
    return (0.4f + 0.01f * static_cast<float>(x)) * (x < 20 ? glm::vec3(1, 0.8f, 0.6f) : glm::vec3(0.2f));
}
template <class F> void fill_guides(F& frame) {
    tests::fill_still(frame);
    tests::fill(frame[depth], [](int x, int) { return x < 20 ? 4.f : 9.f; });
    if constexpr (F::template has<Albedo>)
        tests::fill(frame[albedo], [](int x, int y) { return glm::vec3((x + y) % 3 == 0 ? 0.9f : 0.3f); });
}
template <class F> void fill_light(F& frame, auto&& light) {
    tests::fill(frame[radiance], [&](int x, int y) { return light(x, y) * frame[albedo].get(x, y); });
}

/// What comes out of some frames of a light: light(x, y) before it is multiplied by the albedo.
template <SamplePattern pattern> std::vector<float> denoised(int frames, bool moves, auto&& light) {
    Frame frame{size, general, Fewer<pattern>{}};
    History history{size, general};
    fill_guides(frame);
    std::vector<float> out;
    for (int i = 0; i < frames; ++i) {
        frame[radiance].phase = moves ? pattern.phase(i) : glm::ivec2(0);
        fill_light(frame, light);
        out = tests::copy_of(run(general, frame, history));
        CHECK(history.statistics().missing_samples > 0);
    }
    return out;
}
std::vector<float> of_all_pixels(int frames, auto&& light) {
    Frame frame{size, general};
    History history{size, general};
    fill_guides(frame);
    std::vector<float> out;
    for (int i = 0; i < frames; ++i) fill_light(frame, light), out = tests::copy_of(run(general, frame, history));
    return out;
}
template <SamplePattern pattern> void check_light() {
    CAPTURE(pattern.columns);
    CAPTURE(pattern.rows);
    CAPTURE(pattern.staggered);
    auto const even = [](int, int) { return glm::vec3(0.7f, 0.5f, 0.3f); };
    for (bool const moves : {true, false}) {
        CHECK(tests::difference(denoised<pattern>(3, moves, even), of_all_pixels(3, even)) < 1e-5);
        // Where every pixel had a sample, it has its own light; else the light of its surface's next sample.
        auto const fading = denoised<pattern>(12, moves, smooth_light), truth = of_all_pixels(12, smooth_light);
        CHECK(tests::root_mean_square(fading, truth) < (moves ? 0.002 : 0.006));
    }
}
} // namespace

TEST_CASE("a signal of fewer samples than pixels: light that is even stays so, and light without noise comes out nearly as of all pixels") {
    check_light<half_size>();
    check_light<half_width>();
    check_light<half_height>();
    check_light<checkerboard>();
}

TEST_CASE("a filter without history, with taps 1, 2, 4, ... pixels apart, never sees holes alone") {
    constexpr auto atrous = presets::atrous(radiance, Demodulate{});
    auto const filtered = [&](auto storage, glm::ivec2 phase) {
        Frame frame{size, atrous, storage};
        History history{size, atrous};
        fill_guides(frame);
        if constexpr (requires { frame[radiance].phase; }) frame[radiance].phase = phase;
        fill_light(frame, smooth_light);
        return tests::copy_of(run(atrous, frame, history));
    };
    auto const whole = filtered(Planar<>{}, {});
    for (int number = 0; number < half_size.phases(); ++number)
        CHECK(tests::root_mean_square(filtered(Fewer<half_size>{}, half_size.phase(number)), whole) < 0.01);
    for (int number = 0; number < checkerboard.phases(); ++number)
        CHECK(tests::root_mean_square(filtered(Fewer<checkerboard>{}, checkerboard.phase(number)), whole) < 0.01);
}

TEST_CASE("pixels without a sample are missing samples: the same bits as with NaN there, in all executors") {
    auto const with_nan = [](auto const& executor) {
        return tests::sequence(general, size, executor, [](auto& frame, unsigned i) {
            auto const phase = checkerboard.phase(i);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    if (!checkerboard.has(x, y, phase)) frame[radiance].set(x, y, glm::vec3(std::bit_cast<float>(0x7fc00000u)));
        });
    };
    auto const subsampled = [](auto const& executor) {
        Frame frame{size, general, Fewer<checkerboard>{}};
        Frame whole{size, general};
        History history{size, general};
        std::vector<float> out;
        for (unsigned i = 0; i < 3; ++i) {
            tests::fill_randomly(whole, i);
            frame[radiance].phase = checkerboard.phase(i);
            for_each_channel(typename decltype(frame)::channels{},
                             [&](auto c) { tests::fill(frame[c], [&](int x, int y) { return whole[c].get(x, y); }); });
            out = tests::copy_of(run(general, frame, history, executor));
        }
        return out;
    };
    CHECK(tests::difference(subsampled(Simd{}), with_nan(Simd{})) == 0);
    CHECK(tests::difference(subsampled(Serial{}), with_nan(Serial{})) == 0);
}

TEST_CASE("no light is lost or made of noise") {
    std::mt19937 random(5);
    auto const noisy = [&](int, int) { return glm::vec3(0.6f * std::exponential_distribution<float>(1.f)(random)); };
    auto const kept = [&](auto const& make) {
        double sum = 0, all = 0;
        for (int run = 0; run < 6; ++run) {
            auto const out = make();
            std::size_t i = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x, i += 3) sum += out[i], all += 0.6 * ((x + y) % 3 == 0 ? 0.9 : 0.3);
        }
        return sum / all;
    };
    CHECK(kept([&] { return denoised<half_size>(32, true, noisy); }) == doctest::Approx(1).epsilon(0.02));
    CHECK(kept([&] { return denoised<checkerboard>(32, true, noisy); }) == doctest::Approx(1).epsilon(0.02));
    CHECK(kept([&] { return denoised<half_size>(32, false, noisy); }) == doctest::Approx(1).epsilon(0.03));
}

TEST_CASE("a pixel that never gets a sample follows its surface's next pixels that do, and not the frame in which it was first seen") {
    constexpr auto accumulated = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{.cap = 4}}};
    Frame frame{size, accumulated, Fewer<half_size>{}}; // the phase stays
    History history{size, accumulated};
    fill_guides(frame);
    ViewOf<Planar<>, Radiance> out;
    for (int i = 0; i < 48; ++i) {
        float const light = i < 4 ? 5.f : 1.f;
        tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(x < 20 ? light : 3 * light); });
        out = run(accumulated, frame, history);
    }
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) REQUIRE(out.get(0, x, y) == doctest::Approx(x < 20 ? 1 : 3).epsilon(1e-3));
}

TEST_CASE("an image of samples of another size is refused with the size to give, and one without memory") {
    Frame frame{size, general, Subsampled<half_size, Channels<Radiance>, Borrowed<>>{}};
    Frame own{size, general, Fewer<half_size>{}};
    History history{size, general};
    std::vector<float> memory(static_cast<std::size_t>(size.pixels() * 3));
    own[radiance] = Planar<>::Image<3>({20, 14});
    CHECK(
        tests::message([&] { run(general, own, history); }) ==
        "channel 'radiance': samples of 20x14 in a frame of 43x27, one for each 2x2; give it 22x14, or an image of the frame's size, whose "
        "other pixels are not read");
    CHECK(tests::message([&] { run(general, frame, history); }) ==
          "channel 'radiance': no memory; point the channel at the host's image before run()");
    frame[radiance] = {memory.data(), {22, 14}, 3, 0};
    CHECK(tests::message([&] { run(general, frame, history); }) ==
          "channel 'radiance': row_stride 0; give the distance from a row to the next, in elements");
}

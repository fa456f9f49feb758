#include "../frames.hpp"
#include "../threads.hpp"

#include <array>
#include <new>
#include <string_view>

using namespace quell;

namespace {
constexpr Extent size{40, 25};
float const not_a_number = std::bit_cast<float>(0x7fc00000u), infinity = std::bit_cast<float>(0x7f800000u);
constexpr auto svgf = presets::svgf(radiance, Demodulate{});
constexpr auto surface = presets::surface(radiance);

template <class F> void every_pixel(F& frame, glm::vec3 colour) {
    tests::fill_still(frame);
    tests::fill(frame[radiance], [&](int, int) { return colour; });
}

/// Throws after the named pass.
struct StopsAt {
    std::string_view pass;
    template <class Job> void for_each_pixel(Region region, Job const& job) const {
        Serial{}.for_each_pixel(region, job);
        if (Job::name == pass) throw std::bad_alloc{};
    }
};
} // namespace

TEST_CASE("history starts afresh at the first frame, a new size, a gap in the numbers, and on demand") {
    Frame frame{size, surface};
    History history{size, surface};
    auto const show = [&](float light, std::optional<long long> number) {
        every_pixel(frame, glm::vec3(light));
        frame.number = number;
        return run(surface, frame, history).get(0, 5, 5);
    };
    CHECK(show(1, 0) == 1.f);
    CHECK(show(3, 1) == doctest::Approx(1.2));
    CHECK(show(5, 3) == 5.f); // frame 2 is missing
    CHECK(show(3, 4) == doctest::Approx(4.8));
    history.forget();
    CHECK(show(7, 5) == 7.f);
    CHECK(history.statistics().resets == 3);
    CHECK(show(7, 5) == 7.f); // the same number again: not the next frame
    Frame larger{Extent{64, 8}, surface};
    every_pixel(larger, glm::vec3(2));
    auto const out = run(surface, larger, history);
    CHECK(out.size == Extent{64, 8});
    CHECK(out.get(0, 63, 7) == 2.f);
    CHECK(history.statistics().frames == 1);
}

TEST_CASE("a frame that an exception ends leaves nothing behind: the next one starts afresh, in the same memory") {
    for (auto const pass : {"ingest", "temporal", "variance-guided a-trous"}) {
        CAPTURE(pass);
        Frame frame{size, svgf};
        History history{size, svgf}, fresh{size, svgf};
        for (float const light : {1.f, 2.f}) every_pixel(frame, glm::vec3(light)), run(svgf, frame, history, Serial{});
        auto const memory = history.bytes();
        CHECK_THROWS_AS(run(svgf, frame, history, StopsAt{pass}), std::bad_alloc);
        for (float const light : {3.f, 5.f}) {
            every_pixel(frame, glm::vec3(light));
            CHECK(tests::copy_of(run(svgf, frame, history, Serial{})) == tests::copy_of(run(svgf, frame, fresh, Serial{})));
        }
        CHECK(history.bytes() == memory);
    }
}

TEST_CASE("samples that are no light are missing: they never spread, and are counted") {
    for (float const bad : {not_a_number, infinity, -infinity, -1.f, 3e38f}) {
        Frame frame{size, svgf};
        History history{size, svgf};
        std::vector<float> out;
        for (int i = 0; i < 6; ++i) {
            every_pixel(frame, glm::vec3(0.5f));
            if (i % 2 == 0) frame[radiance].set(7, 9, {0.5f, bad, 0.5f});
            if (i == 4)
                for (int x = 20; x < 40; ++x)
                    for (int y = 3; y < 20; ++y) frame[radiance].set(x, y, glm::vec3(bad));
            out = tests::copy_of(run(svgf, frame, history));
            CHECK(history.statistics().missing_samples == (i == 4 ? 1 + 20 * 17 : i % 2 == 0 ? 1 : 0));
            for (float const a : out) CHECK(a == doctest::Approx(0.5).epsilon(1e-4));
        }
    }
}

TEST_CASE("denormal samples and -0 are light like any other") {
    Frame frame{size, surface};
    History history{size, surface};
    every_pixel(frame, glm::vec3(1e-40f, -0.f, 0.f));
    run(surface, frame, history);
    CHECK(history.statistics().missing_samples == 0);
}

TEST_CASE("any bits in any channel give finite output, and a good frame afterwards is good again") {
    auto const burst = [](auto const& pipeline) {
        using P = std::remove_cvref_t<decltype(pipeline)>;
        Frame frame{size, pipeline};
        History history{size, pipeline};
        std::mt19937 random(4);
        for (int i = 0; i < 12; ++i) {
            tests::fill_randomly(frame, static_cast<unsigned>(i));
            for_each_channel(typename P::reads{}, [&](auto c) {
                if (i % 3 != 2)
                    tests::fill(frame[c], [&](int, int) {
                        return make_value<decltype(c)::components, float>(
                            [&](auto) { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); });
                    });
            });
            CHECK(tests::all_finite(tests::copy_of(run(pipeline, frame, history))));
        }
        every_pixel(frame, glm::vec3(0.25f));
        history.forget();
        for (float const a : tests::copy_of(run(pipeline, frame, history))) CHECK(a == doctest::Approx(0.25).epsilon(1e-4));
    };
    burst(presets::none(radiance, Demodulate{}, SuppressFireflies{}));
    burst(surface);
    burst(presets::surface_clamp(radiance));
    burst(presets::atrous(radiance, Demodulate{}));
    burst(svgf);
}

TEST_CASE("demodulation is undone exactly, also for black surfaces, albedo above 1 and nonsense") {
    constexpr auto pipeline = presets::none(radiance, Demodulate{});
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_randomly(frame, 1);
    std::array const odd{0.f, 1e-30f, 0.019f, 0.02f, 1.f, 7.f, infinity, not_a_number, -1.f};
    tests::fill(frame[albedo], [&](int x, int y) {
        return glm::vec3(odd[static_cast<std::size_t>(x + y) % odd.size()], odd[static_cast<std::size_t>(x) % odd.size()], 0.3f);
    });
    auto const out = run(pipeline, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) CHECK(out.get(c, x, y) == doctest::Approx(frame[radiance].view().get(c, x, y)).epsilon(1e-6));
}

TEST_CASE("what is no albedo leaves no bright light in the history") {
    constexpr auto pipeline = presets::surface(radiance, Demodulate{});
    for (float const bad : {-1.f, -1e30f, infinity, not_a_number}) {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        for (int i = 0; i < 6; ++i) {
            every_pixel(frame, glm::vec3(0.5f));
            if (i == 0) tests::fill(frame[albedo], [&](int, int) { return glm::vec3(bad, 1, 1); });
            CHECK(run(pipeline, frame, history).get(0, 7, 9) == doctest::Approx(0.5));
        }
    }
}

TEST_CASE("a firefly is dimmed before it enters the history") {
    constexpr auto with = Pipeline{radiance, SuppressFireflies{}, Temporal{StillMotion{}, Exponential{}}};
    Frame frame{size, with};
    History history{size, with};
    every_pixel(frame, glm::vec3(1));
    frame[radiance].set(4, 4, glm::vec3(5000));
    CHECK(run(with, frame, history).get(0, 4, 4) == doctest::Approx(2));
    CHECK(run(with, frame, history).get(0, 5, 4) == doctest::Approx(1));
}

TEST_CASE("what is taken from fireflies is summed up, of the last frame, in the host's units") {
    auto const taken = [](auto const& pipeline, float surface) {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        every_pixel(frame, glm::vec3(1));
        if constexpr (decltype(frame)::channels::template has<Albedo>)
            tests::fill(frame[albedo], [&](int, int) { return glm::vec3(surface); });
        frame[radiance].set(4, 4, glm::vec3(5000));
        frame[radiance].set(9, 9, glm::vec3(1e15f));
        frame[radiance].set(14, 9, glm::vec3(not_a_number));
        run(pipeline, frame, history);
        double const first = history.statistics().suppressed;
        frame[radiance].set(9, 9, glm::vec3(3));
        run(pipeline, frame, history);
        CHECK(history.statistics().suppressed == doctest::Approx(first > 0 ? 4998 + 1 : 0).epsilon(1e-5));
        every_pixel(frame, glm::vec3(1));
        run(pipeline, frame, history);
        CHECK(history.statistics().suppressed == 0);
        return first;
    };
    CHECK(taken(presets::none(radiance, SuppressFireflies{}), 1) == doctest::Approx(1e15 + 4996));
    CHECK(taken(presets::none(radiance, Demodulate{}, SuppressFireflies{}), 0.5f) == doctest::Approx(1e15 + 4996));
    CHECK(taken(presets::none(radiance, Demodulate{}), 0.5f) == 0);
}

TEST_CASE("that sum is what the picture lacks, and the same to the last digit for any threads and tiles") {
    constexpr auto with = presets::none(radiance, SuppressFireflies{});
    constexpr auto without = presets::none(radiance);
    Extent const large{201, 67};
    Frame frame{large, with};
    std::mt19937 random(5);
    tests::fill(frame[radiance], [&](int, int) {
        float const spread = std::exponential_distribution<float>(1.f)(random);
        return glm::vec3(1e-3f, 1.f, 0.5f) * spread * spread * spread * (random() % 100 == 0 ? 1e6f : 1e-2f);
    });
    auto const sum_of = [&](auto const& pipeline, auto const& executor, double& suppressed) {
        History history{large, pipeline};
        auto const out = run(pipeline, frame, history, executor);
        suppressed = history.statistics().suppressed;
        double sum = 0;
        for (int y = 0; y < large.height; ++y)
            for (int x = 0; x < large.width; ++x) sum += luminance(glm::vec3(out.get(0, x, y), out.get(1, x, y), out.get(2, x, y)));
        return sum;
    };
    double none = 0, once = 0;
    double const whole = sum_of(without, Simd{}, none), rest = sum_of(with, Simd{}, once);
    CHECK(none == 0);
    CHECK(rest < 0.9 * whole);
    CHECK(once == doctest::Approx(whole - rest).epsilon(1e-5));
#if defined(QUELL_TEST_THREADS)
    for (Extent const tile : {Extent{256, 32}, Extent{5, 3}, Extent{16, 1}})
        for (int const count : {1, 2, 3}) {
            double again = 0;
            sum_of(with, Threads<>{.count = count, .tile = tile}, again);
            CHECK(again == once);
        }
#endif
    double serial = 0;
    sum_of(with, Serial{}, serial);
    CHECK(serial == doctest::Approx(once).epsilon(1e-5));
}

TEST_CASE("a static scene converges like 1 / sqrt(N) to the cap, without bias") {
    auto const run_for = [](auto storage, int frames, double& mean, double& deviation) {
        constexpr auto pipeline = Pipeline{visibility, Temporal{StillMotion{}, RunningMean{.cap = 64}}};
        Frame frame{Extent{128, 64}, pipeline};
        History history{frame.size, pipeline, storage};
        std::mt19937 random(3);
        std::exponential_distribution<float> light(1.f); // skewed, as light is: mean 1, deviation 1
        std::vector<float> out;
        for (int i = 0; i < frames; ++i) {
            tests::fill(frame[visibility], [&](int, int) { return light(random); });
            out = tests::copy_of(run(pipeline, frame, history));
        }
        mean = 0, deviation = 0;
        for (float const a : out) mean += a / static_cast<double>(out.size());
        for (float const a : out) deviation += (a - 1) * (a - 1) / static_cast<double>(out.size());
        deviation = std::sqrt(deviation);
    };
    double mean, deviation;
    for (int const n : {4, 16, 64}) {
        run_for(Planar<>{}, n, mean, deviation);
        CHECK(deviation == doctest::Approx(1 / std::sqrt(n)).epsilon(0.05));
        CHECK(mean == doctest::Approx(1).epsilon(5 / std::sqrt(128 * 64 * n)));
        run_for(Planar<Float16>{}, n, mean, deviation);
        CHECK(deviation == doctest::Approx(1 / std::sqrt(n)).epsilon(0.05));
        CHECK(mean == doctest::Approx(1).epsilon(5 / std::sqrt(128 * 64 * n)));
    }
    // An exponential of 1 / 64 settles at a deviation of sqrt(a / (2 - a)).
    run_for(Planar<>{}, 600, mean, deviation);
    CHECK(deviation == doctest::Approx(std::sqrt(1. / 127)).epsilon(0.05));
}

TEST_CASE_TEMPLATE("10,000 static frames drift by nothing", Storage, Planar<>, Planar<Float16>) {
    Extent const tile{32, 16};
    Frame frame{tile, svgf};
    History history{tile, svgf, Storage{}};
    tests::fill_still(frame);
    std::mt19937 random(8);
    std::uniform_real_distribution<float> noise(0.45f, 0.55f);
    auto const mean_of = [&] {
        auto const out = tests::copy_of(run(svgf, frame, history));
        double sum = 0;
        for (float const a : out) sum += a;
        return sum / static_cast<double>(out.size());
    };
    double early = 0, late = 0;
    for (int i = 0; i < 10000; ++i) {
        tests::fill(frame[radiance], [&](int, int) { return glm::vec3(noise(random)); });
        double const mean = mean_of();
        if (i >= 100 && i < 600) early += mean / 500;
        if (i >= 9500) late += mean / 500;
    }
    // Both are means of 500 * 512 samples of deviation 0.029: 1e-4 is seven times their deviation.
    CHECK(early == doctest::Approx(0.5).epsilon(2e-4));
    CHECK(late == doctest::Approx(0.5).epsilon(2e-4));
    CHECK(std::abs(late - early) < 1e-4);
}

TEST_CASE("a host can have the output in an image of its own") {
    Frame frame{size, svgf};
    History history{size, svgf}, other{size, svgf};
    tests::fill_randomly(frame, 6);
    Interleaved<>::Image<3> target{size};
    run_into(target.view(), svgf, frame, history);
    CHECK(tests::copy_of(run(svgf, frame, other)) == tests::copy_of(target.view()));
}

TEST_CASE("what can't be used is refused by name") {
    CHECK(tests::message([] { Frame frame{Extent{0, 4}, surface}; }).find("frame size: 0x4") == 0);
    CHECK(tests::message([] { History history{Extent{4, -1}, surface}; }).find("history size: 4x-1") == 0);
    Frame frame{size, surface};
    History history{size, surface};
    every_pixel(frame, glm::vec3(1));
    frame[depth] = std::remove_reference_t<decltype(frame[depth])>(Extent{3, 3});
    CHECK(tests::message([&] { run(surface, frame, history); }) ==
          "channel 'depth': 3x3 in a frame of 40x25; give every channel the frame's size");
    Frame borrowed{size, surface, Borrowed<>{}};
    CHECK(tests::message([&] { run(surface, borrowed, history); }).find("channel 'radiance': no memory") == 0);
    constexpr auto by_position = Pipeline{radiance, Temporal{PositionMotion{}, Exponential{}}};
    Frame posed{size, by_position};
    History its_history{size, by_position};
    posed.camera.projection = glm::mat4(0.f);
    CHECK(tests::message([&] { run(by_position, posed, its_history); }).find("camera.projection: a singular") == 0);
    posed.camera = Camera{};
    CHECK(tests::message([&] { run(by_position, posed, its_history); }).find("camera.projection: a matrix without perspective") == 0);
    posed.camera.view[1][2] = not_a_number;
    CHECK(tests::message([&] { run(by_position, posed, its_history); }).find("camera.view") == 0);
}

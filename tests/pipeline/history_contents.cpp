#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/history_contents.hpp>

using namespace quell;

namespace {
constexpr Extent size{40, 25};

/// The same random colours for any signal of colours; alpha depends on the colour's red.
template <class F> void fill_colours(F& frame, auto signal, unsigned seed) {
    std::mt19937 random(1000 + seed);
    std::exponential_distribution<float> light(1.f);
    for_each_channel(Channels<Albedo, Normal, Depth, Motion>{},
                     [&](auto c) { tests::fill(frame[c], [&](int x, int y) { return tests::RandomValue{random}.of(c, x, y); }); });
    tests::fill(frame[signal], [&](int, int) {
        glm::vec3 const colour(light(random), light(random), light(random));
        if constexpr (decltype(signal)::components == 4)
            return glm::vec4(colour, colour.r > 1.f ? 1.f : 0.f);
        else
            return colour;
    });
}
} // namespace

TEST_CASE_TEMPLATE("a fresh history that is given another's contents goes on as that one does", Storage, Planar<>, Planar<Float16>) {
    constexpr auto denoise = presets::svgf(radiance, Demodulate{});
    Frame frame{size, denoise};
    History<std::remove_const_t<decltype(denoise)>, Storage> history{size, denoise}, fresh{size, denoise};
    CHECK_FALSE(contents_of(history));
    for (unsigned i = 0; i < 3; ++i) {
        frame.number = i;
        tests::fill_randomly(frame, i);
        run(denoise, frame, history, Serial{});
    }
    auto const contents = contents_of(history);
    REQUIRE(contents);
    CHECK(contents->number == 2);
    put_contents(fresh, *contents);
    for (unsigned i = 3; i < 5; ++i) {
        frame.number = i;
        tests::fill_randomly(frame, i);
        CHECK(tests::copy_of(run(denoise, frame, history, Serial{})) == tests::copy_of(run(denoise, frame, fresh, Serial{})));
    }
    CHECK(fresh.statistics().frames == 2);
    auto lacking = *contents;
    lacking.kept.erase("history_length");
    CHECK(tests::message([&] { put_contents(fresh, lacking); }) ==
          "history contents: they lack history_length; take them of a like pipeline, after a run() of all its stages");
}

TEST_CASE("alpha goes through a pipeline beside the colour, and changes no bit of it") {
    constexpr auto with_alpha = presets::general(radiance_alpha, Demodulate{});
    constexpr auto without = presets::general(radiance, Demodulate{});
    Frame four{size, with_alpha};
    Frame three{size, without};
    History of_four{size, with_alpha};
    History of_three{size, without};
    for (unsigned i = 0; i < 4; ++i) {
        fill_colours(four, radiance_alpha, i), fill_colours(three, radiance, i);
        auto const a = run(with_alpha, four, of_four, Serial{});
        auto const b = run(without, three, of_three, Serial{});
        int different = 0;
        float least = 1.f, most = 0.f;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                for (int c = 0; c < 3; ++c) different += a.get(c, x, y) != b.get(c, x, y);
                least = std::min(least, a.get(3, x, y)), most = std::max(most, a.get(3, x, y));
            }
        CHECK(different == 0);
        CHECK(least >= 0.f);
        CHECK(most <= 1.0001f);
    }
    // Histories of colours are those of opaque pictures.
    History opaque{size, with_alpha};
    put_contents(opaque, *contents_of(of_three));
    fill_colours(four, radiance_alpha, 5), fill_colours(three, radiance, 5);
    tests::fill(four[radiance_alpha], [&](int x, int y) { return glm::vec4(three[radiance].get(x, y), 1.f); });
    auto const a = run(with_alpha, four, opaque, Serial{});
    auto const b = run(without, three, of_three, Serial{});
    int different = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < 3; ++c) different += a.get(c, x, y) != b.get(c, x, y);
            CHECK(a.get(3, x, y) == doctest::Approx(1.f));
        }
    CHECK(different == 0);
}

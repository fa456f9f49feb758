#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{40, 25};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);
constexpr glm::vec3 out_of_gamut{0.9f, -0.08f, 0.3f};

/// Memory that holds a half of each component.
glm::vec3 in_half(glm::vec3 v) {
    for (int c = 0; c < 3; ++c) v[c] = float_from_half(half_from_float(v[c]));
    return v;
}

/// A frame of even guides and one light.
template <class F> void fill_evenly(F& frame, glm::vec3 light) {
    tests::fill_still(frame);
    tests::fill(frame[radiance], [&](int, int) { return light; });
}
} // namespace

TEST_CASE("light has no mark, and keeps its bits; of a missing sample the value comes back, signs too") {
    using Exact = detail::MissingMark<true>;
    using Coarse = detail::MissingMark<false>;
    for (glm::vec3 const v :
         {glm::vec3(0.f), out_of_gamut, glm::vec3(-1e-3f, 2.f, -0.f), glm::vec3(1e4f, 0.7f, -60.f), glm::vec3(2e-5f, 3e-5f, -4e-6f)}) {
        CHECK(Exact::marked(v, false) == v);
        CHECK(Coarse::marked(v, false) == v);
        CHECK_FALSE(Exact::of(Exact::marked(v, false)));
        auto const exact = Exact::marked(v, true), coarse = in_half(Coarse::marked(v, true));
        CHECK(Exact::of(exact));
        CHECK(Coarse::of(coarse));
        CHECK_FALSE(Exact::hole(exact));
        CHECK_FALSE(Coarse::hole(coarse));
        for (int c = 0; c < 3; ++c) {
            CHECK(Exact::value(exact)[c] == doctest::Approx(v[c]).epsilon(3e-7));
            CHECK(std::abs(Coarse::value(coarse)[c] - v[c]) <= std::max(std::abs(v[c]) * 1e-3f, 6.1e-8f));
        }
    }
    CHECK(Exact::hole(Exact::marked(Exact::no_value<glm::vec3>(), true)));
    CHECK(Coarse::hole(in_half(Coarse::marked(Coarse::no_value<glm::vec3>(), true))));
    CHECK(Coarse::value(in_half(Coarse::marked(Coarse::no_value<glm::vec3>(), true))) == glm::vec3(0));
    CHECK_FALSE(Coarse::hole(in_half(Coarse::marked(glm::vec3(1e9f), true))));
    // Of one component, all of the number is the value's.
    CHECK(Exact::value(Exact::marked(0.123456789f, true)) == 0.123456789f);
    CHECK_FALSE(Exact::of(Exact::marked(-0.f, false)));
}

TEST_CASE("a missing sample is filled from what is around it, far away too and in any colour, and spreads nowhere") {
    constexpr auto general = presets::general(radiance, Demodulate{});
    for (glm::vec3 const light : {glm::vec3(0.5f), out_of_gamut}) {
        Frame frame{size, general};
        History history{size, general};
        fill_evenly(frame, light);
        for (int y = 2; y < 23; ++y)
            for (int x = 3; x < 38; ++x) frame[radiance].set(x, y, glm::vec3(not_a_number));
        for (int i = 0; i < 2; ++i) {
            auto const out = run(general, frame, history);
            CHECK(history.statistics().missing_samples == 21 * 35);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    for (int c = 0; c < 3; ++c) REQUIRE(out.get(c, x, y) == doctest::Approx(light[c]).epsilon(1e-5));
        }
    }
}

TEST_CASE("a frame without a usable sample is black, leaves no history, and takes none away") {
    constexpr auto surface = presets::surface(radiance);
    Frame frame{size, surface};
    History history{size, surface};
    fill_evenly(frame, glm::vec3(not_a_number));
    CHECK(run(surface, frame, history).get(0, 3, 4) == 0.f);
    fill_evenly(frame, out_of_gamut);
    CHECK(run(surface, frame, history).get(1, 3, 4) == out_of_gamut.y);
    fill_evenly(frame, glm::vec3(not_a_number));
    // What has no history of its own shows what its pixel showed.
    tests::fill(frame[depth], [](int x, int) { return x < 20 ? 4.f : 9.f; });
    auto const out = run(surface, frame, history);
    CHECK(out.get(1, 3, 4) == out_of_gamut.y);
    CHECK(out.get(1, 30, 4) == doctest::Approx(out_of_gamut.y).epsilon(1e-6));
}

namespace {
/// The mean of each component of the last frames, of samples that are a colour times a random number of mean 1.
template <class P> glm::dvec3 mean_of_noisy(P const& pipeline, glm::vec3 colour) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::mt19937 random(3);
    glm::dvec3 out_sum(0), in_sum(0);
    for (int i = 0; i < 24; ++i) {
        fill_evenly(frame, colour);
        tests::fill(frame[radiance], [&](int, int) { return colour * std::uniform_real_distribution<float>(0.2f, 1.8f)(random); });
        auto const out = run(pipeline, frame, history);
        CHECK(history.statistics().missing_samples == 0);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (int c = 0; c < 3; ++c) out_sum[c] += out.get(c, x, y), in_sum[c] += frame[radiance].get(x, y)[c];
    }
    return out_sum / in_sum;
}
} // namespace

TEST_CASE("light out of the gamut keeps its mean in each component") {
    auto const check = [](auto const& pipeline) {
        for (glm::vec3 const colour : {out_of_gamut, glm::vec3(-0.3f, 0.9f, -0.2f), glm::vec3(0.95f, 0.99f, -1.2f)}) {
            auto const kept = mean_of_noisy(pipeline, colour);
            for (int c = 0; c < 3; ++c) CHECK(kept[c] == doctest::Approx(1).epsilon(0.01));
        }
    };
    check(presets::general(radiance, Demodulate{}));
    check(presets::final_frame(radiance, Demodulate{}));
    check(presets::svgf(radiance, Demodulate{}));
}

#include "../frames.hpp"

#include <glm/ext/vector_float1.hpp>

using namespace quell;

namespace {
constexpr Extent size{40, 25};
float const not_a_number = std::bit_cast<float>(0x7fc00000u), infinite = std::bit_cast<float>(0x7f800000u);
constexpr auto general = presets::general(radiance, Demodulate{});
constexpr auto atrous = presets::atrous(radiance, Demodulate{});

/// What a pipeline makes of the last of some random frames whose guides `change` has changed, and what it has counted then.
struct Seen {
    std::vector<float> out;
    RepairedGuides repaired;
};
template <class P> Seen seen_with(P const& pipeline, auto&& change) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    Seen seen;
    for (unsigned i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, i);
        change(frame);
        seen = {tests::copy_of(run(pipeline, frame, history)), history.statistics().repaired_guides};
    }
    return seen;
}
/// Changes each pixel of a channel.
template <class F, ChannelTag C> void each(F& frame, C channel, auto&& f) {
    tests::fill(frame[channel], [&](int x, int y) { return f(Value<C::components, float>(frame[channel].get(x, y))); });
}
void nothing(auto&) {}
} // namespace

TEST_CASE("normals of any length mean the same, and are counted unless they are of length 1") {
    auto const pixels = size.pixels();
    auto const usual = seen_with(general, [](auto& frame) { nothing(frame); });
    CHECK(usual.repaired.pixels == 0);
    for (float const length : {1e-20f, 0.3f, 0.99f, 1.2f, 1.5f, 2.f, 1e30f}) {
        CAPTURE(length);
        auto const seen = seen_with(general, [&](auto& frame) { each(frame, normal, [&](glm::vec3 n) { return n * length; }); });
        CHECK(tests::difference(usual.out, seen.out) < 1e-4);
        CHECK(seen.repaired.of(normal) == pixels);
        CHECK(seen.repaired.pixels == pixels);
        seen.repaired.for_each([](auto guide, auto, long long count) { CHECK((count == 0) != std::is_same_v<decltype(guide), Normal>); });
    }
    // What half makes of a normal is one of length 1.
    auto const half = seen_with(general, [](auto& frame) {
        each(frame, normal, [](glm::vec3 n) {
            for (int c = 0; c < 3; ++c) n[c] = float_from_half(half_from_float(n[c]));
            return n;
        });
    });
    CHECK(half.repaired.pixels == 0);
}

TEST_CASE("a normal that is not finite is none, where nothing is seen none is needed, and 0 is none") {
    auto const none = seen_with(atrous, [](auto& frame) { frame[normal].set(5, 6, glm::vec3(0)); });
    CHECK(none.repaired.pixels == 0);
    for (float const bad : {not_a_number, infinite, -infinite}) {
        auto const seen = seen_with(atrous, [&](auto& frame) { frame[normal].set(5, 6, {0, bad, 1}); });
        CHECK(seen.out == none.out);
        CHECK(seen.repaired.of(normal) == 1);
    }
    auto const sky = seen_with(atrous, [&](auto& frame) {
        frame[depth].set(5, 6, infinite);
        frame[normal].set(5, 6, {0, not_a_number, 7});
    });
    CHECK(sky.repaired.pixels == 0);
}

TEST_CASE("a depth that is none is a miss, and is counted") {
    auto const miss = seen_with(general, [](auto& frame) { frame[depth].set(5, 6, infinite); });
    CHECK(miss.repaired.pixels == 0);
    for (float const bad : {not_a_number, -infinite, 0.f, -0.f, -3.f}) {
        auto const seen = seen_with(general, [&](auto& frame) { frame[depth].set(5, 6, bad); });
        CHECK(seen.out == miss.out);
        CHECK(seen.repaired.of(depth) == 1);
        CHECK(seen.repaired.pixels == 1);
    }
}

TEST_CASE("albedo above 1 is 1, and what is negative or not finite is black") {
    auto const with = [](glm::vec3 a) { return seen_with(atrous, [&](auto& frame) { frame[albedo].set(5, 6, a); }); };
    auto const one = with({1, 0.5f, 1}), black = with({0, 0, 0});
    CHECK(one.repaired.pixels + black.repaired.pixels == 0);
    for (float const bad : {1.1f, 7.f, 1e30f}) {
        auto const seen = with({bad, 0.5f, bad});
        CHECK(seen.out == one.out);
        CHECK(seen.repaired.of(albedo) == 1);
    }
    for (float const bad : {-0.1f, -1e30f, infinite, not_a_number}) {
        auto const seen = with({0.5f, bad, 0.5f});
        CHECK(seen.out == black.out);
        CHECK(seen.repaired.of(albedo) == 1);
    }
}

TEST_CASE("motion that is not finite leads nowhere, and is counted") {
    auto const away = seen_with(general, [](auto& frame) { frame[motion].set(5, 6, {1e4f, 0}); });
    auto const seen = seen_with(general, [](auto& frame) {
        frame[motion].set(5, 6, {0, not_a_number});
        frame[albedo].set(7, 7, {2, 1, 1});
    });
    auto const same_albedo = seen_with(general, [](auto& frame) {
        frame[motion].set(5, 6, {1e4f, 0});
        frame[albedo].set(7, 7, {1, 1, 1});
    });
    CHECK(away.repaired.pixels == 0);
    CHECK(seen.out == same_albedo.out);
    CHECK(seen.repaired.of(motion) == 1);
    CHECK(seen.repaired.of(albedo) == 1);
    CHECK(seen.repaired.pixels == 2);
}

TEST_CASE("counts add up over frames, and of a composite's pipelines the one that reads most guides has them") {
    constexpr auto both = Composite{presets::surface(visibility), presets::atrous(indirect)};
    auto const seen = seen_with(both, [](auto& frame) {
        frame[motion].set(5, 6, {0, not_a_number}), frame[albedo].set(7, 7, {2, 1, 1}), frame[depth].set(9, 9, -1.f);
    });
    // Only the first follows motion. The albedo is a factor of the second, which no pipeline reads.
    CHECK(seen.repaired.of(motion) == 1);
    CHECK(seen.repaired.of(depth) == 1);
    CHECK(seen.repaired.pixels == 2);
    auto sum = seen.repaired;
    sum += seen.repaired;
    sum.for_each(
        [&](auto guide, std::string_view what, long long count) { CHECK((!what.empty() && count == 2 * seen.repaired.of(guide))); });
    CHECK(sum.pixels == 4);
}

namespace {
/// Reads a host's memory, in an order of its own, and knows no storage for copies.
struct Lent {
    using Exact = Lent;
    static constexpr bool owns_memory = false;
    template <int N> struct Image {
        std::vector<glm::vec<N, float>> const* all = nullptr;
        Extent extent;
        Image() = default;
        explicit Image(Extent s) : extent(s) {}
        Extent size() const { return extent; }
        std::size_t bytes() const { return 0; }
        struct View {
            static constexpr int components = N;
            std::vector<glm::vec<N, float>> const* all;
            Extent size;
            float get(int c, int x, int y) const { return (*all)[static_cast<std::size_t>(y * size.width + x)][c]; }
            void set(int, int, int, float) const {}
        };
        View view() const { return {all, extent}; }
    };
};

/// The still frame's images in a host's memory.
template <int N> std::vector<glm::vec<N, float>> filled(glm::vec<N, float> value) {
    return std::vector<glm::vec<N, float>>(static_cast<std::size_t>(size.pixels()), value);
}
template <class Lend> RepairedGuides repaired_of_lent(auto const& storage, Lend&& lend, std::vector<float>& out) {
    Frame frame{size, atrous, storage};
    History history{size, atrous};
    lend(frame);
    out = tests::copy_of(run(atrous, frame, history));
    return history.statistics().repaired_guides;
}
} // namespace

TEST_CASE("guides in the host's own memory are repaired too, and left as they are there") {
    auto light = filled<3>({0.5f, 0.25f, 1.f});
    for (std::size_t i = 0; i < light.size(); i += 3) light[i] *= 4.f;
    auto const colour = filled<3>({0.5f, 0.5f, 0.5f});
    auto const z = filled<1>(glm::vec<1, float>(4.f));
    auto const unit = filled<3>({0, 0, 1});
    auto longer = filled<3>({0, 0, 1.5f});
    auto const run_with = [&](std::vector<glm::vec3> const& normals, auto const& storage, std::vector<float>& out) {
        return repaired_of_lent(
            storage,
            [&](auto& frame) {
                frame[radiance] = {&light[0].x, size, 3, 3 * size.width};
                frame[albedo] = {&colour[0].x, size, 3, 3 * size.width};
                frame[depth] = {&z[0].x, size, 1, size.width};
                frame[normal] = {&normals[0].x, size, 3, 3 * size.width};
            },
            out);
    };
    std::vector<float> usual, repaired;
    CHECK(run_with(unit, Borrowed<>{}, usual).pixels == 0);
    CHECK(run_with(longer, Borrowed<>{}, repaired).of(normal) == size.pixels());
    CHECK(repaired == usual);
    CHECK(longer == filled<3>({0, 0, 1.5f}));
}

TEST_CASE("a storage that lends memory and knows none for copies has impossible guides counted") {
    auto const light = filled<3>({0.5f, 0.25f, 1.f}), colour = filled<3>({2.f, 0.5f, 0.5f}), up = filled<3>({0, 0, 1});
    auto const z = filled<1>(glm::vec<1, float>(4.f));
    std::vector<float> out;
    auto const counted = repaired_of_lent(
        Lent{},
        [&](auto& frame) { frame[radiance].all = &light, frame[albedo].all = &colour, frame[depth].all = &z, frame[normal].all = &up; },
        out);
    CHECK(counted.of(albedo) == size.pixels());
    for (std::size_t i = 0; i < out.size(); ++i) REQUIRE(out[i] == doctest::Approx(light[0][static_cast<int>(i % 3)]));
}

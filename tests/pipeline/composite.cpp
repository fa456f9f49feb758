#include "../frames.hpp"

#include <quell/image/interleaved.hpp>

using namespace quell;

namespace {
constexpr Extent size{37, 11};
constexpr auto shadows = presets::none(visibility);
constexpr auto reflections = presets::none(glossy);
constexpr auto bounced = presets::none(indirect);
float const not_a_number = std::bit_cast<float>(0x7fc00000u), infinite = std::bit_cast<float>(0x7f800000u);

template <class C, class F> std::vector<float> once(C const& composite, F const& frame) {
    History history{size, composite};
    return tests::copy_of(run(composite, frame, history));
}
/// The picture worked out by f(x, y).
std::vector<float> by_hand(auto&& f) {
    std::vector<float> all;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::vec3 const a = f(x, y);
            all.insert(all.end(), {a.x, a.y, a.z});
        }
    return all;
}
} // namespace

TEST_CASE("a composite is direct * visibility + glossy + albedo * indirect") {
    constexpr auto all = Composite{shadows, reflections, bounced};
    Frame frame{size, all};
    tests::fill_randomly(frame, 5);
    auto const wanted = by_hand([&](int x, int y) {
        return frame[direct].get(x, y) * frame[visibility].get(x, y) + frame[glossy].get(x, y) +
               frame[albedo].get(x, y) * frame[indirect].get(x, y);
    });
    CHECK(tests::difference(wanted, once(all, frame)) < 1e-6);
    // The order makes no difference.
    CHECK(tests::difference(wanted, once(Composite{bounced, shadows, reflections}, frame)) < 1e-6);
}

TEST_CASE("any subset is a picture of its own and asks for no other channel") {
    constexpr auto lit = Composite{shadows};
    using Lit = decltype(lit)::reads;
    static_assert(Lit::has<Direct> && Lit::has<Visibility> && Lit::size == 2);
    using Shiny = decltype(Composite{reflections})::reads;
    static_assert(Shiny::has<Glossy> && Shiny::size == 1);
    using Bounced = decltype(Composite{bounced})::reads;
    static_assert(Bounced::has<Albedo> && Bounced::has<Indirect> && Bounced::size == 2);

    constexpr auto two = Composite{shadows, bounced};
    Frame frame{size, two, lit};
    tests::fill_randomly(frame, 6);
    auto const from_light = [&](int x, int y) { return frame[direct].get(x, y) * frame[visibility].get(x, y); };
    CHECK(tests::difference(by_hand(from_light), once(lit, frame)) < 1e-6);
    CHECK(tests::difference(by_hand([&](int x, int y) { return from_light(x, y) + frame[albedo].get(x, y) * frame[indirect].get(x, y); }),
                            once(two, frame)) < 1e-6);
}

TEST_CASE("a signal that is no light of its own kind is added as it is") {
    constexpr auto all = Composite{presets::none(radiance), reflections};
    Frame frame{size, all};
    tests::fill_randomly(frame, 7);
    CHECK(tests::difference(by_hand([&](int x, int y) { return frame[radiance].get(x, y) + frame[glossy].get(x, y); }), once(all, frame)) <
          1e-6);
}

TEST_CASE("direct light and albedo that are not finite, negative or beyond 1e16 add nothing; an albedo above 1 counts as 1") {
    constexpr auto all = Composite{shadows, reflections, bounced};
    for (float const a : {not_a_number, infinite, -infinite, 3e38f, -1.f}) {
        Frame frame{size, all};
        tests::fill_randomly(frame, 8);
        auto const before = once(all, frame);
        frame[direct].set(3, 4, {1, a, 1});
        frame[albedo].set(20, 9, {a, 0.5f, 0.5f});
        auto const after = once(all, frame);
        CHECK(tests::all_finite(after));
        auto const at = [](int x, int y) { return static_cast<std::size_t>((y * size.width + x) * 3); };
        auto const lit = frame[glossy].get(3, 4) + frame[albedo].get(3, 4) * frame[indirect].get(3, 4);
        bool const above_one = a > 1 && is_finite(a);
        auto const bounced = above_one ? glm::vec3(1, 0.5f, 0.5f) * frame[indirect].get(20, 9) : glm::vec3(0);
        auto const there = frame[glossy].get(20, 9) + frame[direct].get(20, 9) * frame[visibility].get(20, 9) + bounced;
        CHECK(after[at(3, 4)] == doctest::Approx(lit.x));
        CHECK(after[at(3, 4) + 1] == doctest::Approx(lit.y));
        CHECK(after[at(20, 9)] == doctest::Approx(there.x));
        CHECK(after[at(20, 9) + 2] == doctest::Approx(there.z));
        for (std::size_t i = 0; i < after.size(); ++i)
            if (i / 3 * 3 != at(3, 4) && i / 3 * 3 != at(20, 9)) REQUIRE(after[i] == before[i]);
    }
}

TEST_CASE("a composite takes no more memory than its pipelines and one picture; missing samples and what fireflies lost add up") {
    constexpr auto a = presets::surface(visibility, SuppressFireflies{});
    constexpr auto b = presets::none(glossy, SuppressFireflies{});
    constexpr auto both = Composite{a, b};
    Frame frame{size, both};
    tests::fill_randomly(frame, 9);
    frame[visibility].set(8, 5, 100.f), frame[glossy].set(9, 5, glm::vec3(100));
    frame[visibility].set(1, 1, not_a_number), frame[glossy].set(2, 2, glm::vec3(not_a_number)), frame[glossy].set(5, 2, glm::vec3(-1));
    History history{size, both};
    History alone{size, a};
    History other{size, b};
    for (int i = 0; i < 3; ++i) run(both, frame, history), run(a, frame, alone), run(b, frame, other);
    // Scratch of the one serves the other.
    auto const picture = ImageOf<Planar<>, Radiance>(size).bytes();
    CHECK(history.bytes() > std::max(alone.bytes(), other.bytes()) + picture);
    CHECK(history.bytes() <= alone.bytes() + other.bytes() + picture);
    CHECK(history.statistics().missing_samples == 3);
    CHECK(alone.statistics().suppressed > 0);
    CHECK(other.statistics().suppressed > 0);
    CHECK(history.statistics().suppressed == alone.statistics().suppressed + other.statistics().suppressed);
    CHECK(history.statistics().frames == 3);
    history.forget();
    run(both, frame, history);
    CHECK(history.statistics().frames == 1);
}

TEST_CASE("a composite follows a frame of another size") {
    constexpr auto all = Composite{shadows, reflections};
    History history{size, all};
    Frame frame{Extent{8, 5}, all};
    tests::fill_randomly(frame, 10);
    auto const out = run(all, frame, history);
    CHECK(out.size == Extent{8, 5});
    CHECK(out.get(0, 7, 4) == doctest::Approx((frame[direct].get(7, 4) * frame[visibility].get(7, 4) + frame[glossy].get(7, 4)).x));
}

TEST_CASE("a factor that has a pipeline of its own is denoised too, and added to nothing") {
    constexpr auto light = presets::surface(direct);
    constexpr auto all = Composite{light, shadows, bounced};
    using All = decltype(all)::reads;
    static_assert(All::has<Direct> && All::has<Albedo> && All::has<Visibility> && All::has<Indirect>);
    Frame frame{size, all};
    History history{size, all};
    History alone{size, light};
    for (int i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, static_cast<unsigned>(20 + i));
        auto const out = tests::copy_of(run(all, frame, history));
        auto const lit = run(light, frame, alone);
        auto const wanted = by_hand([&](int x, int y) {
            return glm::vec3(lit.get(0, x, y), lit.get(1, x, y), lit.get(2, x, y)) * frame[visibility].get(x, y) +
                   frame[albedo].get(x, y) * frame[indirect].get(x, y);
        });
        CHECK(tests::difference(wanted, out) < 1e-6);
    }
}

TEST_CASE("run_into writes a composite's picture into the host's image, whatever size the history had") {
    constexpr auto all = Composite{shadows, reflections, bounced};
    Frame frame{size, all};
    tests::fill_randomly(frame, 5);
    Interleaved<>::Image<3> target(size);
    History history{Extent{4, 4}, all};
    run_into(target.view(), all, frame, history);
    CHECK(tests::copy_of(target.view()) == once(all, frame));
    Interleaved<>::Image<3> small({8, 8});
    CHECK(tests::message([&] { run_into(small.view(), all, frame, history); }) ==
          "run_into: the target: 8x8 for a frame of 37x11; give it the frame's size");
}

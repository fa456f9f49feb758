#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{32, 12};
/// All of the past, but for a millionth.
constexpr auto past_only = Pipeline{visibility, Temporal{SurfaceMotion<SameDepth>{}, Exponential{.alpha = 1e-6f}, Nearest{}}};
} // namespace

TEST_CASE("the nearest fetch takes one pixel as it is, where it shows the same surface") {
    Frame frame{size, past_only};
    History history{size, past_only};
    tests::fill_still(frame);
    tests::fill(frame[depth], [](int x, int) { return x < 8 ? 30.f : 3.f; });
    tests::fill(frame[visibility], [](int x, int y) { return x % 3 == 0 && y % 2 == 0 ? 1.f : 0.25f; });
    run(past_only, frame, history);
    tests::fill(frame[motion], [](int, int) { return glm::vec2(-4.4f, 0.3f); });
    tests::fill(frame[visibility], [](int, int) { return 0.5f; });
    auto const out = run(past_only, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 12; x < size.width; ++x) {
            float const seen = (x - 4) % 3 == 0 && y % 2 == 0 ? 1.f : 0.25f;
            REQUIRE(out.get(0, x, y) == doctest::Approx(seen).epsilon(1e-4));
        }
    // These came from another surface.
    for (int x = 8; x < 12; ++x) REQUIRE(out.get(0, x, 5) == doctest::Approx(0.5));
}

TEST_CASE("Catmull-Rom is sharper than bilinear along an outline too, and takes nothing from beyond it") {
    // A wave on the right of an outline at column 10, which all moves by -2.5 pixels; what is left of it is bright, and nearer.
    auto const wave = [](float x) { return 0.5f + 0.4f * std::sin(1.3f * x); };
    auto const error_with = [&]<class Fetch>(Fetch fetch) {
        auto const past = Pipeline{visibility, Temporal{SurfaceMotion<SameDepth>{}, Exponential{.alpha = 1e-6f}, fetch}};
        Frame frame{size, past};
        History history{size, past};
        tests::fill_still(frame);
        tests::fill(frame[depth], [](int x, int) { return x < 10 ? 3.f : 30.f; });
        tests::fill(frame[visibility], [&](int x, int) { return x < 10 ? 5.f : wave(static_cast<float>(x)); });
        run(past, frame, history);
        tests::fill(frame[motion], [](int, int) { return glm::vec2(2.5f, 0.f); });
        tests::fill(frame[depth], [](int x, int) { return x < 8 ? 3.f : 30.f; });
        auto const out = run(past, frame, history);
        double squared = 0;
        for (int x = 8; x < 12; ++x) {
            float const seen = out.get(0, x, 5);
            REQUIRE(seen < 1.2f);
            squared += std::pow(seen - wave(static_cast<float>(x) + 2.5f), 2);
        }
        return squared;
    };
    CHECK(error_with(CatmullRom{}) < 0.3 * error_with(Bilinear{}));
}

namespace {
/// Finds no past for anything on the left half of the image.
struct RightHalfOnly {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const p = px.position();
        return Reprojection<Real>{p, masked(p.x > Real(16.f), Real(1.f))};
    }
};
/// Shows how often it has been asked, by what it kept.
struct Counting {
    using keeps = Channels<HistoryLength>;
    QUELL_KERNEL auto blend(auto const& px, auto const& past) const {
        auto const n = past[history_length] + 1.f;
        return Result{px.signal() * 0.f + n, n}.with(history_length, n);
    }
};
} // namespace

TEST_CASE_TEMPLATE("a blend policy is handed zeros where there is no past", Fetch, Bilinear, Nearest, CatmullRom) {
    constexpr auto counted = Pipeline{visibility, Temporal{RightHalfOnly{}, Counting{}, Fetch{}}};
    Frame frame{size, counted};
    History history{size, counted};
    tests::fill(frame[visibility], [](int, int) { return 0.5f; });
    for (int i = 0; i < 2; ++i) run(counted, frame, history);
    auto const out = run(counted, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) REQUIRE(out.get(0, x, y) == (x < 16 ? 1.f : 3.f));
}

// A past pixel refers to its place, which must not be gone by then.
template <class Place>
concept LedTo = requires(detail::Probe<Nearest> const px, Place place) {
    px.past(static_cast<Place&&>(place));
};
static_assert(LedTo<PixelCoordinates<float> const&> && !LedTo<PixelCoordinates<float>>);

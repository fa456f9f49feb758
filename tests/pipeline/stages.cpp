#include "../frames.hpp"
#include "../threads.hpp"
#include "../views.hpp"

using namespace quell;

namespace {
constexpr Extent size{40, 24};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);

/// What the previous frame was a row above.
struct DepthBefore {
    using reads = Channels<Depth>;
    using remembers = Channels<Depth>;
    QUELL_KERNEL auto filter(auto px) const {
        using Px = decltype(px);
        using Real = typename Px::Real;
        if (!px.has_past()) return px.signal();
        auto const p = px.position();
        PixelCoordinates<Real> const above(floor(p.x), floor(p.y) - 1.f);
        Real const then = px.past(above)[depth];
        return typename Px::Signal{then, then, then};
    }
};
constexpr Temporal only_now{StillMotion{}, Exponential{.alpha = 1.f}};

/// Finds nothing.
struct Nowhere {
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{vec2<Real>{Real(-1e6f), Real(0.f)}, Real(1.f)};
    }
};
/// Its numbers are named like members of FirstValid and SurfaceMotion.
struct OddlyNamed : StillMotion {
    float first = 1.f, rest = 2.f, test = 3.f;
};
/// Makes a channel of its own, and does not say that it leaves the signal alone.
struct Emitting {
    using emits = Channels<Variance>;
    QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(variance, luminance(px.signal())); }
};
struct EmittingTwice {
    using parts = Parts<Emitting>;
    constexpr void for_each_pass(auto&& pass) const { pass(Emitting{}), pass(Emitting{}); }
};
/// Can be called like one of quell's own passes.
struct Callable {
    QUELL_KERNEL auto operator()(auto px) const { return scale(px.signal(), typename decltype(px)::Real(100.f)); }
    QUELL_KERNEL auto filter(auto px) const { return px.signal(); }
};
/// Trusts what is rough little.
struct Reluctant {
    using reads = Channels<Roughness>;
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{px.position(), select(px[roughness] > Real(0.5f), Real(0.1f), Real(1.f))};
    }
};
struct WantsCamera {
    using reads = Channels<Depth>;
    using remembers = Channels<Depth>;
    static constexpr bool needs_camera = true;
    struct All {
        QUELL_KERNEL auto accepts(auto const&, auto dx, auto) const { return dx == dx; }
    };
    QUELL_KERNEL auto around(auto) const { return All{}; }
};
struct FetchThatWantsCamera : Bilinear {
    static constexpr bool needs_camera = true;
};

/// What the centre of a grey wall shows from frame to frame, of which a square of 13 x 13 pixels in one frame is no number.
template <class P> std::vector<float> centre_after_a_burst(P const& denoise, int burst, int frames) {
    Extent const square{48, 48};
    auto const camera = tests::View({0, 0, 5}, {0, 0, 0}, square).camera();
    PixelRays const rays(camera, square);
    Frame frame{square, denoise};
    History history{square, denoise};
    std::vector<float> centre;
    for (int i = 0; i < frames; ++i) {
        tests::fill_still(frame);
        frame.camera = camera;
        for_each_channel(typename decltype(frame)::channels{}, [&]<class C>(C c) {
            tests::fill(frame[c], [&](int x, int y) {
                auto const seen = rays.position(glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), 5.f);
                bool const bad = i == burst && x > 17 && x < 31 && y > 17 && y < 31;
                if constexpr (std::is_same_v<C, typename P::Output>)
                    return Value<C::components, float>(bad ? not_a_number : 1.f);
                else if constexpr (std::is_same_v<C, Position> || std::is_same_v<C, ReceiverPrevious>)
                    return seen;
                else if constexpr (std::is_same_v<C, Light> || std::is_same_v<C, LightPrevious>)
                    return glm::vec3(0, 1, 4);
                else if constexpr (std::is_same_v<C, Blocker> || std::is_same_v<C, BlockerPrevious>)
                    return glm::vec3(not_a_number);
                else
                    return frame[c].get(x, y);
            });
        });
        centre.push_back(run(denoise, frame, history).get(0, 24, 24));
    }
    return centre;
}
} // namespace

TEST_CASE("a filter sees what the previous frame was, wherever it stands") {
    auto const wrong = [](auto const& denoise, auto const& executor) {
        Frame frame{size, denoise};
        History history{size, denoise};
        int count = 0;
        for (int i = 0; i < 4; ++i) {
            tests::fill_still(frame);
            tests::fill(frame[depth], [&](int, int) { return 1.f + static_cast<float>(i); });
            auto const out = run(denoise, frame, history, executor);
            for (int y = 1; i > 0 && y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) count += out.get(0, x, y) != static_cast<float>(i);
        }
        return count;
    };
    CHECK(wrong(Pipeline{radiance, Spatial{DepthBefore{}}, only_now}, Simd{}) == 0);
    CHECK(wrong(Pipeline{radiance, only_now, Spatial{DepthBefore{}}}, Serial{}) == 0);
#if defined(QUELL_TEST_THREADS)
    CHECK(wrong(Pipeline{radiance, only_now, Spatial{DepthBefore{}}}, Threads<>{.count = 2}) == 0);
#endif
    CHECK(wrong(Pipeline{radiance, only_now, Spatial{Gaussian{.radius = 0}}, Spatial{DepthBefore{}}}, Simd{}) == 0);
}

TEST_CASE("a detector behind Temporal sees the history as one before it does") {
    constexpr auto behind = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{ChangeDetector<>{}}, Spatial{Gaussian{}}};
    Frame frame{size, behind};
    History history{size, behind};
    tests::fill_still(frame);
    tests::fill(frame[radiance], [](int, int) { return glm::vec3(1.f); });
    for (int i = 0; i < 3; ++i) CHECK(run(behind, frame, history).get(0, 3, 3) == doctest::Approx(1.f));
}

TEST_CASE("sources are asked in order, however they are nested") {
    auto const mean = [](auto const& sources) {
        auto const denoise = Pipeline{radiance, Temporal{sources, RunningMean{}}};
        Frame frame{size, denoise};
        History history{size, denoise};
        float last = 0;
        for (int i = 1; i <= 4; ++i) {
            tests::fill(frame[radiance], [&](int, int) { return glm::vec3(static_cast<float>(i)); });
            last = run(denoise, frame, history).get(0, 5, 5);
        }
        return last;
    };
    using Left = FirstValid<FirstValid<Nowhere, StillMotion>, Nowhere>;
    CHECK(mean(FirstValid{Nowhere{}, StillMotion{}, Nowhere{}}) == doctest::Approx(2.5f));
    CHECK(mean(Left{FirstValid{Nowhere{}, StillMotion{}}, Nowhere{}}) == doctest::Approx(2.5f));
    CHECK(mean(OddlyNamed{}) == doctest::Approx(2.5f));
    CHECK(mean(FirstValid{Nowhere{}, OddlyNamed{}}) == doctest::Approx(2.5f));
}

TEST_CASE("a policy that needs the camera says so for what it is part of") {
    CHECK(needs_camera_of<SurfaceMotion<WantsCamera>>);
    CHECK(needs_camera_of<DualMotion<WantsCamera>>);
    CHECK(needs_camera_of<SurfaceMotion<AllOf<SameNormal, WantsCamera>>>);
    CHECK(needs_camera_of<Temporal<StillMotion, Exponential, FetchThatWantsCamera>>);
    CHECK(!needs_camera_of<SurfaceMotion<AllOf<SameNormal, SameDepth>>>);
}

TEST_CASE("a pipeline whose last pass makes no signal puts out what there is") {
    constexpr auto no_levels = Spatial{VarianceGuidedAtrous<>{.levels = 0}};
    constexpr Temporal moments{StillMotion{}, WithMoments{RunningMean{}}};
    constexpr auto demodulated = Pipeline{radiance, Demodulate{}, moments, no_levels};
    constexpr auto plain = Pipeline{radiance, moments, no_levels};
    Frame frame{size, demodulated};
    History history{size, demodulated};
    tests::fill_still(frame);
    tests::fill(frame[radiance], [](int, int) { return glm::vec3(1.f); });
    tests::fill(frame[albedo], [](int, int) { return glm::vec3(0.5f); });
    History plain_history{size, plain};
    Planar<>::Image<3> target(size);
    for (int i = 0; i < 3; ++i) {
        CHECK(run(demodulated, frame, history).get(0, 3, 3) == doctest::Approx(1.f));
        run_into(target.view(), plain, frame, plain_history);
        CHECK(target.get(3, 3).x == doctest::Approx(1.f));
    }
    constexpr auto detects = Pipeline{visibility, Spatial{ChangeDetector<StillMotion>{}}};
    Frame samples{size, detects};
    History no_history{size, detects};
    tests::fill(samples[visibility], [](int x, int) { return x == 3 ? not_a_number : 1.f; });
    CHECK(run(detects, samples, no_history).get(0, 3, 3) == 1.f);
}

TEST_CASE("filters behind stages that leave the signal alone know what is missing, whether or not those say so") {
    auto const seen = [](auto... before) {
        auto const denoise = Pipeline{visibility, Spatial{before}..., Spatial{Gaussian{}}, Spatial{Callable{}}};
        Frame frame{size, denoise};
        History history{size, denoise};
        tests::fill_still(frame);
        tests::fill(frame[visibility], [](int x, int) { return x == 3 ? not_a_number : 1.f; });
        return run(denoise, frame, history, Serial{}).get(3, 3);
    };
    CHECK(seen() == doctest::Approx(1.f));
    CHECK(seen(Emitting{}) == doctest::Approx(1.f));
    CHECK(seen(EmittingTwice{}) == doctest::Approx(1.f));
    CHECK(seen(Atrous{NormalEdge{}, 0}) == doctest::Approx(1.f));
}

TEST_CASE("what is missing before a filter leaves history as it was") {
    constexpr auto filtered_first = Pipeline{visibility, Spatial{Bilateral<DepthEdge>{}}, Temporal{StillMotion{}, Clamped{RunningMean{}}}};
    for (float const shown : centre_after_a_burst(filtered_first, 6, 12)) CHECK(shown == doctest::Approx(1.f));
    for (float const shown : centre_after_a_burst(presets::shadow(visibility), 6, 12)) CHECK(shown == doctest::Approx(1.f));
}

TEST_CASE("a pixel that never had a sample is no history for its neighbours") {
    constexpr auto mean = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
    Frame frame{size, mean};
    History history{size, mean};
    for (int i = 0; i < 12; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(i == 0 || (i == 1 && x < 20) ? not_a_number : 1.f); });
        tests::fill(frame[motion], [](int, int) { return glm::vec2(-0.5f, 0.f); });
        auto const out = run(mean, frame, history);
        if (i > 1)
            for (float const value : tests::copy_of(out)) CHECK(value == doctest::Approx(1.f));
    }
}

TEST_CASE("a history that is hardly trusted gains no trust by a missing sample") {
    auto const shown = [](bool missing) {
        constexpr auto denoise = Pipeline{radiance, Temporal{Reluctant{}, RunningMean{}}};
        Frame frame{size, denoise};
        History history{size, denoise};
        float last = 0;
        for (int i = 0; i < 40; ++i) {
            tests::fill(frame[radiance], [&](int, int) { return glm::vec3(i < 30 ? 5.f : i == 30 && missing ? not_a_number : 1.f); });
            tests::fill(frame[roughness], [&](int, int) { return i == 30 ? 1.f : 0.f; });
            last = run(denoise, frame, history).get(0, 3, 3);
        }
        return last;
    };
    // Of 30 frames that counted 3, and one or none of 1, nine later ones are nine of twelve or so.
    CHECK(shown(false) < 2.f);
    CHECK(shown(true) < 2.1f);
}

TEST_CASE("a target of another size, factors of another size and rows without a stride are refused before anything is written") {
    constexpr auto surface = presets::surface(direct);
    Frame frame{size, surface};
    History history{size, surface};
    tests::fill_still(frame);
    Planar<>::Image<3> small(Extent{8, 8});
    CHECK(tests::message([&] { run_into(small.view(), surface, frame, history); }) ==
          "run_into: the target: 8x8 for a frame of 40x24; give it the frame's size");

    constexpr auto both = Composite{presets::surface(glossy), presets::surface(visibility)};
    Frame lit{size, both};
    History its_history{size, both};
    tests::fill_still(lit);
    auto const run_frame = [&](int number) {
        lit.number = number;
        run(both, lit, its_history);
    };
    run_frame(0);
    auto const good = std::move(lit[direct]);
    lit[direct] = Planar<>::Image<3>(Extent{4, 4});
    CHECK(tests::message([&] { run_frame(1); }) == "channel 'direct': 4x4 in a frame of 40x24; give every channel the frame's size");
    lit[direct] = Planar<>::Image<3>(size);
    run_frame(1);
    CHECK(its_history.of_pipeline<0>().statistics().resets == 1);
    CHECK(its_history.of_pipeline<1>().statistics().resets == 1);

    constexpr auto none = presets::none(visibility);
    std::vector<float> const values(static_cast<std::size_t>(size.pixels()));
    Frame borrowed{size, none, Borrowed<>{}};
    History no_history{size, none};
    borrowed[visibility].data = values.data();
    CHECK(tests::message([&] { run(none, borrowed, no_history); }) ==
          "channel 'visibility': row_stride 0; give the distance from a row to the next, in elements");
}

#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/warm_up.hpp>

using namespace quell;

namespace {
struct Lacking : InternalChannel<3> {
    static constexpr auto name = "lacking";
    static constexpr bool full_precision = true;
};
struct TakeLacking {
    static constexpr auto name = "take lacking";
    using reads = Channels<Radiance>;
    using emits = Channels<Lacking>;
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return emitted<Real>(Lacking{}, px[radiance] - px.signal());
    }
};
struct AddMean {
    static constexpr auto name = "add mean";
    using reads = Channels<Lacking>;
    float share = .25f;
    int radius = 2;
    constexpr int farthest_tap() const { return radius; }
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = zero<vec3<Real>>();
        Real count(0.f);
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                auto const tap = px.at(i, j);
                auto const weight = masked(tap.inside(), Real(1.f));
                sum = add_scaled(sum, tap[Lacking{}], weight), count = count + weight;
            }
        return add_scaled(px.signal(), sum, share / count);
    }
};
/// Adds a share of what the picture lacks in the mean of a window.
struct GiveBackMean {
    using parts = Parts<TakeLacking, AddMean>;
    float share = .25f;
    constexpr void for_each_pass(auto&& pass) const { pass(TakeLacking{}), pass(AddMean{share}); }
};

/// Shows for how long the shutter is open.
struct ShowShutter {
    static constexpr auto name = "show shutter";
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        return splat<vec3<Real>>(Real(px.shutter_now()));
    }
};
/// The same, but it says that it looks at the camera.
struct WantsCamera : ShowShutter {
    static constexpr bool needs_camera = true;
};

constexpr Extent size{37, 19};
constexpr auto first = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous{}}};
constexpr auto give_back = Pipeline{denoised, Spatial{GiveBackMean{}}};
constexpr auto chain = Chain{first, give_back};

/// The same by hand, of a picture and its samples.
template <class F> std::vector<float> given_back(F const& frame, std::vector<float> const& picture) {
    auto made = picture;
    auto const place = [](int c, int x, int y) { return static_cast<std::size_t>((y * size.width + x) * 3 + c); };
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) {
                double sum = 0, count = 0;
                for (int v = std::max(y - 2, 0); v <= std::min(y + 2, size.height - 1); ++v)
                    for (int u = std::max(x - 2, 0); u <= std::min(x + 2, size.width - 1); ++u)
                        sum += static_cast<double>(frame[radiance].get(c, u, v)) - static_cast<double>(picture[place(c, u, v)]), ++count;
                made[place(c, x, y)] += static_cast<float>(.25 * sum / count);
            }
    return made;
}
} // namespace

TEST_CASE("a link goes on from what the one before has made, with the samples of the frame") {
    Frame frame{size, chain};
    History history{size, chain};
    History alone{size, first};
    for (unsigned i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, i);
        auto const picture = tests::copy_of(run(first, frame, alone));
        auto const made = tests::copy_of(run(chain, frame, history));
        CHECK(tests::difference(given_back(frame, picture), made) < 1e-5);
        CHECK(tests::difference(picture, made) > 1e-3);
    }
}

TEST_CASE("links follow each other, behind a composite too; one that does nothing changes nothing") {
    constexpr auto lit = Composite{presets::none(glossy), presets::none(indirect)};
    constexpr auto twice = Chain{lit, Pipeline{denoised}, give_back, give_back};
    Frame frame{size, twice, Pipeline{radiance}};
    History history{size, twice};
    History of_light{size, lit};
    tests::fill_randomly(frame, 3);
    auto const picture = tests::copy_of(run(lit, frame, of_light));
    CHECK(tests::difference(given_back(frame, given_back(frame, picture)), tests::copy_of(run(twice, frame, history))) < 1e-5);
    constexpr auto nothing = Chain{lit, Pipeline{denoised}};
    History of_nothing{size, nothing};
    CHECK(picture == tests::copy_of(run(nothing, frame, of_nothing)));
}

TEST_CASE("a link has the shutter of the frame") {
    constexpr auto show = Chain{presets::none(radiance), Pipeline{denoised, Spatial{ShowShutter{}}}};
    Frame frame{size, show};
    History history{size, show};
    for (float const shutter : {.25f, 1.f}) {
        frame.shutter = shutter;
        for (float const shown : tests::copy_of(run(show, frame, history))) CHECK(shown == shutter);
    }
}

TEST_CASE("a chain needs a camera where a link does") {
    constexpr auto wants = Chain{presets::none(radiance), Pipeline{denoised, Spatial{WantsCamera{}}}};
    CHECK(decltype(wants)::needs_camera);
    CHECK(!decltype(chain)::needs_camera);
    Frame frame{size, wants}; // whose camera was never set
    History history{size, wants};
    CHECK(tests::message([&] { run(wants, frame, history); }).find("camera.projection") != std::string::npos);
}

TEST_CASE("a link has a history of its own") {
    constexpr auto steady = Chain{presets::none(radiance), Pipeline{denoised, Temporal{SurfaceMotion{}, RunningMean{}}}};
    Frame frame{size, steady};
    History history{size, steady};
    tests::fill_still(frame);
    std::vector<float> sum(static_cast<std::size_t>(size.width * size.height * 3), 0.f), made;
    for (unsigned i = 0; i < 4; ++i) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) frame[radiance].set(x, y, glm::vec3(static_cast<float>((i * 7 + unsigned(x + y)) % 5)));
        made = tests::copy_of(run(steady, frame, history));
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += frame[radiance].get(0, int(k / 3) % size.width, int(k / 3) / size.width) / 4.f;
    }
    CHECK(tests::difference(sum, made) < 1e-5);
    history.forget();
    made = tests::copy_of(run(steady, frame, history));
    CHECK(made[0] == frame[radiance].get(0, 0, 0));
}

TEST_CASE("all executors make the same picture of a chain, whoever owns the target") {
    auto const packs = tests::sequence(chain, size, Simd{});
    CHECK(tests::difference(tests::sequence(chain, size, Serial{}), packs) < 2e-5);
#ifdef QUELL_TEST_THREADS
    CHECK(tests::sequence(chain, size, Threads<>{.count = 3, .tile = {16, 5}}) == packs);
#endif
    Frame frame{size, chain};
    History history{size, chain}, into{size, chain};
    tests::fill_randomly(frame, 0);
    Planar<>::Image<3> target(size);
    run_into(target.view(), chain, frame, into);
    CHECK(tests::copy_of(run(chain, frame, history)) == tests::copy_of(target.view()));
}

TEST_CASE("a frame that is refused leaves a chain where it was") {
    Frame frame{size, chain};
    History history{size, chain}, other{size, chain};
    tests::fill_randomly(frame, 0);
    run(chain, frame, history), run(chain, frame, other);
    tests::fill_randomly(frame, 1);
    frame.shutter = -1.f;
    CHECK(tests::message([&] { run(chain, frame, history); }).find("frame.shutter") != std::string::npos);
    frame.shutter = .5f;
    CHECK(tests::copy_of(run(chain, frame, history)) == tests::copy_of(run(chain, frame, other)));
}

TEST_CASE("a plan of a chain has the passes of all denoisers and the memory of their history") {
    auto const plan = plan_of(chain), before = plan_of(first);
    REQUIRE(plan.passes.size() == before.passes.size() + 3);
    CHECK(plan.passes[before.passes.size()].reads == PlannedPass::Names{"denoised"});
    CHECK(plan.passes.back().name == "add mean");
    CHECK(to_string(plan).find("| **denoised** |") != std::string::npos);
    Frame frame{Extent{1024, 16}, chain};
    tests::fill_still(frame);
    History history{frame.size, chain};
    for (int i = 0; i < 2; ++i) run(chain, frame, history);
    CHECK(plan.bytes_per_pixel == doctest::Approx(history.bytes_per_pixel()));
    // What the first has left is scratch of the link.
    CHECK(plan.bytes_per_pixel < before.bytes_per_pixel + 3 * 12 + 12);
    static_assert(warm_up_frames(chain) == warm_up_frames(first));
}

#include "../frames.hpp"

#include <quell/diagnose/watched.hpp>
#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/blur.hpp>
#include <quell/quell.hpp>

#include <doctest/doctest.h>

using namespace quell;
using namespace quell::tests;

namespace {

struct Silent { // a blend policy that declares nothing
    float cap = 3.f;
    QUELL_KERNEL auto blend(auto px, auto past) const { return accumulate(px, past, 1.f - past.validity * 0.5f); }
};
struct OddlyNamed : Silent { // its number is named like what a decorator decorates
    float inner = 3.f;
};
struct Short { // one that remembers two frames, of which nothing is seen after four
    [[nodiscard]] constexpr BlendMemory memory() const { return {.frames = 2.f, .times = 2.f}; }
    QUELL_KERNEL auto blend(auto px, auto past) const { return accumulate(px, past, 1.f - past.validity * 0.5f); }
};

template <class Inner> struct Decorated { // a decorator that declares nothing
    using parts = Parts<Inner>;
    Inner inner{};
    QUELL_KERNEL auto blend(auto px, auto past) const { return inner.blend(px, past); }
};

constexpr auto with(auto blend) { return Pipeline{radiance, Temporal{SurfaceMotion{}, blend}}; }

/// Weight of a first frame of brightness 1 in the mean, `after` black frames later.
float weight_after(auto const& pipeline, int after) {
    Frame frame{{4, 4}, pipeline};
    History history{frame.size, pipeline};
    float weight = 0.f;
    // Long before it, so that its own weight is the usual one.
    for (int i = -200; i <= after; ++i) {
        fill(frame[radiance], [&](int, int) { return glm::vec3(i == 0 ? 1.f : 0.f); });
        weight = run(pipeline, frame, history, Serial{}).get(0, 1, 1);
    }
    return weight;
}

} // namespace

TEST_CASE("a declared memory is the time in which the weight of an old frame falls to 1/e") {
    auto const check = [](auto blend) {
        Pipeline const pipeline{radiance, Temporal{StillMotion{}, blend}};
        auto const frames = memory_of(blend).frames;
        auto const part = weight_after(pipeline, static_cast<int>(frames)) / weight_after(pipeline, 0);
        CHECK(part == doctest::Approx(std::exp(-1.f)).epsilon(0.1));
    };
    constexpr Exponential exponential{.alpha = 0.1f};
    constexpr RunningMean mean{.cap = 24.f};
    check(exponential);
    check(mean);
    check(WithMoments{mean});
}

TEST_CASE("decorators remember as their inner policy does, and say what hides it sooner") {
    constexpr RunningMean mean{.cap = 24.f};
    CHECK(warm_up_frames(with(mean)) == 216);
    CHECK(warm_up_frames(Pipeline{radiance, Spatial{ChangeDetector<>{}}, Temporal{SurfaceMotion{}, WithMoments{ForgetChanged{mean}}}}) ==
          216);
    CHECK(warm_up_frames(with(Clamped{mean})) == 96);
    CHECK(warm_up_frames(with(WithVariance{mean})) == 48);
    CHECK(warm_up_frames(with(Clamped{WithVariance{mean}})) == 48);
    CHECK(warm_up_frames(with(Clamped{Short{}})) == 4);
    CHECK(warm_up_frames(with(Decorated<Short>{})) == 4);
    CHECK(warm_up_frames(watched(with(Clamped{mean}))) == 96);
}

TEST_CASE("what isn't declared is taken for as long a memory as any preset has") {
    CHECK(warm_up_frames(with(Silent{})) == 288);
    CHECK(warm_up_frames(with(OddlyNamed{})) == 288);
    CHECK(warm_up_frames(with(Clamped{Silent{}})) == 128);
    CHECK(warm_up_frames(with(Short{})) == 4);
}

TEST_CASE("a pipeline remembers as its longest stage does, a composite as its longest part, and without a history nothing is") {
    CHECK(warm_up_frames(Pipeline{radiance, Spatial{Atrous{Product{DepthEdge{}, NormalEdge{}}}}}) == 0);
    CHECK(warm_up_frames(presets::surface(radiance)) == 90);
    CHECK(warm_up_frames(presets::general(radiance)) == 48);
    CHECK(warm_up_frames(presets::blur(radiance)) == 6);
    CHECK(warm_up_frames(presets::trmv()) == 216); // of its indirect light
}

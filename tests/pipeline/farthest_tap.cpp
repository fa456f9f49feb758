#include "../recorded_taps.hpp"
#include "presets.hpp"

#include <quell/link/light_given_back.hpp>

using namespace quell;

namespace quell::tests {
struct Half : InternalChannel<1> {
    static constexpr auto name = "half";
    static constexpr int fraction = 2;
};
} // namespace quell::tests

namespace {
/// The passes of three frames.
template <class P> std::vector<tests::RecordedPass> recorded(P const& denoise, Extent size) {
    std::vector<tests::RecordedPass> passes;
    tests::sequence(denoise, size, tests::RecordingExecutor{&passes}, [&](auto& frame, unsigned i) {
        frame.camera = tests::View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
    });
    return passes;
}
template <class P> void check_declared(P const& denoise) {
    for (auto const& pass : recorded(denoise, {67, 37})) {
        INFO(pass.name, ": declared ", pass.declared, ", found ", pass.found);
        CHECK(pass.found <= pass.declared);
    }
}

struct Liar {
    static constexpr auto name = "liar";
    static constexpr int farthest_tap = 1;
    QUELL_KERNEL auto filter(auto px) const { return px.at(0, -2).signal(); }
};
struct SaysNothing {
    QUELL_KERNEL auto filter(auto px) const { return px.signal(); }
};
template <class Part> struct MadeOf {
    using parts = Parts<Part>;
    static constexpr int farthest_tap = 0;
};
struct ByNumber {
    int radius;
    constexpr int farthest_tap() const { return radius; }
};
/// Half the size; looks at the fine pixels below a neighbour.
struct Halved {
    static constexpr int fraction = 2, farthest_tap = 3;
    using emits = Channels<tests::Half>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return emitted<Real>(tests::Half{}, luminance(px.finer_signal(0, 6)));
    }
};
/// Looks at the coarse pixel two to the right.
struct Spread {
    static constexpr int farthest_tap = 4;
    using reads = Channels<tests::Half>;
    QUELL_KERNEL auto filter(auto px) const { return scale(px.signal(), px.coarser(tests::Half{}, 2, 0)); }
};
} // namespace

static_assert(detail::farthest_tap_of(SaysNothing{}) == anywhere);
static_assert(detail::farthest_tap_of(MadeOf<DepthEdge>{}) == 1 && detail::farthest_tap_of(MadeOf<MadeOf<NormalEdge>>{}) == 0);
static_assert(detail::farthest_tap_of(MadeOf<SaysNothing>{}) == anywhere);
static_assert(detail::farthest_tap_of(ByNumber{7}) == 7 && detail::farthest_tap_of(MadeOf<ByNumber>{}) == anywhere);
static_assert(detail::farthest_tap_of(Temporal{SurfaceMotion{}, Clamped<RunningMean, MinMax, Rgb, 2>{}}) == 2);
static_assert(detail::farthest_tap_of(Temporal{FirstValid{SurfaceMotion{}, DualMotion{}}, RunningMean{}}) == anywhere);

TEST_CASE("a tap beyond what a policy declares is found") {
    auto const passes = recorded(Pipeline{radiance, Spatial{Liar{}}}, {9, 7});
    REQUIRE(passes.size() == 6); // the ingest and the filter, in three frames
    CHECK(passes[1].name == "liar");
    CHECK(passes[1].declared == 1);
    CHECK(passes[1].found == 2);
}

TEST_CASE("taps stay within what their policies declare") {
    tests::for_each_tested_preset<0, 1>([](auto const& preset) {
        CAPTURE(preset.name);
        check_declared(std::remove_cvref_t<decltype(preset)>::usual());
    });
}

TEST_CASE("taps of links stay within what their policies declare") {
    check_declared(light_given_back(radiance, 4.f));
    check_declared(Pipeline{denoised, Spatial{RepeatedResidual<Radiance, true>{}}});
}

TEST_CASE("taps are as far as a filter's levels say") {
    std::vector<int> found;
    for (auto const& pass : recorded(Pipeline{radiance, Spatial{Atrous{}}}, {67, 37}))
        if (pass.name == "a-trous") {
            CHECK(pass.declared == pass.found);
            found.push_back(pass.found);
        }
    found.resize(5);
    CHECK(found == std::vector{2, 4, 8, 16, 32});
}

TEST_CASE("between sizes, taps count in pixels of the pass") {
    auto const passes = recorded(Pipeline{radiance, Spatial{Halved{}}, Spatial{Spread{}}}, {32, 32});
    CHECK(passes[1].found == 3);
    CHECK(passes[2].found == 4);
}

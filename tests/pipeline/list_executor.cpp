#include "../frames.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>

#include <algorithm>

using namespace quell;

// An executor that takes the whole list may run it in any order that the list allows.
namespace {
/// The rows that a pass has to wait for are done.
bool may_run(std::span<ListedPass const> passes, std::vector<int> const& done, std::size_t i, int last_row) {
    for (std::size_t earlier = 0; earlier < i; ++earlier)
        if (done[earlier] < rows_before(passes[earlier], passes[i], last_row)) return false;
    return true;
}
/// Runs whichever last pass may run, `rows` rows of the frame at a time.
struct LastFirst {
    int rows;
    int* overtaken; ///< how often a pass has run before an earlier one was done

    void for_each_pixel(Region region, auto const& job) const { Serial{}.for_each_pixel(region, job); }
    void run_list(std::span<ListedPass const> passes) const {
        std::vector<int> done(passes.size());
        while (run_one(passes, done)) {
        }
        for (std::size_t i = 0; i < passes.size(); ++i) REQUIRE(done[i] == passes[i].size.height);
    }

private:
    bool run_one(std::span<ListedPass const> passes, std::vector<int>& done) const {
        for (auto i = passes.size(); i-- > 0;) {
            auto const size = passes[i].size;
            int const to = std::min(done[i] + std::max(rows / passes[i].fraction, 1), size.height);
            if (done[i] == size.height || !may_run(passes, done, i, to - 1)) continue;
            for (std::size_t earlier = 0; earlier < i; ++earlier) *overtaken += done[earlier] < passes[earlier].size.height;
            passes[i]({0, done[i], size.width, to});
            done[i] = to;
            return true;
        }
        return false;
    }
};
static_assert(ListExecutor<LastFirst> && !ListExecutor<Serial> && !ListExecutor<Simd>);

template <class P> void check_any_order(P const& denoise) {
    constexpr Extent size{23, 61};
    auto const in_order = tests::sequence(denoise, size, Serial{});
    int overtaken = 0;
    CHECK(tests::sequence(denoise, size, LastFirst{.rows = 4, .overtaken = &overtaken}) == in_order);
    CHECK(overtaken > 0);
    CHECK(tests::sequence(denoise, size, LastFirst{.rows = 1000, .overtaken = &overtaken}) == in_order);
}

struct Halved : InternalChannel<1> {
    static constexpr auto name = "halved";
    static constexpr int fraction = 2;
};
struct Halve {
    static constexpr int fraction = 2, farthest_tap = 1;
    using emits = Channels<Halved>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        return emitted<typename decltype(px)::Real>(Halved{}, luminance(px.finer_signal(0, 3)) + luminance(px.finer_signal(1, -2)));
    }
};
struct AddCoarse {
    static constexpr int farthest_tap = 3;
    using reads = Channels<Halved>;
    QUELL_KERNEL auto filter(auto px) const { return add_scaled(px.signal(), px.signal(), px.coarser(Halved{}, 0, 1)); }
};
struct SaysNothing {
    QUELL_KERNEL auto filter(auto px) const { return px.at(0, -9).signal(); }
};
} // namespace

TEST_CASE("passes by rows and in another order give the same bits") {
    check_any_order(presets::svgf(radiance, Demodulate{}));
    check_any_order(presets::general(radiance));
    check_any_order(Pipeline{visibility, Spatial{ChangeDetector<StillMotion>{}}, Spatial{Gaussian{}}, Spatial{SaysNothing{}},
                             Temporal{StillMotion{}, ForgetChanged{RunningMean{}}}});
    check_any_order(Pipeline{radiance, Spatial{Halve{}}, Spatial{Gaussian{}}, Spatial{AddCoarse{}}});
    check_any_order(light_given_back(radiance, 4.f));
    check_any_order(Composite{presets::surface(glossy), presets::atrous(indirect)});
}

TEST_CASE("what a pass waits for") {
    int const a = 0, b = 0;
    ListedRead const reads[] = {{&a, 3}};
    void const *const writes_a[] = {&a}, *const writes_b[] = {&b};
    ListedPass const writer{.name = "writer", .size = {8, 20}, .writes = writes_a},
        reader{.name = "reader", .size = {8, 20}, .reads = reads, .writes = writes_b},
        other{.name = "other", .size = {8, 20}, .writes = {}},
        half{.name = "half", .size = {8, 10}, .fraction = 2, .reads = reads, .writes = writes_b};
    CHECK(rows_before(writer, reader, 5) == 9);
    CHECK(rows_before(reader, writer, 5) == 9); // row 5 is overwritten when row 8 has read it
    CHECK(rows_before(writer, reader, 19) == 20);
    CHECK(rows_before(writer, other, 5) == 0);
    CHECK(rows_before(reader, half, 5) == 12); // both write b
    CHECK(rows_before(writer, half, 5) == 15); // rows 10 and 11, and 3 more
    CHECK(rows_before(half, writer, 5) == 5);
}

// The list is a value: a compiler makes it where the pipeline is one.
namespace {
template <class P> constexpr auto list_of(P const& pipeline) {
    using K = detail::Kernels<P, Frame<typename P::reads>, Planar<>, detail::NoWork, detail::NoTarget>;
    detail::PassList list;
    detail::list_passes<detail::StageOrder<P>::count, Planar<>, Planar<>, K>(pipeline, list, false);
    return list;
}
constexpr auto svgf = presets::svgf(radiance, Demodulate{});
} // namespace
static_assert(list_of(svgf).passes.size() == 7);
static_assert(list_of(svgf).passes[0].name == "temporal" && list_of(svgf).passes[0].reads_past_signal);
static_assert(list_of(svgf).passes[6].farthest_tap == 32 && !list_of(svgf).is_wanted(&detail::channel_info<Variance>, 6));

TEST_CASE("a list is made once, and again where numbers, executor or target differ") {
    int made = 0;
    detail::ListOnce once;
    char serial = 0, simd = 0;
    auto const update = [&](char& maker, auto const& pipeline) { once.update(&maker, pipeline, [&](detail::PassList&) { ++made; }); };
    auto pipeline = Pipeline{radiance, Spatial{Atrous{}}};
    update(serial, pipeline), update(serial, pipeline);
    CHECK(made == 1);
    std::get<0>(pipeline.stages).kernel.levels = 2;
    update(serial, pipeline), update(serial, pipeline);
    CHECK(made == 2);
    update(simd, pipeline);
    CHECK(made == 3);
}

TEST_CASE("a pipeline's numbers may change from frame to frame") {
    auto const denoise = [](int levels) { return Pipeline{radiance, Spatial{Atrous<>{.levels = levels}}}; };
    Frame frame{Extent{16, 9}, denoise(1)};
    tests::fill_randomly(frame, 1);
    History history{frame.size, denoise(1)};
    for (int const levels : {1, 3, 2}) {
        History fresh{frame.size, denoise(1)};
        CHECK(tests::copy_of(run(denoise(levels), frame, history, Serial{})) ==
              tests::copy_of(run(denoise(levels), frame, fresh, Serial{})));
    }
}

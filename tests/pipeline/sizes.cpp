#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/pipeline/plan.hpp>

#include <limits>

using namespace quell;

// Passes and channels of a fraction of the frame's size, against a plain computation pixel by pixel.
namespace {
template <int n> struct Coarse : InternalChannel<3> {
    static constexpr auto name = "coarse";
    static constexpr int fraction = n;
};
/// The mean of the n x n pixels under each.
template <int n> struct Down {
    static constexpr int fraction = n;
    using emits = Channels<Coarse<n>>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = zero<vec3<Real>>();
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) sum = add_scaled(sum, px.finer_signal(i, j), Real(1.f / (n * n)));
        return emitted<Real>(Coarse<n>{}, sum);
    }
};
/// From one coarse channel to another one, of twice its fraction.
struct Further {
    static constexpr int fraction = 4;
    using reads = Channels<Coarse<2>>;
    using emits = Channels<Coarse<4>>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return emitted<Real>(Coarse<4>{}, px.finer(Coarse<2>{}, 1, 0));
    }
};
/// What is seen from the frame's size: the pixel over each, or a mean.
template <int n, bool interpolated> struct Up {
    using reads = Channels<Coarse<n>>;
    QUELL_KERNEL auto filter(auto px) const {
        if constexpr (interpolated)
            return px.coarser_interpolated(Coarse<n>{});
        else
            return px.coarser(Coarse<n>{}, 1, -1);
    }
};
template <class... Passes> struct InTurn {
    using parts = Parts<Passes...>;
    constexpr void for_each_pass(auto&& pass) const { (pass(Passes{}), ...); }
};

using Rgb = glm::dvec3;
struct Grid {
    Extent size;
    std::vector<Rgb> values;
    [[nodiscard]] Rgb at(int x, int y) const {
        x = std::clamp(x, 0, size.width - 1), y = std::clamp(y, 0, size.height - 1);
        return values[static_cast<std::size_t>(y * size.width + x)];
    }
};
template <class F> Grid grid_of(Extent size, F&& f) {
    Grid grid{size, {}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) grid.values.push_back(f(x, y));
    return grid;
}
Grid mean_of(Grid const& fine, int n) {
    return grid_of(divided(fine.size, n), [&](int x, int y) {
        Rgb sum(0);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) sum += fine.at(x * n + i, y * n + j);
        return sum / double(n * n);
    });
}
Rgb interpolated(Grid const& coarse, int n, int x, int y) {
    double const column = (x + 0.5) / n - 0.5, row = (y + 0.5) / n - 0.5;
    int const i = static_cast<int>(std::floor(column)), j = static_cast<int>(std::floor(row));
    double const u = column - i, v = row - j;
    return (1 - v) * ((1 - u) * coarse.at(i, j) + u * coarse.at(i + 1, j)) +
           v * ((1 - u) * coarse.at(i, j + 1) + u * coarse.at(i + 1, j + 1));
}

template <class P, class F> void check(P const& pipeline, Extent size, F&& wanted) {
    CAPTURE(size.width);
    CAPTURE(size.height);
    Frame frame{size, pipeline};
    tests::fill_randomly(frame, 3);
    auto const view = frame[radiance].view();
    auto const fine = grid_of(size, [&](int x, int y) { return Rgb(view.get(0, x, y), view.get(1, x, y), view.get(2, x, y)); });
    auto const in_packs = [&] {
        History history{size, pipeline};
        return tests::copy_of(run(pipeline, frame, history));
    }();
    History serial{size, pipeline};
    auto const one_by_one = tests::copy_of(run(pipeline, frame, serial, Serial{}));
#if defined(QUELL_TEST_THREADS)
    History threads{size, pipeline};
    CHECK(in_packs == tests::copy_of(run(pipeline, frame, threads, Threads<>{.count = 2, .tile = {16, 2}})));
#endif
    double worst = 0, apart = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c) {
                auto const i = static_cast<std::size_t>(3 * (y * size.width + x) + c);
                worst = std::max(worst, std::abs(wanted(fine, x, y)[c] - double(one_by_one[i])));
                apart = std::max(apart, std::abs(double(in_packs[i]) - double(one_by_one[i])));
            }
    CHECK(worst < 1e-5);
    CHECK(apart < 1e-5);
}
constexpr Extent sizes[] = {{64, 32}, {65, 33}, {37, 21}, {1, 1}, {2, 5}, {3, 1}};
} // namespace

TEST_CASE("a fraction of a size is rounded up, and no size is too large") {
    CHECK(divided({5, 4}, 2) == Extent{3, 2});
    CHECK(divided({1, 1}, 16) == Extent{1, 1});
    CHECK(divided({7, 9}, 1) == Extent{7, 9});
    int const most = std::numeric_limits<int>::max();
    CHECK(divided({most, 0}, 2) == Extent{most / 2 + 1, 0});
}

TEST_CASE("a pass at a half or a third of the size sees the pixels under it, and the frame sees it interpolated") {
    for (auto const size : sizes) {
        check(Pipeline{radiance, Spatial{InTurn<Down<2>, Up<2, true>>{}}}, size,
              [](Grid const& fine, int x, int y) { return interpolated(mean_of(fine, 2), 2, x, y); });
        check(Pipeline{radiance, Spatial{InTurn<Down<3>, Up<3, false>>{}}}, size,
              [](Grid const& fine, int x, int y) { return mean_of(fine, 3).at(x / 3 + 1, y / 3 - 1); });
    }
}

TEST_CASE("a pass at a quarter reads what one at a half has made") {
    for (auto const size : sizes)
        check(Pipeline{radiance, Spatial{InTurn<Down<2>, Further, Up<4, false>>{}}}, size, [](Grid const& fine, int x, int y) {
            auto const half = mean_of(fine, 2);
            auto const quarter = grid_of(divided(fine.size, 4), [&](int i, int j) { return half.at(2 * i + 1, 2 * j); });
            return quarter.at(x / 4 + 1, y / 4 - 1);
        });
}

TEST_CASE("an image of a half of the size takes a quarter of the memory, also beside a history") {
    constexpr auto with = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{InTurn<Down<2>, Up<2, true>>{}}};
    constexpr auto without = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous<>{.levels = 1}}};
    CHECK(plan_of(with).bytes_per_pixel - plan_of(without).bytes_per_pixel == doctest::Approx(3).epsilon(0.05));
    CHECK(plan_of(with).passes[2].fraction == 2);
}

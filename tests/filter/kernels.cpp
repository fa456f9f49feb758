#include "../frames.hpp"

using namespace quell;

namespace {
/// Filters a frame filled by `fill(frame)` once.
template <class P> std::vector<float> filtered(P const& pipeline, Extent size, auto&& fill, int frames = 1) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::vector<float> out;
    for (int i = 0; i < frames; ++i) {
        fill(frame);
        out = tests::copy_of(run(pipeline, frame, history));
    }
    return out;
}

// One pipeline for each kernel of the house.
constexpr auto kernels = std::tuple{
    Pipeline{radiance, Spatial{Gaussian{.radius = 3}}},
    Pipeline{radiance, Spatial{Bilateral<>{.radius = 5}}},
    Pipeline{radiance, Spatial{Atrous{}}},
    Pipeline{radiance, Spatial{Atrous{Product{DepthEdge{}, NormalEdge{}, LuminanceEdge{.sigma = 2.f}}, 3}}},
    // No guides, which are 0 beside the image and could hide that something from there counts.
    Pipeline{radiance, Spatial{Atrous{LuminanceEdge{.sigma = 1e3f}, 2}}},
    Pipeline{radiance, Temporal{StillMotion{}, WithMoments{RunningMean{}}}, Spatial{VarianceGuidedAtrous{}}},
    Pipeline{radiance, Temporal{StillMotion{}, WithCleanUp{RunningMean{}}}, Spatial{CleanUp{}}},
    presets::svgf(radiance, Demodulate{}),
    presets::general(radiance, Demodulate{}),
};
} // namespace

TEST_CASE("a constant image stays constant under every kernel, at borders and edges of the guides too") {
    std::apply(
        [](auto const&... pipeline) {
            (
                [&] {
                    for (Extent const size : {Extent{37, 23}, Extent{1, 1}, Extent{3, 40}}) {
                        auto const out = filtered(pipeline, size, [](auto& frame) {
                            tests::fill_randomly(frame, 3);
                            tests::fill(frame[radiance], [](int, int) { return glm::vec3(0.7f, 1.5f, 100.f); });
                            if constexpr (std::remove_reference_t<decltype(frame)>::channels::template has<Albedo>)
                                tests::fill(frame[albedo], [](int, int) { return glm::vec3(0.5f); });
                        });
                        for (std::size_t i = 0; i < out.size(); i += 3) {
                            CHECK(out[i] == doctest::Approx(0.7f).epsilon(1e-6));
                            CHECK(out[i + 1] == doctest::Approx(1.5f).epsilon(1e-6));
                            CHECK(out[i + 2] == doctest::Approx(100.f).epsilon(1e-6));
                        }
                    }
                }(),
                ...);
        },
        kernels);
}

namespace {
/// The same frame, seen through one of the eight symmetries of a rectangle of pixels.
enum class Symmetry { flip_x, flip_y, transpose };

Extent seen(Symmetry s, Extent size) { return s == Symmetry::transpose ? Extent{size.height, size.width} : size; }

template <class F> void fill_seen(F& frame, Symmetry s, Extent original) {
    Frame<typename F::channels> straight{original};
    tests::fill_randomly(straight, 11);
    for_each_channel(typename F::channels{}, [&](auto c) {
        tests::fill(frame[c], [&](int x, int y) {
            int const from_x = s == Symmetry::flip_x ? original.width - 1 - x : s == Symmetry::transpose ? y : x;
            int const from_y = s == Symmetry::flip_y ? original.height - 1 - y : s == Symmetry::transpose ? x : y;
            return straight[c].get(from_x, from_y);
        });
    });
}
} // namespace

namespace {
template <class P> constexpr bool is_separable = false;
template <class Edge> constexpr bool is_separable<Pipeline<Radiance, Spatial<Bilateral<Edge>>>> = true;
template <class T, class Edge> constexpr bool is_separable<Pipeline<Radiance, T, Spatial<CleanUp<Edge>>>> = true;
} // namespace

TEST_CASE("flips and transposes of the input flip and transpose the output") {
    Extent const size{33, 21};
    std::apply(
        [&](auto const&... pipeline) {
            (
                [&] {
                    auto const straight = filtered(pipeline, size, [](auto& frame) { tests::fill_randomly(frame, 11); });
                    for (auto const s : {Symmetry::flip_x, Symmetry::flip_y, Symmetry::transpose}) {
                        // Rows first, columns second: with edges that is not the same as columns first.
                        if (s == Symmetry::transpose && is_separable<std::remove_cvref_t<decltype(pipeline)>>) continue;
                        // Motion would have to be flipped as well; these kernels see none in a first frame.
                        auto const out = filtered(pipeline, seen(s, size), [&](auto& frame) { fill_seen(frame, s, size); });
                        double worst = 0;
                        for (int y = 0; y < size.height; ++y)
                            for (int x = 0; x < size.width; ++x) {
                                int const to_x = s == Symmetry::flip_x ? size.width - 1 - x : s == Symmetry::transpose ? y : x;
                                int const to_y = s == Symmetry::flip_y ? size.height - 1 - y : s == Symmetry::transpose ? x : y;
                                for (int c = 0; c < 3; ++c) {
                                    float const a = straight[static_cast<std::size_t>((y * size.width + x) * 3 + c)];
                                    float const b = out[static_cast<std::size_t>((to_y * seen(s, size).width + to_x) * 3 + c)];
                                    worst = std::max(worst, std::abs(static_cast<double>(a) - b) / std::max(1.f, std::abs(a)));
                                }
                            }
                        CHECK(worst < 2e-5);
                    }
                }(),
                ...);
        },
        kernels);
}

TEST_CASE(
    "a wavelet of 3x3 taps spreads an impulse by 1/4, 1/2, 1/4 along each axis; its second level reaches twice as far, by thirds if it "
    "is a box") {
    Extent const size{19, 11};
    auto const impulse = [](auto& frame) {
        tests::fill(frame[radiance], [](int x, int y) { return x == 9 && y == 5 ? glm::vec3(1, 2, 4) : glm::vec3(0); });
        tests::fill(frame[depth], [](int, int) { return 2.f; });
        tests::fill(frame[normal], [](int, int) { return glm::vec3(0.f, 0.f, 1.f); });
    };
    auto const check = [&]<class Spline>(Spline, int levels, std::vector<float> const& axis) {
        Atrous<Product<DepthEdge, NormalEdge>, Spline> const wavelet{.levels = levels};
        auto const out = filtered(Pipeline{radiance, Spatial{wavelet}}, size, impulse);
        int const reach = static_cast<int>(axis.size() / 2);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                bool const reached = std::abs(x - 9) <= reach && std::abs(y - 5) <= reach;
                float const wanted =
                    reached ? axis[static_cast<std::size_t>(x - 9 + reach)] * axis[static_cast<std::size_t>(y - 5 + reach)] : 0.f;
                for (std::size_t c = 0; c < 3; ++c)
                    CHECK(out[static_cast<std::size_t>(y * size.width + x) * 3 + c] ==
                          doctest::Approx(wanted * static_cast<float>(1 << c)).epsilon(1e-5));
            }
    };
    check(LinearSpline{}, 1, {0.25f, 0.5f, 0.25f});
    check(LinearSpline{}, 2, {0.0625f, 0.125f, 0.1875f, 0.25f, 0.1875f, 0.125f, 0.0625f});
    check(LinearThenBox{}, 1, {0.25f, 0.5f, 0.25f});
    float const t = 1.f / 12.f;
    check(LinearThenBox{}, 2, {t, 2 * t, 2 * t, 2 * t, 2 * t, 2 * t, t});
}

namespace {
/// Three levels of a wavelet with edges at normals and at luminance, summed up plainly in double precision.
/// @param weight_of of the spline's weight and a distance, makes a tap's weight
std::vector<glm::dvec3> plain_wavelet(Extent size, auto const& frame, double sigma, auto const& weight_of) {
    double const spline[] = {0.375, 0.25, 0.0625};
    auto index = [&](int x, int y) { return static_cast<std::size_t>(y * size.width + x); };
    auto const light = [](glm::dvec3 v) { return 0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z; };
    std::vector<glm::dvec3> now(static_cast<std::size_t>(size.pixels())), next(now.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) now[index(x, y)] = frame[radiance].get(x, y);
    for (int level = 0; level < 3; ++level) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                glm::dvec3 sum(0);
                double weights = 0;
                for (int j = -2; j <= 2; ++j)
                    for (int i = -2; i <= 2; ++i) {
                        int const tap_x = x + i * (1 << level), tap_y = y + j * (1 << level);
                        if (tap_x < 0 || tap_y < 0 || tap_x >= size.width || tap_y >= size.height) continue;
                        double const cosine = glm::dot(glm::dvec3(frame[normal].get(x, y)), glm::dvec3(frame[normal].get(tap_x, tap_y)));
                        double const step = std::abs(light(now[index(tap_x, tap_y)]) - light(now[index(x, y)]));
                        double const of_spline = spline[std::abs(i)] * spline[std::abs(j)];
                        double const w = i == 0 && j == 0 ? of_spline : weight_of(of_spline, 128 * (1 - cosine) + step / sigma);
                        sum += now[index(tap_x, tap_y)] * w;
                        weights += w;
                    }
                next[index(x, y)] = sum / weights;
            }
        std::swap(now, next);
    }
    return now;
}

struct WorstAndMean {
    double worst = 0, mean = 0;
};
/// Of all components.
WorstAndMean error_of(std::vector<float> const& out, std::vector<glm::dvec3> const& wanted) {
    WorstAndMean error;
    for (std::size_t i = 0; i < out.size(); ++i) {
        double const d = std::abs(wanted[i / 3][static_cast<int>(i % 3)] - static_cast<double>(out[i]));
        error.worst = std::max(error.worst, d), error.mean += d / static_cast<double>(out.size());
    }
    return error;
}
} // namespace

TEST_CASE("an a-trous level is the sum that the paper writes, computed plainly in double precision") {
    Extent const size{41, 27};
    float const sigma = 0.8f;
    auto const pipeline = Pipeline{radiance, Spatial{Atrous{Product{NormalEdge{}, LuminanceEdge{.sigma = sigma}}, 3}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_randomly(frame, 9);
    auto const out = tests::copy_of(run(pipeline, frame, history));
    // With the weights of the house, which another test holds to the exponential: the same but for rounding.
    auto const house = error_of(out, plain_wavelet(size, frame, sigma, [](double weight, double distance) {
                                    return edge_weight(static_cast<float>(distance), WeightBits::of(static_cast<float>(weight)));
                                }));
    INFO("with edge_weight: ", house.worst, ", ", house.mean);
    CHECK(house.worst < 1e-5);
    // They are chords of the exponential, up to 6 % off: what that does to the image is this.
    auto const paper =
        error_of(out, plain_wavelet(size, frame, sigma, [](double weight, double distance) { return weight * std::exp(-distance); }));
    INFO("with the exponential: ", paper.worst, ", ", paper.mean);
    CHECK(paper.worst < 0.03);
    CHECK(paper.mean < 0.005);
}

namespace {
/// Lets a pipeline's output be the variance that a variance-guided wavelet leaves.
struct ShowRest {
    using reads = Channels<Variance>;
    QUELL_KERNEL auto filter(auto px) const {
        auto const rest = px[variance];
        return vec3<decltype(rest + rest)>{rest, rest, rest};
    }
};
/// Of light that changes over time and is the same everywhere.
double rest_of_variance(int levels) {
    auto const pipeline = Pipeline{radiance, Temporal{StillMotion{}, WithMoments{RunningMean{}}},
                                   Spatial{VarianceGuidedAtrous<>{.levels = levels, .feedback = false}}, Spatial{ShowRest{}}};
    float light = 1.f;
    auto const out = filtered(
        pipeline, {21, 15},
        [&](auto& frame) {
            tests::fill_still(frame);
            tests::fill(frame[radiance], [&](int, int) { return glm::vec3(light); });
            light = 4.f - light;
        },
        6);
    return out[(7 * 21 + 10) * 3];
}
} // namespace

TEST_CASE("a wavelet lessens the variance by the squares of its weights") {
    // Of 1, 3, 1, 3, 1, 3 the variance is 1, and that of their mean a sixth of it.
    CHECK(rest_of_variance(0) == doctest::Approx(1. / 6).epsilon(1e-5));
    double const axis = 0.375 * 0.375 + 2 * (0.25 * 0.25 + 0.0625 * 0.0625);
    CHECK(rest_of_variance(1) == doctest::Approx(axis * axis / 6).epsilon(1e-3));
}

TEST_CASE("first_tolerance multiplies sigma_luminance in the first level only") {
    Extent const size{33, 21};
    auto const out = [&](int levels, float sigma, float first) {
        VarianceGuidedAtrous<> const wavelet{.levels = levels, .sigma_luminance = sigma, .first_tolerance = first};
        return filtered(Pipeline{radiance, Temporal{StillMotion{}, WithMoments{RunningMean{}}}, Spatial{wavelet}}, size,
                        [](auto& frame) { tests::fill_randomly(frame, 5); });
    };
    CHECK(out(1, 1.f, 4.f) == out(1, 4.f, 1.f));
    CHECK(out(1, 1.f, 4.f) != out(1, 1.f, 1.f));
    CHECK(out(2, 1.f, 4.f) != out(2, 4.f, 1.f));
}

TEST_CASE("edge weights: 1 at no distance, falling, never negative, close to the exponential") {
    CHECK(edge_weight(0.f) == 1.f);
    float last = 1.f;
    for (float d = 0.f; d < 60.f; d += 0.01f) {
        float const w = edge_weight(d);
        CHECK(w <= last);
        if (d < 40.f) CHECK(std::abs(w / std::exp(-d) - 1.03f) < 0.0325f);
        last = w;
    }
    CHECK(edge_weight(1e30f) < 1e-18f);
    CHECK(edge_weight(std::bit_cast<float>(0x7fc00000u)) < 1e-18f);
    CHECK(edge_weight(std::bit_cast<float>(0x7f800000u)) < 1e-18f);
}

TEST_CASE("a silhouette stops every filter with a depth edge") {
    Extent const size{32, 16};
    glm::vec3 const colour(1, 0.5f, 2);
    auto const two_planes = [&](auto& frame) {
        tests::fill_still(frame);
        tests::fill(frame[depth], [](int x, int) { return x < 16 ? 2.f : 10.f; });
        tests::fill(frame[radiance], [&](int x, int) { return x < 16 ? colour : glm::vec3(0); });
    };
    auto const sharp = [&](auto const& pipeline) {
        auto const out = filtered(pipeline, size, two_planes);
        for (std::size_t i = 0; i < out.size(); ++i)
            CHECK(std::abs(out[i] - (i / 3 % static_cast<std::size_t>(size.width) < 16 ? colour[static_cast<int>(i % 3)] : 0.f)) < 1e-4f);
    };
    sharp(Pipeline{radiance, Spatial{Atrous{DepthEdge{}, 4}}});
    sharp(Pipeline{radiance, Spatial{Bilateral{DepthEdge{}, 7}}});
    sharp(presets::svgf(radiance));
}

TEST_CASE("noise falls as the wavelet promises, and a step in the signal beyond the noise stays") {
    Extent const size{96, 64};
    constexpr auto denoise = presets::svgf(radiance);
    std::mt19937 random(2);
    std::normal_distribution<float> noise(0.f, 0.3f);
    Frame frame{size, denoise};
    History history{size, denoise};
    std::vector<float> out;
    for (int i = 0; i < 12; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(std::max(0.f, (x < 48 ? 2.f : 8.f) + noise(random))); });
        out = tests::copy_of(run(denoise, frame, history));
    }
    double squares = 0;
    int count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const wanted = x < 48 ? 2.f : 8.f, got = out[static_cast<std::size_t>((y * size.width + x) * 3)];
            if (x != 47 && x != 48) squares += (got - wanted) * (got - wanted), ++count;
            CHECK(std::abs(got - wanted) < 0.3f);
        }
    CHECK(std::sqrt(squares / count) < 0.3 / 10);
}

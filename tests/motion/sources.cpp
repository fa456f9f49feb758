#include "../frames.hpp"
#include "../views.hpp"

#include <baselines/presets.hpp>

using namespace quell;

namespace {
constexpr Extent size{40, 24};

/// A pattern without symmetry, smooth enough to interpolate.
float pattern(float x, float y) { return 2.f + std::sin(0.31f * x) + std::cos(0.23f * y + 0.1f * x); }

/// Shows the pattern once, then once more moved by `shift`, with a source that should follow it; returns what became of the history alone.
template <class M, class Fetch = Bilinear>
std::vector<float> follow(M const& motion_source, glm::vec2 shift, auto&& supply, Fetch fetch = {}, auto... options) {
    auto const pipeline = Pipeline{visibility, options..., Temporal{motion_source, Exponential{.alpha = 0.f}, fetch}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    tests::fill(frame[visibility], [](int x, int y) { return pattern(static_cast<float>(x), static_cast<float>(y)); });
    supply(frame, glm::vec2(0));
    run(pipeline, frame, history);
    tests::fill(frame[visibility], [](int, int) { return 0.f; });
    supply(frame, shift);
    return tests::copy_of(run(pipeline, frame, history));
}

/// The greatest error of a history that moved by `shift`, away from where the past ends.
double error_of(std::vector<float> const& out, glm::vec2 shift, int border = 4) {
    double worst = 0;
    for (int y = border; y < size.height - border; ++y)
        for (int x = border; x < size.width - border; ++x) {
            float const wanted = pattern(static_cast<float>(x) - shift.x, static_cast<float>(y) - shift.y);
            worst = std::max(worst, std::abs(static_cast<double>(out[static_cast<std::size_t>(y * size.width + x)]) - wanted));
        }
    return worst;
}

auto const by_motion_channel = [](auto& frame, glm::vec2 shift) { tests::fill(frame[motion], [&](int, int) { return -shift; }); };
} // namespace

TEST_CASE("nothing moves: every source is the identity, to the last bit") {
    auto const none = [](auto&, glm::vec2) {};
    auto const at_rest = [](std::vector<float> const& out) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                CHECK(out[static_cast<std::size_t>(y * size.width + x)] == pattern(static_cast<float>(x), static_cast<float>(y)));
    };
    at_rest(follow(StillMotion{}, {}, none));
    at_rest(follow(SurfaceMotion{}, {}, by_motion_channel));
    at_rest(follow(SurfaceMotion{AllOf{SameDepth{}, SameInstance{}}}, {}, by_motion_channel, CatmullRom{}));
    at_rest(follow(FirstValid{SurfaceMotion{}, StillMotion{}}, {}, by_motion_channel));
}

TEST_CASE("a surface that moves by whole pixels takes its history along exactly, rows and columns 0 too") {
    for (glm::vec2 const shift : {glm::vec2(3, -2), glm::vec2(-4, 1), glm::vec2(0, 4)}) {
        auto const out = follow(SurfaceMotion{}, shift, by_motion_channel);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                float const from_x = static_cast<float>(x) - shift.x, from_y = static_cast<float>(y) - shift.y;
                bool const seen =
                    from_x >= 0 && from_y >= 0 && from_x < static_cast<float>(size.width) && from_y < static_cast<float>(size.height);
                CHECK(out[static_cast<std::size_t>(y * size.width + x)] ==
                      doctest::Approx(seen ? pattern(from_x, from_y) : 0).epsilon(1e-5));
            }
    }
}

TEST_CASE("between pixels, Catmull-Rom is closer to the truth than bilinear") {
    glm::vec2 const shift(1.37f, -0.61f);
    double const bilinear = error_of(follow(SurfaceMotion{}, shift, by_motion_channel), shift);
    double const spline = error_of(follow(SurfaceMotion{}, shift, by_motion_channel, CatmullRom{}), shift);
    CHECK(bilinear < 0.03);
    CHECK(spline < 0.25 * bilinear);
}

TEST_CASE("every convention of motion vectors means the same") {
    using C = MotionConvention;
    glm::vec2 const shift(2.25f, -1.5f);
    auto const wanted = follow(SurfaceMotion{}, shift, by_motion_channel);
    auto const same = [&](auto supplied, glm::vec2 factor) {
        auto const out = follow(
            SurfaceMotion{}, shift, [&](auto& frame, glm::vec2 s) { tests::fill(frame[motion], [&](int, int) { return -s * factor; }); },
            Bilinear{}, supplied);
        CHECK(tests::difference(wanted, out) < 1e-4);
    };
    glm::vec2 const uv(1.f / static_cast<float>(size.width), 1.f / static_cast<float>(size.height));
    same(Supplied<C{}>{}, {1, 1});
    same(Supplied<C{.points = C::Points::from_previous}>{}, {-1, -1});
    same(Supplied<C{.y = C::Y::up}>{}, {1, -1});
    same(Supplied<C{.unit = C::Unit::uv}>{}, uv);
    same(Supplied<C{.points = C::Points::from_previous, .unit = C::Unit::ndc, .y = C::Y::up}>{}, glm::vec2(-2, 2) * uv);
}

TEST_CASE("a preset takes vectors of another convention, what it remembers of them too") {
    // Something slides before a wall, which dual_color follows by the motion of what was there, as it was then.
    auto const shown = [](auto const& denoise, glm::vec2 factor) {
        Frame frame{size, denoise};
        History history{size, denoise};
        std::vector<float> last;
        for (int i = 0; i < 6; ++i) {
            auto const before = [&](int x) { return x >= 8 + 4 * i && x < 20 + 4 * i; };
            tests::fill_still(frame);
            tests::fill(frame[depth], [&](int x, int) { return before(x) ? 2.f : 4.f; });
            tests::fill(frame[motion], [&](int x, int) { return before(x) ? glm::vec2(-4.f, 0.f) * factor : glm::vec2(0.f); });
            tests::fill(frame[radiance],
                        [&](int x, int y) { return glm::vec3(pattern(static_cast<float>(x * i), static_cast<float>(y))); });
            last = tests::copy_of(run(denoise, frame, history));
        }
        return last;
    };
    using C = MotionConvention;
    constexpr Supplied<C{.points = C::Points::from_previous, .unit = C::Unit::ndc}> supplied;
    glm::vec2 const factor(-2.f / static_cast<float>(size.width), -2.f / static_cast<float>(size.height));
    CHECK(tests::difference(shown(presets::dual_color(radiance), {1, 1}), shown(presets::dual_color(radiance, supplied), factor)) < 1e-4);
}

TEST_CASE("jitter left in the vectors is taken out") {
    // The camera is still; only the sample's offset changed, and the host's vectors carry that change.
    constexpr auto pipeline = Pipeline{visibility, Supplied<MotionConvention{.jitter = MotionConvention::Jitter::left_in}>{},
                                       Temporal{SurfaceMotion{}, Exponential{.alpha = 1e-6f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    tests::fill(frame[visibility], [](int x, int y) { return pattern(static_cast<float>(x), static_cast<float>(y)); });
    frame.camera.jitter = {0.25f, -0.375f};
    run(pipeline, frame, history);
    glm::vec2 const jitter_then = frame.camera.jitter, jitter_now(-0.125f, 0.25f);
    frame.camera.jitter = jitter_now;
    tests::fill(frame[motion], [&](int, int) { return jitter_now - jitter_then; });
    auto const out = run(pipeline, frame, history);
    CHECK(out.get(0, 11, 7) == doctest::Approx(pattern(11, 7)).epsilon(1e-5));
}

TEST_CASE("previous positions and the previous camera lead where the motion channel leads") {
    glm::vec2 const shift(1.75f, -2.5f);
    auto const by_position = [](auto& frame, glm::vec2 s) {
        frame.camera = tests::View({0, 0, 4}, {0, 0, 0}, size).camera();
        PixelRays const rays(frame.camera, size);
        tests::fill(frame[receiver_previous], [&](int x, int y) {
            return rays.position(glm::vec2(static_cast<float>(x) + 0.5f - s.x, static_cast<float>(y) + 0.5f - s.y), 4.f);
        });
    };
    CHECK(tests::difference(follow(SurfaceMotion{}, shift, by_motion_channel), follow(PositionMotion{}, shift, by_position)) < 1e-3);
}

TEST_CASE("history stops where the surface is another") {
    auto const rejected = [](auto source, auto&& change) {
        auto const out = follow(source, glm::vec2(1, 0), [&](auto& frame, glm::vec2 s) {
            by_motion_channel(frame, s);
            if (s.x > 0) change(frame);
        });
        for (float const a : out) CHECK(std::abs(a) < 1e-4f);
    };
    rejected(SurfaceMotion{}, [](auto& frame) { tests::fill(frame[depth], [](int, int) { return 6.f; }); });
    rejected(SurfaceMotion{}, [](auto& frame) { tests::fill(frame[normal], [](int, int) { return glm::vec3(1, 0, 0); }); });
    rejected(SurfaceMotion{SameInstance{}}, [](auto& frame) { tests::fill(frame[instance], [](int, int) { return 7.f; }); });
    rejected(SurfaceMotion{}, [](auto& frame) { tests::fill(frame[depth], [](int, int) { return std::bit_cast<float>(0x7f800000u); }); });
    rejected(SurfaceMotion{},
             [](auto& frame) { tests::fill(frame[motion], [](int, int) { return glm::vec2(std::bit_cast<float>(0x7fc00000u)); }); });
    rejected(SurfaceMotion{}, [](auto& frame) { tests::fill(frame[motion], [](int, int) { return glm::vec2(1e9f, -1e9f); }); });
}

TEST_CASE("a miss finds the history of a miss") {
    float const miss = std::bit_cast<float>(0x7f800000u);
    auto const out = follow(SurfaceMotion{SameDepth{}}, glm::vec2(2, 0), [&](auto& frame, glm::vec2 s) {
        by_motion_channel(frame, s);
        tests::fill(frame[depth], [&](int, int) { return miss; });
    });
    CHECK(error_of(out, {2, 0}) < 1e-4);
}

TEST_CASE("a steep plane keeps its history between pixels") {
    auto const out = follow(SurfaceMotion{SameDepth{.tolerance = 0.01f}}, glm::vec2(0.5f, 0.5f), [&](auto& frame, glm::vec2 s) {
        by_motion_channel(frame, s);
        tests::fill(frame[depth],
                    [&](int x, int y) { return 4.f + 0.7f * (static_cast<float>(x) - s.x) + 0.4f * (static_cast<float>(y) - s.y); });
    });
    CHECK(error_of(out, {0.5f, 0.5f}) < 0.05);
}

TEST_CASE("the far tap of a steep plane counts too, whichever way it is steep") {
    for (glm::vec2 const along : {glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(-1, 0), glm::vec2(0, -1)}) {
        auto const shift = 0.25f * along;
        auto const out = follow(SurfaceMotion{SameDepth{.tolerance = 0.001f}}, shift, [&](auto& frame, glm::vec2 s) {
            by_motion_channel(frame, s);
            tests::fill(frame[depth], [&](int x, int y) {
                return 40.f + 0.7f * (along.x * (static_cast<float>(x) - s.x) + along.y * (static_cast<float>(y) - s.y));
            });
        });
        CHECK(error_of(out, shift) < 0.02);
    }
}

TEST_CASE("taps on another surface do not bleed in, and a lone good neighbour is found") {
    constexpr auto pipeline = Pipeline{visibility, Temporal{SurfaceMotion{SameInstance{}}, Exponential{.alpha = 1e-6f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    tests::fill(frame[instance], [](int x, int) { return x < 20 ? 1.f : 2.f; });
    tests::fill(frame[visibility], [](int x, int) { return x < 20 ? 1.f : 5.f; });
    run(pipeline, frame, history);
    // Half a pixel to the left: column 20 now lies between an old 1 and an old 2.
    tests::fill(frame[motion], [](int, int) { return glm::vec2(-0.5f, 0); });
    tests::fill(frame[visibility], [](int, int) { return 0.f; });
    auto out = run(pipeline, frame, history);
    CHECK(out.get(0, 20, 5) == doctest::Approx(5).epsilon(1e-5));
    CHECK(out.get(0, 19, 5) == doctest::Approx(1).epsilon(1e-5));
    // Whole pixels off: the position itself shows the wrong object, one beside it the right one.
    tests::fill(frame[visibility], [](int x, int) { return x < 20 ? 1.f : 5.f; });
    tests::fill(frame[motion], [](int, int) { return glm::vec2(0); });
    history.forget();
    run(pipeline, frame, history);
    tests::fill(frame[motion], [](int, int) { return glm::vec2(-1, 0); });
    tests::fill(frame[visibility], [](int, int) { return 0.f; });
    out = run(pipeline, frame, history);
    CHECK(out.get(0, 20, 5) == doctest::Approx(5).epsilon(1e-5));
}

TEST_CASE("at a border only what is in the image is searched for a good neighbour") {
    constexpr auto pipeline = Pipeline{visibility, Temporal{SurfaceMotion{SameInstance{}}, Exponential{.alpha = 1e-6f}}};
    int const right = size.width - 1, bottom = size.height - 1;
    for (glm::ivec2 const at : {glm::ivec2(20, bottom), glm::ivec2(20, 0), glm::ivec2(0, 12), glm::ivec2(right, 12)}) {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        tests::fill_still(frame);
        // The pixel itself was another object; of its five neighbours in the image the two on the border were dark.
        tests::fill(frame[instance], [&](int x, int y) { return glm::ivec2(x, y) == at ? 2.f : 1.f; });
        tests::fill(frame[visibility], [&](int x, int y) { return x == 0 || y == 0 || x == right || y == bottom ? 0.f : 5.f; });
        run(pipeline, frame, history);
        tests::fill(frame[instance], [](int, int) { return 1.f; });
        tests::fill(frame[visibility], [](int, int) { return 0.f; });
        CHECK(run(pipeline, frame, history).get(0, at.x, at.y) == doctest::Approx(3).epsilon(1e-5));
    }
}

namespace {
struct Never {
    QUELL_KERNEL auto previous(auto px) const { return Reprojection{px.position(), typename decltype(px)::Real(0.f)}; }
};
} // namespace

TEST_CASE("FirstValid asks in order") {
    glm::vec2 const shift(2, 1);
    auto const wanted = follow(SurfaceMotion{}, shift, by_motion_channel);
    CHECK(tests::difference(wanted, follow(FirstValid{Never{}, SurfaceMotion{}}, shift, by_motion_channel)) == 0);
    CHECK(tests::difference(wanted, follow(FirstValid{SurfaceMotion{}, Never{}}, shift, by_motion_channel)) == 0);
    // Where the surface's history is outside the image, the next source is asked.
    CHECK(tests::difference(wanted, follow(FirstValid{SurfaceMotion{}, StillMotion{}}, shift, by_motion_channel)) > 0);
    CHECK(tests::difference(wanted, follow(FirstValid{Never{}, Never{}, SurfaceMotion{}}, shift, by_motion_channel)) == 0);
}

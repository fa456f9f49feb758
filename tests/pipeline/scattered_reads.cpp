#include "../frames.hpp"

#include <quell/pipeline/plan.hpp>

#include <cmath>

using namespace quell;

// Pixels that a pack reads at places of its own, against those that one pixel after the other reads there.
namespace {
constexpr Extent sizes[] = {{160, 40}, {37, 21}, {9, 3}, {1, 1}};
/// Turned, magnified and moved: places side by side, in one or two rows, further apart, backwards, outside the image.
constexpr float angles[] = {0.f, 0.02f, 0.3f, 1.5f, 3.1f}, scales[] = {0.f, 0.5f, 1.f, 1.1f, 1.9f, 2.5f};

struct Moved {
    float cosine, sine, columns, rows;
    template <class Real> QUELL_KERNEL vec2<Real> operator()(vec2<Real> const& p) const {
        return {p.x * cosine - p.y * sine + columns, p.x * sine + p.y * cosine + rows};
    }
};
struct MovedSignal {
    Moved moved;
    QUELL_KERNEL auto filter(auto px) const {
        auto const place = nearest_place(px, moved(px.position()));
        return px.signal_elsewhere(place).first;
    }
};
struct MovedHistory {
    Moved moved;
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Reprojection<Real>{moved(px.position()), Real(1.f)};
    }
};

template <class Make> void same_in_packs(Make&& make) {
    for (auto const size : sizes)
        for (float const angle : angles)
            for (float const scale : scales) {
                CAPTURE(size.width);
                CAPTURE(angle);
                CAPTURE(scale);
                auto const pipeline = make(Moved{scale * std::cos(angle), scale * std::sin(angle), angle > 1.f ? 100.3f : -3.3f, 2.2f});
                // Places are rounded, by 1e-5 of a pixel. Another pixel is .1 off.
                CHECK(tests::difference(tests::sequence(pipeline, size, Serial{}), tests::sequence(pipeline, size, Simd{})) < 1e-3);
            }
}
} // namespace

TEST_CASE("a pack reads at any places of this frame what single pixels read there") {
    same_in_packs([](Moved const& moved) { return Pipeline{radiance, Spatial{MovedSignal{moved}}}; });
}

TEST_CASE("a pack reads at any places of the previous frame what single pixels read there") {
    same_in_packs([](Moved const& moved) { return Pipeline{radiance, Temporal{MovedHistory{moved}, Exponential{.alpha = 0.1f}}}; });
    same_in_packs([](Moved const& moved) {
        return Pipeline{radiance, Temporal{MovedHistory{moved}, Exponential{.alpha = 0.1f}, CatmullRom{}}};
    });
}

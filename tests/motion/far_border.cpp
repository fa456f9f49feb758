#include "../frames.hpp"

#include <quell/execute/threads.hpp>

using namespace quell;

namespace {
/// Rows that end where a pack ends: what lies behind them in memory is no pixel.
constexpr Extent size{3 * width_of<Pack>, 12};

/// A wall, all of whose history was found half a pixel nearer to the bottom right corner: in the last column, on the border itself.
template <class P> std::vector<float> moved(P const& denoise, auto const& executor) {
    Frame frame{size, denoise};
    History history{size, denoise};
    frame.camera.projection = glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2f, 0);
    PixelRays const rays(frame.camera, size);
    std::vector<float> out;
    for (unsigned i = 0; i < 4; ++i) {
        tests::fill_randomly(frame, i);
        for_each_channel(typename decltype(frame)::channels{}, [&]<class C>(C c) {
            tests::fill(frame[c], [&](int x, int y) {
                if constexpr (std::is_same_v<C, Depth>)
                    return 5.f;
                else if constexpr (std::is_same_v<C, Motion>)
                    return glm::vec2(0.5f);
                else if constexpr (std::is_same_v<C, Position> || std::is_same_v<C, ReceiverPrevious>)
                    return rays.position(glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f), 5.f);
                else if constexpr (std::is_same_v<C, Normal>)
                    return glm::vec3(0, 0, 1);
                else
                    return frame[c].get(x, y);
            });
        });
        out = tests::copy_of(run(denoise, frame, history, executor));
    }
    return out;
}
} // namespace

TEST_CASE_TEMPLATE("history on the image's very border is the last pixel's: no image depends on packs or tiles", Blend,
                   Temporal<SurfaceMotion<>, WithCones<RunningMean>, ConeFetch>, Temporal<SurfaceMotion<>, NonPlanarFalloff<Exponential>>,
                   Temporal<SurfaceMotion<>, Exponential, Nearest>) {
    constexpr auto denoise = Pipeline{indirect, Blend{}};
    auto const simd = moved(denoise, Simd{});
    CHECK(tests::difference(moved(denoise, Serial{}), simd) < 2e-5);
    for (Extent const tile : {Extent{5, 3}, Extent{16, 2}}) CHECK(moved(denoise, Threads<>{.count = 2, .tile = tile}) == simd);
}

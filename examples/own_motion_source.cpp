// A motion source of your own: history along the wind. Everything it needs to be is here.
#include <quell/quell.hpp>

#include <cstdio>

/// Follows something that drifts over the screen at an even speed, such as a projected pattern or rain.
struct Drift {
    using reads = quell::Channels<quell::Depth>;     // what the host must supply
    using remembers = quell::Channels<quell::Depth>; // what is kept of the last frame
    float x = 0.f, y = 0.f;                          ///< pixels a frame
    float tolerance = 0.1f;                          ///< allowed change of depth, as a part of it

    /// A place, how far to trust it, and what a past pixel must show to count.
    template <class Real> struct Found {
        quell::vec2<Real> where;
        Real validity, z, allowed;
        QUELL_KERNEL auto accepts(auto const& then, Real, Real) const { return quell::abs(then[quell::depth] - z) < allowed; }
    };
    QUELL_KERNEL auto previous(auto px) const {
        auto const p = px.position();
        auto const z = px[quell::depth];
        using Real = typename decltype(px)::Real;
        return Found<Real>{{p.x - x, p.y - y}, Real(1.f), z, z * tolerance};
    }
};

int main() {
    using namespace quell;
    constexpr auto denoise = Pipeline{radiance, Temporal{Drift{.x = 1.f}, RunningMean{}}};
    Extent const size{64, 32};
    Frame frame{size, denoise};
    History history{size, denoise};
    for (int i = 0; i < 4; ++i) {
        // A bright dot that moves by a pixel a frame keeps its history.
        frame[radiance].set(9 + i, 10, {0.f, 0.f, 0.f});
        frame[radiance].set(10 + i, 10, {1.f, 1.f, 1.f});
        std::printf("%.2f\n", run(denoise, frame, history).get(0, 10 + i, 10));
    }
}

// A filter of your own that works at half the width and height, a quarter of the pixels: light is averaged down, blurred there, and
// interpolated back up.
#include <quell/pipeline/plan.hpp>
#include <quell/quell.hpp>

#include <cstdio>

/// A channel whose image is half as wide and high as the frame.
struct HalfLight : quell::InternalChannel<3> {
    static constexpr auto name = "half_light";
    static constexpr int fraction = 2;
};

struct Down {
    static constexpr auto name = "down";
    static constexpr int fraction = 2; // where this pass runs
    using emits = quell::Channels<HalfLight>;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = px.finer_signal(0, 0);
        for (auto const& [i, j] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}})
            sum = quell::add_scaled(sum, px.finer_signal(i, j), Real(1.f));
        return quell::emitted<Real>(HalfLight{}, quell::scale(sum, Real(0.25f)));
    }
};

struct Blur {
    static constexpr auto name = "blur";
    static constexpr int fraction = 2;
    using reads = quell::Channels<HalfLight>;
    using emits = quell::Channels<HalfLight>;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto sum = quell::zero<quell::vec3<Real>>();
        Real weights(0.f);
        quell::for_each_tap<2>(px, 1, {6.f, 4.f, 1.f}, [&](auto const& near, auto w, int, int) QUELL_INLINED {
            sum = quell::add_scaled(sum, near[HalfLight{}], w);
            weights = weights + w;
        });
        return quell::emitted<Real>(HalfLight{}, quell::scale(sum, 1.f / weights));
    }
};

struct Up {
    static constexpr auto name = "up";
    using reads = quell::Channels<HalfLight>;
    QUELL_KERNEL auto filter(auto px) const { return px.coarser_interpolated(HalfLight{}); }
};

struct PyramidBlur {
    using parts = quell::Parts<Down, Blur, Up>;
    constexpr void for_each_pass(auto&& pass) const { pass(Down{}), pass(Blur{}), pass(Up{}); }
};

int main() {
    constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Spatial{PyramidBlur{}}};
    quell::Frame frame{quell::Extent{65, 33}, denoise};
    quell::History history{frame.size, denoise};
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 65; ++x) frame[quell::radiance].set(x, y, glm::vec3(1.f + static_cast<float>((x + y) % 2)));
    std::printf("%.2f\n%s", run(denoise, frame, history).get(0, 32, 16), to_string(plan_of(denoise)).c_str());
}

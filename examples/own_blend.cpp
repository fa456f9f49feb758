// A blend policy of your own: the median of the last two values and the new one, which one outlier can't move.
#include <quell/quell.hpp>

#include <cstdio>

/// A channel that the policy keeps from frame to frame; the history gets an image for it.
struct BeforeLast : quell::Channel<3> {
    static constexpr auto name = "before_last";
};

struct MedianOfThree {
    using keeps = quell::Channels<BeforeLast>;

    QUELL_KERNEL auto blend(auto px, auto past) const {
        using Real = typename decltype(px)::Real;
        auto const now = px.signal();
        auto const middle = quell::map([](auto a, auto b, auto c) { return quell::max(quell::min(a, b), quell::min(quell::max(a, b), c)); },
                                       now, past.signal, past[BeforeLast{}]);
        auto const known = past.validity > Real(0.f);
        return quell::Result{quell::select(known, middle, now)}.with(BeforeLast{}, quell::select(known, past.signal, now));
    }
};

int main() {
    using namespace quell;
    constexpr auto denoise = Pipeline{radiance, Temporal{StillMotion{}, MedianOfThree{}}};
    Extent const size{64, 32};
    Frame frame{size, denoise};
    History history{size, denoise};
    for (float const light : {1.f, 1.f, 1000.f, 1.f}) {
        frame[radiance].set(10, 10, {light, light, light});
        std::printf("%.2f\n", run(denoise, frame, history).get(0, 10, 10));
    }
}

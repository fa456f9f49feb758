// error: a policy looks at the previous frame's channel that it does not list: add it to `remembers` or `keeps`
#include <quell/quell.hpp>

// SurfaceMotion remembers depth; that is no reason for this one to look at it.
struct SameDistance {
    using reads = quell::Channels<quell::Depth>;
#ifdef CORRECT
    using remembers = quell::Channels<quell::Depth>;
#endif
    template <class Real> struct Distance {
        quell::vec2<Real> where;
        Real validity, z;
        QUELL_KERNEL auto accepts(auto then, Real, Real) const { return then[quell::depth] == z; }
    };
    QUELL_KERNEL auto previous(auto px) const {
        using Real = typename decltype(px)::Real;
        return Distance<Real>{px.position(), Real(1.f), px[quell::depth]};
    }
};

constexpr quell::FirstValid sources{quell::SurfaceMotion{}, SameDistance{}};
constexpr auto denoise = quell::Pipeline{quell::radiance, quell::Temporal{sources, quell::Exponential{}}};

// error: `reads` of a policy must be `using reads = Channels<...>`
// error: `parts` of a policy must be `using parts = Parts<...>`
// error: `fraction` of a policy must be a `static constexpr int`
// error: `needs_camera` of a policy must be a `static constexpr bool`
// error: `farthest_tap` of a policy must be a `static constexpr int` or `constexpr int farthest_tap() const`
// error: `feedback` of a policy must be `constexpr bool feedback() const`
// error: `memory` of a policy must be `constexpr BlendMemory memory() const`
// error: `owns_memory` of a storage must be `static constexpr bool`
// error: a channel must derive from Channel<N> or InternalChannel<N>
// error: `accepts` of what previous(px) returns must be a function accepts(auto const& then, Real dx, Real dy) const
// error: `offset` of what around(px) of an edge weight returns must be a function float offset() const
// error: `toward` of what around(px) of an edge weight returns must be a function toward(int dx, int dy) const
// error: `clip` of a Gatherer must be a function V clip(V const& past) const
// error: `in_memory` of a channel must be `static auto in_memory(auto const& value)`
// error: `interpolated` of a channel must be `static auto interpolated(auto const& stored, auto const& signal)`
// error: Spatial{kernel}: `kernel` must have one of filter(px), emit_channels(px) and for_each_pass(pass), not several
// error: Spatial{kernel}: a kernel with filter(px) makes the signal: it cannot say `leaves_signal`
#include <quell/quell.hpp>

// Members of the names that quell looks for, of a kind that it does not read.
#ifdef CORRECT
#define KIND(right, wrong) right
#else
#define KIND(right, wrong) wrong
#endif
using namespace quell;

struct Base {
    QUELL_KERNEL auto filter(auto px) const { return px.signal(); }
};
struct Reads : Base {
    using reads = KIND(Channels<Depth>, Depth);
};
struct PartsOf : Base {
    using parts = KIND(Parts<DepthEdge>, DepthEdge);
};
struct Fraction {
    KIND(static constexpr int, static constexpr float) fraction = 2;
    QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(variance, px.columns()); }
};
struct NeedsCamera : Base {
    KIND(static constexpr bool, static inline bool) needs_camera = true;
};
struct Feedback : Base {
    constexpr KIND(bool, float) feedback() const { return true; }
};
struct FarthestTap : Base {
    constexpr KIND(int, float) farthest_tap() const { return 1; }
};
struct Memory {
    KIND(
        constexpr BlendMemory memory() const { return {}; }, float memory = 4.f;)
    QUELL_KERNEL auto blend(auto px, auto) const { return px.signal(); }
};
struct Both : Base {
    KIND(
        , QUELL_KERNEL auto emit_channels(auto px) const { return emitted<typename decltype(px)::Real>(variance, px.columns()); })
};
struct Leaves : Base {
    static constexpr bool leaves_signal = KIND(false, true);
};
struct Storage : Planar<> {
    KIND(static constexpr, ) bool owns_memory = true;
};
struct Derived : KIND(Channel<1>, ) KIND(, Channels<>) {
    KIND(, static constexpr int components = 1;)
    static constexpr auto name = "derived";
};

constexpr Spatial reads{Reads{}};
constexpr Spatial parts{PartsOf{}};
constexpr Spatial fraction{Fraction{}};
constexpr Spatial camera{NeedsCamera{}};
constexpr Spatial feedback{Feedback{}};
constexpr Spatial farthest_tap{FarthestTap{}};
constexpr Temporal memory{StillMotion{}, Memory{}};
constexpr Spatial both{Both{}};
constexpr Spatial leaves{Leaves{}};
constexpr bool owned = owns_memory<Storage>();
constexpr int size_of_set = Channels<Derived>::size;

// What kernels call where there is one.
struct Source {
    template <class Real> struct Found {
        vec2<Real> where;
        Real validity;
        KIND(
            QUELL_KERNEL auto accepts(auto const&, Real dx, Real) const { return dx < Real(1.f); }, float accepts = 1.f;)
    };
    QUELL_KERNEL auto previous(auto px) const { return Found<typename decltype(px)::Real>{px.position(), 1.f}; }
};
struct Edge {
    template <class Real> struct Around {
        KIND(
            float offset() const { return 0.f; }, Real offset = 0.f;)
        QUELL_KERNEL Real distance(auto, Real sum) const { return sum; }
    };
    QUELL_KERNEL auto around(auto px) const { return Around<typename decltype(px)::Real>{}; }
};
struct EdgeByOffset {
    template <class Real> struct Around {
        KIND(
            Around toward(int, int) const { return *this; }, auto toward(int) const { return *this; })
        QUELL_KERNEL Real distance(auto, Real sum) const { return sum; }
    };
    QUELL_KERNEL auto around(auto px) const { return Around<typename decltype(px)::Real>{}; }
};
struct Range {
    template <class V> struct Gatherer : MinMax::Gatherer<V> {
        using MinMax::Gatherer<V>::Gatherer;
        KIND(
            V clip(V const& past) const { return past; }, V clip = {};)
        QUELL_KERNEL void finish(Range) {}
    };
};
struct Stored : InternalChannel<1> {
    static constexpr auto name = "stored";
    KIND(
        static auto in_memory(auto const& value) { return value; }, static constexpr bool in_memory = true;)
};
struct Fetched : InternalChannel<1> {
    static constexpr auto name = "fetched";
    KIND(
        static auto interpolated(auto const& stored, auto const&) { return stored; },
        static auto interpolated(int stored) { return stored; })
};
template <class C> struct Keeping {
    using keeps = Channels<C>;
    QUELL_KERNEL auto blend(auto px, auto past) const { return Result{px.signal()}.with(C{}, past[C{}]); }
};
constexpr StillMotion still;
constexpr RunningMean mean;
void run_all(Extent size, auto const&... pipelines) {
    auto const run_one = [&](auto const& pipeline) {
        Frame frame{size, pipeline};
        History history{size, pipeline};
        run(pipeline, frame, history, Serial{});
    };
    (run_one(pipelines), ...);
}
void run_them(Extent size) {
    run_all(size, Pipeline{radiance, Temporal{Source{}, mean}}, Pipeline{radiance, Spatial{Atrous{Edge{}}}},
            Pipeline{radiance, Spatial{Atrous{EdgeByOffset{}}}}, Pipeline{radiance, Temporal{still, Clamped{mean, Range{}}}},
            Pipeline{radiance, Temporal{still, Keeping<Stored>{}}}, Pipeline{radiance, Temporal{still, Keeping<Fetched>{}}});
}

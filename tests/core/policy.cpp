#include <quell/quell.hpp>

using namespace quell;

// What a combinator declares is what it adds and what its parts declare, whatever its members are called.
namespace {
struct UsesCamera {
    using reads = Channels<Roughness>;
    static constexpr bool needs_camera = true;
};
struct KeepsLength {
    using reads = Channels<Depth>;
    using remembers = Channels<Normal>;
    using keeps = Channels<HistoryLength>;
    using emits = Channels<Variance>;
};
template <class Inner> struct Wrapper {
    using parts = Parts<Inner>;
    using reads = Channels<Albedo>;
    Inner child;
};
struct UsesCameraToo {
    static constexpr bool needs_camera = true;
};
} // namespace

static_assert(std::is_same_v<reads_of<Wrapper<KeepsLength>>, Channels<Albedo, Depth>>);
static_assert(std::is_same_v<remembers_of<Wrapper<Wrapper<KeepsLength>>>, Channels<Normal>>);
static_assert(std::is_same_v<keeps_of<Wrapper<KeepsLength>>, Channels<HistoryLength>>);
static_assert(std::is_same_v<emits_of<Wrapper<KeepsLength>>, Channels<Variance>>);
static_assert(needs_camera_of<Wrapper<UsesCamera>> && !needs_camera_of<Wrapper<KeepsLength>>);
static_assert(needs_camera_of<AllOf<UsesCamera, UsesCameraToo>> && !needs_camera_of<AllOf<SameDepth, SameNormal>>);
static_assert(reads_of<Parts<>>::size == 0 && reads_of<>::size == 0);

// Members of a policy may have any names, those of declarations too.
namespace {
struct NumberNamedFraction {
    float fraction = 0.5f;
};
struct Quarter {
    static constexpr int fraction = 4;
};
} // namespace
static_assert(fraction_of<NumberNamedFraction> == 1);
static_assert(fraction_of<Quarter> == 4);

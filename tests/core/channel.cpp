#include <doctest/doctest.h>
#include <quell/quell.hpp>

using namespace quell;

// The algebra of channel sets decides what exists at all, so its tests are static.
static_assert(std::is_same_v<decltype(Channels<Depth>{} | Channels<Normal, Depth>{}), Channels<Depth, Normal>>);
static_assert(std::is_same_v<common_to<Channels<Depth, Normal>, Channels<Normal>>, Channels<Normal>>);
static_assert(std::is_same_v<without<Channels<Depth, Normal>, Channels<Normal>>, Channels<Depth>>);
static_assert(contained_in<Channels<Depth>, Channels<Normal, Depth>>);
static_assert(!contained_in<Channels<Depth, Motion>, Channels<Normal, Depth>>);

// Names in files: a letter for each component, or the whole name of the only one.
namespace of_files {
struct Pair : Channel<2> {
    static constexpr auto name = "pair";
    static constexpr auto component_names = "X";
};
struct Unnamed : Channel<1> {
    static constexpr auto name = "unnamed";
    static constexpr auto component_names = "";
};
struct Numbered : Channel<5> {
    static constexpr auto name = "numbered";
};
} // namespace of_files
using namespace of_files;
static_assert(Radiance::component_names == "RGB" && Instance::component_names == "ID" && Visibility::component_names == "V");
static_assert(detail::SaysRightly<Instance> && detail::SaysRightly<Numbered> && !detail::SaysRightly<Pair> &&
              !detail::SaysRightly<Unnamed>);

namespace {
constexpr auto still = Pipeline{radiance, Temporal{StillMotion{}, Exponential{}}};
constexpr auto bare_surface = Pipeline{visibility, Temporal{SurfaceMotion{SameDepth{}}, RunningMean{}}};
constexpr auto full = presets::svgf(radiance, Demodulate{});
using Still = std::remove_const_t<decltype(still)>;
using BareSurface = std::remove_const_t<decltype(bare_surface)>;
using Full = std::remove_const_t<decltype(full)>;
} // namespace

// What is not composed is neither read, remembered nor kept.
static_assert(std::is_same_v<Still::reads, Channels<Radiance>>);
static_assert(Still::remembers::size == 0 && Still::keeps::size == 0);
static_assert(std::is_same_v<BareSurface::reads, Channels<Visibility, Motion, Depth>>);
static_assert(std::is_same_v<BareSurface::remembers, Channels<Depth>>);
static_assert(std::is_same_v<BareSurface::keeps, Channels<HistoryLength>>);
static_assert(Full::reads::size == 5 && Full::reads::has<Albedo> && Full::reads::has<Motion> && !Full::reads::has<Position>);
static_assert(Full::keeps::size == 3 && contained_in<Full::keeps, Channels<HistoryLength, LuminanceMean, LuminanceVariance>>);
static_assert(sizeof(Frame<Channels<Depth>>) < sizeof(Frame<Channels<Depth, Normal>>));

TEST_CASE("memory follows from what is composed") {
    Extent const size{1920, 64};
    auto const bytes = [&](auto const& pipeline, auto storage) {
        Frame frame{size, pipeline};
        // Impossible guides would be copied.
        if constexpr (requires { frame[depth]; })
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) frame[depth].set(x, y, 1.f);
        History history{size, pipeline, storage};
        run(pipeline, frame, history);
        run(pipeline, frame, history);
        return history.bytes_per_pixel();
    };
    CHECK(bytes(still, Planar<>{}) < bytes(full, Planar<>{}));
    CHECK(bytes(full, Planar<>{}) <= 72);
    CHECK(bytes(full, Planar<Float16>{}) <= 40);
    // The input copy and the output, three floats each, and nothing else.
    CHECK(bytes(presets::none(radiance), Planar<>{}) <= 24.3);
}

TEST_CASE("remembered normals are right to 0.01 degrees and unit length") {
    for (float a = 0; a < 6.2831f; a += 0.03f)
        for (float z = -1; z <= 1; z += 0.05f) {
            float const r = std::sqrt(std::max(0.f, 1 - z * z));
            vec3<float> const n(r * std::cos(a), r * std::sin(a), z);
            using Word = detail::Remembered<Normal>;
            auto const back = Word::unpack(Word::pack(n));
            CHECK(dot(back, back) == doctest::Approx(1).epsilon(1e-5));
            auto const apart = vec3<float>(back.x - n.x, back.y - n.y, back.z - n.z);
            CHECK(std::sqrt(dot(apart, apart)) < 1.7e-4f);
        }
}

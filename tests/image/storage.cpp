#include "../frames.hpp"

using namespace quell;

namespace {
/// The least that a storage must be able to do.
struct Minimal {
    using Exact = Minimal;
    template <int N> struct Image {
        std::vector<float> memory;
        Extent extent;
        explicit Image(Extent size = {}) : memory(static_cast<std::size_t>(size.pixels() * N)), extent(size) {}
        [[nodiscard]] Extent size() const { return extent; }
        [[nodiscard]] std::size_t bytes() const { return memory.size() * sizeof(float); }
        struct View {
            static constexpr int components = N;
            float* data = nullptr;
            Extent size;
            [[nodiscard]] float get(int c, int x, int y) const { return data[(c * size.height + y) * size.width + x]; }
            void set(int c, int x, int y, float a) const { data[(c * size.height + y) * size.width + x] = a; }
        };
        [[nodiscard]] View view() const { return {const_cast<float*>(memory.data()), extent}; }
    };
};
static_assert(ImageStorage<Planar<>> && ImageStorage<Planar<Float16>> && ImageStorage<Interleaved<>> && ImageStorage<Minimal>);
static_assert(ImageView<Borrowed<>::Image<3>::View>);
static_assert(std::is_trivially_copyable_v<ViewOf<Planar<>, Radiance>>);

template <class Storage> void round_trip() {
    constexpr int width = width_of<Pack>;
    for (int w = 1; w <= 3 * width + 1; ++w) {
        typename Storage::template Image<3> image(Extent{w, 3});
        auto const view = image.view();
        auto const value = [](int c, int x, int y) { return static_cast<float>(c * 100 + y * 37 + x); };
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < w; x += width) {
                int const count = std::min(width, w - x);
                auto const first = lanes<Pack>() + static_cast<float>(x + y * 37);
                detail::store_pixels<Pack>(view, x, y, vec3<Pack>(first, first + 100.f, first + 200.f), count);
            }
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < w; ++x)
                for (int c = 0; c < 3; ++c) CHECK(view.get(c, x, y) == value(c, x, y));
        for (int y = 0; y < 3; ++y)
            for (int x = -width; x <= w; ++x) {
                auto const loaded = detail::load_pixels<Pack>(view, x, y);
                for (int i = 0; i < width; ++i) {
                    CHECK(is_finite(lane(loaded.y, i)));
                    if (x + i >= 0 && x + i < w) CHECK(lane(loaded.y, i) == value(1, x + i, y));
                }
            }
        auto const column = truncate(lanes<Pack>()) - truncate(lanes<Pack>()) + (w - 1);
        CHECK(lane(detail::gather_pixels<Pack>(view, column, column - column + 2).z, 0) == value(2, w - 1, 2));
    }
}
} // namespace

TEST_CASE_TEMPLATE("what is stored is what is loaded, at any width and offset", Storage, Planar<>, Planar<Float16>, Interleaved<>,
                   Interleaved<Float16>, Minimal) {
    round_trip<Storage>();
}

TEST_CASE_TEMPLATE("a variance is kept in half as its root: squares far beyond a half's range are stored to its precision", Storage,
                   Planar<Float16>, Interleaved<Float16>) {
    ImageOf<Storage, LuminanceVariance> image(Extent{width_of<Pack>, 1});
    CHECK(image.bytes() < ImageOf<Planar<>, LuminanceVariance>(Extent{width_of<Pack>, 1}).bytes());
    auto const view = detail::view_of<LuminanceVariance>(image);
    for (float const variance : {0.f, 1e-9f, 0.3f, 1.f, 65504.f, 1e6f, 4e9f}) {
        CAPTURE(variance);
        view.set(0, 0, 0, variance);
        CHECK(view.get(0, 0, 0) == doctest::Approx(variance).epsilon(0.001));
        detail::store_pixels<Pack>(view, 0, 0, {Pack(variance)}, width_of<Pack>);
        for (int x = 0; x < width_of<Pack>; ++x) CHECK(view.get(0, x, 0) == doctest::Approx(variance).epsilon(0.001));
        CHECK(lane(component<0>(detail::load_pixels<Pack>(view, 0, 0)), 1) == view.get(0, 1, 0));
        auto const last = Index<Pack>(width_of<Pack> - 1);
        CHECK(lane(component<0>(detail::gather_pixels<Pack>(view, last, last - last)), 0) == view.get(0, 0, 0));
    }
}

// An assignment to a pixel that get() has copied would change nothing.
static_assert(!std::is_assignable_v<decltype(std::declval<Planar<>::Image<3>&>().get(0, 0)), glm::vec3>);

TEST_CASE("a host's memory is read in place, whatever its layout") {
    Extent const size{21, 5};
    std::vector<float> rgba(static_cast<std::size_t>(size.pixels() * 4));
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<float>(i);
    using Image = Borrowed<>::Image<3>;
    Image const interleaved(rgba.data(), size, 4, 4 * size.width);
    CHECK(interleaved.view().get(2, 3, 1) == rgba[static_cast<std::size_t>((1 * size.width + 3) * 4 + 2)]);
    Image const bottom_up(rgba.data() + static_cast<std::ptrdiff_t>(4) * size.width * (size.height - 1), size, 4, -4 * size.width);
    CHECK(bottom_up.view().get(1, 3, 0) == rgba[static_cast<std::size_t>((4 * size.width + 3) * 4 + 1)]);
    Image const planar(rgba.data(), size, 1, size.width, size.pixels());
    for (int x = -width_of<Pack>; x <= size.width; ++x) {
        auto const loaded = planar.view().load<Pack>(x, 4);
        for (int i = 0; i < width_of<Pack>; ++i) {
            int const inside = std::min(std::max(x + i, 0), size.width - 1);
            CHECK(lane(loaded.z, i) == planar.view().get(2, inside, 4));
        }
    }
}

TEST_CASE("a pipeline gives the same image in every storage and from a host's memory") {
    Extent const size{53, 31};
    constexpr auto denoise = presets::svgf(radiance, Demodulate{});
    auto const result = [&](auto storage) {
        Frame frame{size, denoise};
        History history{size, denoise, storage};
        std::vector<float> out;
        for (unsigned i = 0; i < 4; ++i) {
            tests::fill_randomly(frame, i);
            out = tests::copy_of(run(denoise, frame, history));
        }
        return out;
    };
    auto const planar = result(Planar<>{});
    CHECK(tests::difference(planar, result(Interleaved<>{})) == 0);
    CHECK(tests::difference(planar, result(Minimal{})) == 0);
    // Demodulated by 0.02 the values reach 150, of which a half keeps three digits.
    CHECK(tests::root_mean_square(planar, result(Planar<Float16>{})) < 0.02);

    Frame own{size, denoise};
    Frame borrowed{size, denoise, Borrowed<>{}};
    History history{size, denoise};
    std::vector<float> out;
    for (unsigned i = 0; i < 4; ++i) {
        tests::fill_randomly(own, i);
        for_each_channel(decltype(own)::channels{}, [&](auto c) {
            auto const view = own[c].view();
            auto const component_stride = c.components > 1 ? view.planes[c.components - 1] - view.planes[c.components - 2] : 0;
            borrowed[c] =
                typename std::remove_reference_t<decltype(borrowed[c])>(view.planes[0], size, 1, view.row_stride(), component_stride);
        });
        out = tests::copy_of(run(denoise, borrowed, history));
    }
    CHECK(tests::difference(planar, out) == 0);
}

TEST_CASE("a host's colours are borrowed in half, beside depth and motion in float") {
    Extent const size{5, 3};
    constexpr auto denoise = presets::surface(radiance);
    Frame frame{size, denoise, Borrowed<Float16>{}};
    History history{size, denoise};
    std::vector<std::uint16_t> const colour(static_cast<std::size_t>(size.pixels()) * 4, half_from_float(0.25f));
    std::vector<float> const depths(static_cast<std::size_t>(size.pixels()), 3.f);
    std::vector<float> const numbers(static_cast<std::size_t>(size.pixels()) * 3, 0.f);
    for_each_channel(decltype(frame)::channels{}, [&](auto c) {
        using Image = std::remove_reference_t<decltype(frame[c])>;
        if constexpr (std::is_same_v<decltype(c), Depth>)
            frame[c] = {depths.data(), size, 1, size.width};
        else if constexpr (std::is_same_v<typename Image::Element const, float const>)
            frame[c] = {numbers.data(), size, Image::components, std::ptrdiff_t(Image::components) * size.width};
        else
            frame[c] = {colour.data(), size, 4, std::ptrdiff_t(4) * size.width};
    });
    for (float const value : tests::copy_of(run(denoise, frame, history))) CHECK(value == 0.25f);
}

TEST_CASE("an image whose pixels 32-bit offsets don't reach is refused before any memory is asked for") {
    using Image = Interleaved<>::Image<24>;
    CHECK_THROWS_AS(Image(Extent{10000, 9000}), Error);
    int const most = std::numeric_limits<int>::max();
    CHECK_THROWS_AS(Planar<>::Image<1>(Extent{most, 1}), Error);
    CHECK_THROWS_AS(Planar<>::Image<1>(Extent{most, most}), Error);
    CHECK_THROWS_AS((Frame{Extent{most, most}, presets::surface(radiance)}), Error);
}

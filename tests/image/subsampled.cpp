#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{2 * width_of<Pack> + 5, 9};
float value(int c, int x, int y) { return static_cast<float>(c * 1000 + y * 50 + x); }
glm::vec3 colour(int x, int y) { return {value(0, x, y), value(1, x, y), value(2, x, y)}; }

/// An image of the samples of a picture, side by side.
template <SamplePattern pattern> auto samples_of(glm::ivec2 phase, Extent stored) {
    Planar<>::Image<3> image(stored);
    for (int row = 0; row < stored.height; ++row)
        for (int column = 0; column < stored.width; ++column) {
            auto const at = pattern.pixel(column, row, phase);
            image.set(column, row, colour(at.x, at.y));
        }
    return image;
}
bool is_sample(float a) { return a < 1e16f; }

/// What a view of the frame's size has, by pixels and by packs, against the pattern.
template <SamplePattern pattern> void check_view(auto const& image, glm::ivec2 phase, auto&& readable) {
    auto const view = image.view();
    for (int y = 0; y < size.height; ++y)
        for (int x = -width_of<Pack>; x <= size.width; ++x) {
            auto const loaded = detail::load_pixels<Pack>(view, x, y);
            for (int i = 0; i < width_of<Pack>; ++i) {
                CHECK(is_finite(lane(loaded.z, i)));
                int const column = x + i;
                if (column < 0 || column >= size.width) continue;
                bool const has = pattern.has(column, y, phase) && readable(column / pattern.columns, y / pattern.rows);
                REQUIRE(is_sample(view.get(2, column, y)) == has);
                REQUIRE(is_sample(lane(loaded.z, i)) == has);
                if (!has) continue;
                REQUIRE(view.get(2, column, y) == value(2, column, y));
                REQUIRE(lane(loaded.z, i) == value(2, column, y));
            }
        }
}

template <SamplePattern pattern> void check_pattern() {
    using Storage = Subsampled<pattern, Channels<Radiance>>;
    for (int number = 0; number < pattern.phases(); ++number) {
        auto const phase = pattern.phase(number);
        ImageOf<Storage, Radiance> image(size);
        image.phase = phase;
        // Whole blocks alone, or the cut ones too.
        for (Extent const stored : {pattern.stored(size), Extent{size.width / pattern.columns, size.height / pattern.rows}}) {
            image = samples_of<pattern>(phase, stored);
            check_view<pattern>(image, phase, [&](int column, int row) { return column < stored.width && row < stored.height; });
        }
        // The frame's size, with something else in the other pixels.
        Planar<>::Image<3> whole(size);
        tests::fill(whole, [&](int x, int y) { return pattern.has(x, y, phase) ? colour(x, y) : glm::vec3(-7); });
        image = whole;
        check_view<pattern>(image, phase, [](int, int) { return true; });
        // What is set is what is read.
        ImageOf<Storage, Radiance> own(size);
        own.phase = phase + glm::ivec2(3 * pattern.columns, -5 * pattern.rows); // counts on
        tests::fill(own, colour);
        check_view<pattern>(own, phase, [](int, int) { return true; });
    }
}
} // namespace

TEST_CASE("each pixel has a sample in one phase, and in the stored image a place of its own") {
    auto const check = [](SamplePattern pattern) {
        for (Extent const frame : {Extent{7, 5}, Extent{8, 6}, Extent{1, 1}, Extent{2, 1}}) {
            auto const stored = pattern.stored(frame);
            for (int y = 0; y < frame.height; ++y)
                for (int x = 0; x < frame.width; ++x) {
                    int samples = 0;
                    for (int number = 0; number < pattern.phases(); ++number) samples += pattern.has(x, y, pattern.phase(number));
                    CHECK(samples == 1);
                    CHECK(x / pattern.columns < stored.width);
                    CHECK(y / pattern.rows < stored.height);
                }
        }
    };
    for (auto const pattern : {half_size, half_width, half_height, checkerboard, SamplePattern{3, 2}, SamplePattern{4, 4, true}})
        check(pattern);
    CHECK(half_size.stored({1921, 1081}) == Extent{961, 541});
    CHECK(checkerboard.stored({1920, 1080}) == Extent{960, 1080});
    CHECK(half_size.fits({960, 541}, {1921, 1081}));
    CHECK_FALSE(half_size.fits({959, 541}, {1921, 1081}));
    CHECK_FALSE(half_size.fits({0, 1}, {1, 1}));
    // One phase and the next have no row or column in common.
    CHECK(half_size.phase(0) == glm::ivec2(0, 0));
    CHECK(half_size.phase(1) == glm::ivec2(1, 1));
    CHECK(half_size.phase(5) == glm::ivec2(1, 1));
    CHECK(checkerboard.has(1, 1, {0, 0}));
    CHECK(checkerboard.has(0, 1, {1, 0}));
}

TEST_CASE("samples are read where they belong, side by side or in an image of the frame's size, by pixels and by packs") {
    check_pattern<half_size>();
    check_pattern<half_width>();
    check_pattern<half_height>();
    check_pattern<checkerboard>();
    check_pattern<SamplePattern{.columns = 3, .rows = 2, .staggered = true}>();
}

TEST_CASE("an image of its own holds the samples only") {
    // Whole packs a row, so that what fills up rows does not count.
    constexpr Extent even{256, 96};
    auto const whole = Planar<>::Image<3>(even).bytes();
    CHECK(ImageOf<Subsampled<half_size, Channels<Radiance>>, Radiance>(even).bytes() <= whole / 3);
    CHECK(ImageOf<Subsampled<checkerboard, Channels<Radiance>>, Radiance>(even).bytes() <= whole * 2 / 3);
}

TEST_CASE("of what the ray has hit each pixel has that of its block's sample") {
    using Storage = Subsampled<half_size, Channels<Glossy, GlossyHit>, Borrowed<>>;
    ImageOf<Storage, GlossyHit> image(size);
    image.phase = {1, 0};
    auto const samples = samples_of<half_size>({1, 0}, half_size.stored(size));
    auto const view = samples.view();
    image = Borrowed<>::Image<3>{view.planes[0], samples.size(), 1, view.row_stride(), view.planes[1] - view.planes[0]};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const at = half_size.pixel(x / 2, y / 2, {1, 0});
            CHECK(image.get(x, y) == colour(at.x, at.y));
            CHECK(lane(detail::load_pixels<Pack>(image.view(), x, y).y, 0) == value(1, at.x, at.y));
        }
    // Other channels of the frame are as they were.
    static_assert(std::is_same_v<ImageOf<Storage, Depth>, ImageOf<Borrowed<>, Depth>>);
    static_assert(std::is_same_v<ImageOf<Subsampled<checkerboard, Channels<Visibility>, Storage>, Glossy>, ImageOf<Storage, Glossy>>);
}

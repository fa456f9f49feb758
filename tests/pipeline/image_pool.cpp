#include "../frames.hpp"

#include <quell/pipeline/graph/image_pool.hpp>

using namespace quell;
using detail::ImagePool;

namespace {
constexpr Extent size{5, 3};
template <int N> using Floats = Planar<>::Image<N>;

template <class Image> detail::PooledImage take(ImagePool& pool, int fraction = 1) {
    return pool.take(detail::format_of_image<Image>(), fraction);
}
void fill(auto const& view, float value) {
    for (int c = 0; c < view.components; ++c)
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x) view.set(c, x, y, value);
}
bool all(auto const& view, float value) {
    auto const pixels = tests::copy_of(view);
    return std::ranges::all_of(pixels, [&](float p) { return p == value; });
}
} // namespace

TEST_CASE("planes without a handle serve any image of their size and format, and others keep what they hold") {
    auto const plane = Floats<1>(size).bytes(), half_plane = Planar<Float16>::Image<1>(size).bytes();
    ImagePool pool(size);
    auto three = take<Floats<3>>(pool);
    auto const two = take<Floats<2>>(pool);
    CHECK(pool.bytes() == 5 * plane);
    fill(detail::view_of_image<Floats<2>>(two), 2.f);
    three = {};
    auto const four = take<Floats<4>>(pool);
    CHECK(pool.bytes() == 6 * plane);
    fill(detail::view_of_image<Floats<4>>(four), 4.f);
    CHECK((all(detail::view_of_image<Floats<2>>(two), 2.f) && all(detail::view_of_image<Floats<4>>(four), 4.f)));
    auto const same = four;
    CHECK((same == four && !(take<Floats<4>>(pool) == four)));
    CHECK(pool.bytes() == 10 * plane);
    (void)take<Planar<Float16>::Image<3>>(pool);
    CHECK(pool.bytes() == 10 * plane + 3 * half_plane);
    (void)take<Floats<4>>(pool, 2);
    CHECK(pool.bytes() == 10 * plane + 3 * half_plane + 4 * Floats<1>(divided(size, 2)).bytes());
}

/// A storage of a host's own, whose images are planes.
struct OwnPlanes {
    using Exact = OwnPlanes;
    template <int N> struct View {
        using Plane = Planar<>::Image<1>;
        static constexpr int components = N;
        Plane::View planes[std::size_t{N}];
        Extent size;
        static View of(std::array<std::shared_ptr<Plane>, std::size_t{N}> const& each) {
            View view{{}, each[0]->size()};
            for (std::size_t c = 0; c < each.size(); ++c) view.planes[c] = each[c]->view();
            return view;
        }
        [[nodiscard]] float get(int c, int x, int y) const { return planes[c].get(0, x, y); }
        void set(int c, int x, int y, float a) const { planes[c].set(0, x, y, a); }
    };
    template <int N> struct Image {
        std::array<std::shared_ptr<Planar<>::Image<1>>, std::size_t{N}> planes;
        explicit Image(Extent extent) {
            for (auto& plane : planes) plane = std::make_shared<Planar<>::Image<1>>(extent);
        }
        [[nodiscard]] View<N> view() const { return View<N>::of(planes); }
        [[nodiscard]] std::size_t bytes() const { return N * planes[0]->bytes(); }
    };
};
static_assert(ImageStorage<OwnPlanes>);

TEST_CASE("a storage of one's own shares planes too, with the same output") {
    constexpr auto denoise = presets::svgf(radiance);
    Frame frame{Extent{21, 9}, denoise};
    History history{frame.size, denoise};
    History own{frame.size, denoise, OwnPlanes{}};
    for (unsigned i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, i);
        auto const wanted = tests::copy_of(run(denoise, frame, history));
        CHECK(tests::copy_of(run(denoise, frame, own)) == wanted);
    }
    CHECK(own.bytes() == history.bytes());
}

TEST_CASE("images whose components lie side by side stay in one piece") {
    using Image = Interleaved<>::Image<3>;
    ImagePool pool(size);
    (void)take<Image>(pool);
    (void)take<Image>(pool);
    CHECK(pool.bytes() == Image(size).bytes());
    (void)take<Interleaved<>::Image<2>>(pool);
    CHECK(pool.bytes() == Image(size).bytes() + Interleaved<>::Image<2>(size).bytes());
}

#include "../frames.hpp"

using namespace quell;

namespace {
constexpr auto denoise = Pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
using P = std::remove_const_t<decltype(denoise)>;
using OwnFrame = Frame<P::reads>;

template <class F, class C>
concept Indexed = requires(F& frame, C channel) {
    frame[channel];
};

auto const* first_pixel(auto const& view) {
    if constexpr (requires { view.planes; })
        return view.planes[0];
    else
        return view.data;
}
} // namespace

// A host asks whether a channel is there, and no answer is an error.
static_assert(OwnFrame::has<Depth> && !OwnFrame::has<Albedo> && !OwnFrame::has<int>);
static_assert(Indexed<OwnFrame, Depth> && Indexed<OwnFrame const, Depth>);
static_assert(!Indexed<OwnFrame, Albedo> && !Indexed<OwnFrame const, Albedo> && !Indexed<OwnFrame, int>);
static_assert(Indexed<History<P>, HistoryLength> && Indexed<History<P> const, HistoryLength>);
static_assert(!Indexed<History<P>, LuminanceVariance> && !Indexed<History<P>, int>);

TEST_CASE_TEMPLATE("a copy of a frame has images, camera and number of its own", Storage, Planar<>, Planar<Float16>, Interleaved<>) {
    Frame frame{Extent{21, 5}, denoise, Storage{}};
    tests::fill_randomly(frame, 1);
    frame.number = 7, frame.shutter = 0.25f;
    auto const before = tests::copy_of(frame[radiance].view());
    auto copy = frame;
    CHECK((copy.size == frame.size && copy.number == 7 && copy.shutter == 0.25f));
    for_each_channel(P::reads{}, [&](auto c) { CHECK(tests::copy_of(copy[c].view()) == tests::copy_of(frame[c].view())); });
    copy[radiance].set(3, 4, {9.f, 9.f, 9.f});
    CHECK(tests::copy_of(frame[radiance].view()) == before);
    auto const* const memory = first_pixel(frame[radiance].view());
    frame = copy;
    CHECK(frame[radiance].get(3, 4).x == 9.f);
    CHECK(first_pixel(frame[radiance].view()) == memory);
    CHECK(first_pixel(frame[radiance].view()) != first_pixel(copy[radiance].view()));
    frame = Frame(Extent{8, 8}, denoise, Storage{});
    frame = copy; // of another size
    CHECK(tests::copy_of(frame[depth].view()) == tests::copy_of(copy[depth].view()));
    auto const& same = frame;
    frame = same;
    CHECK(tests::copy_of(frame[depth].view()) == tests::copy_of(copy[depth].view()));
}

TEST_CASE("a frame that was moved from can be copied and assigned to") {
    Frame frame{Extent{21, 5}, denoise};
    tests::fill_randomly(frame, 1);
    auto const taken = std::move(frame);
    auto copy = frame; // NOLINT(bugprone-use-after-move): what is tested
    copy = taken;
    CHECK(tests::copy_of(copy[depth].view()) == tests::copy_of(taken[depth].view()));
    frame = copy;
    CHECK(tests::copy_of(frame[depth].view()) == tests::copy_of(taken[depth].view()));
}

TEST_CASE("a copy of a borrowing frame reads the same memory of the host") {
    Extent const size{4, 2};
    std::vector<float> depths(8, 1.f);
    Frame frame{size, denoise, Borrowed<>{}};
    frame[depth] = {depths.data(), size, 1, 4};
    auto const copy = frame;
    depths[5] = 3.f;
    CHECK(copy[depth].view().get(0, 1, 1) == 3.f);
}

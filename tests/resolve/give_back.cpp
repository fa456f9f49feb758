#include "flat_surface.hpp"

#include <doctest/doctest.h>
#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>
#include <quell/resolve/give_back.hpp>

#include <cmath>

using namespace quell;
using namespace quell::tests;

namespace {

using Colours = std::vector<glm::vec3>;
constexpr Pipeline denoise{radiance, Temporal{SurfaceMotion{}, RunningMean{}}, Spatial{Atrous<>{.levels = 2}}};

float stripes(int x, int) { return x % 4 < 2 ? 1.3f : .7f; }

/// A surface that stands still, as a frame of any storage.
template <class AnyFrame> void fill(AnyFrame& frame, FlatSurface const& seen) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame[radiance].set(x, y, seen.samples[static_cast<std::size_t>(y * size.width + x)]);
            frame[normal].set(x, y, {0.f, 0.f, 1.f}), frame[depth].set(x, y, 3.f), frame[motion].set(x, y, {0.f, 0.f});
        }
}
/// What comes out of a few frames, each by itself by function(frame, history, i).
template <class Storage, class F> void each_frame(Storage const& storage, F&& function, float unit = 1.f) {
    Frame frame{size, denoise, storage};
    History history{size, denoise};
    for (unsigned i = 0; i < 3; ++i) {
        FlatSurface seen(stripes, .3f, i + 1);
        for (auto& sample : seen.samples) sample *= unit;
        fill(frame, seen);
        function(frame, history, i);
    }
}
std::vector<Colours> given_back(auto const& storage, auto const& executor, float unit = 1.f) {
    std::vector<Colours> all;
    GiveBack give_back(4);
    each_frame(
        storage,
        [&](auto& frame, auto& history, unsigned) {
            auto const denoised = run(denoise, frame, history, executor);
            all.push_back(give_back.apply(radiance, denoised, frame, history, executor));
        },
        unit);
    return all;
}
/// As of FlatSurface.
Frame<Channels<Normal, Depth, Motion>> guides_of_a_wall() {
    Frame<Channels<Normal, Depth, Motion>> guides(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) guides[normal].set(x, y, {0.f, 0.f, 1.f}), guides[depth].set(x, y, 3.f);
    return guides;
}

} // namespace

TEST_CASE("light given back: the unit of light changes no bit") {
    auto const wanted = given_back(Planar<>{}, Simd{});
    for (float const unit : {0x1p-12f, 0x1p12f}) {
        CAPTURE(unit);
        auto all = given_back(Planar<>{}, Simd{}, unit);
        for (auto& picture : all)
            for (auto& pixel : picture) pixel *= 1.f / unit;
        CHECK(all == wanted);
    }
}

TEST_CASE("light given back behind a pipeline: what both functions give back, frame by frame") {
    std::vector<Colours> wanted;
    Colours lacking;
    each_frame(Planar<>{}, [&](auto& frame, auto& history, unsigned i) {
        auto picture = detail::colours_in(run(denoise, frame, history));
        auto const samples = detail::colours_in(frame[radiance].view()), before = picture;
        feed_back_residual({.shares = ResidualFeedbackShares::of_frame(4, i > 0, false)}, Simd{}, samples, frame[normal].view(),
                           frame[depth].view(), picture);
        CHECK(picture != before); // or nothing would be compared
        RepeatedResidual const rule{.samples = 4};
        auto now = lacking_of_samples(rule, Simd{}, size, samples, picture);
        if (!lacking.empty()) give_back_repeated(rule, Simd{}, size, now, {lacking_moved(Simd{}, lacking, frame[motion].view())}, picture);
        lacking = now;
        wanted.push_back(picture);
    });
    CHECK(given_back(Planar<>{}, Simd{}) == wanted);
    CHECK(given_back(Interleaved<>{}, Simd{}) == wanted);
    for (int const threads : {1, 2, 3}) CHECK(given_back(Planar<>{}, Threads<>{.count = threads}) == wanted);
}

TEST_CASE("light given back behind a pipeline: stripes come back, with two frames more of them, and a cut begins anew") {
    GiveBack give_back(64), other(64);
    FlatSurface seen(stripes, .3f), later(stripes, .3f, 6);
    auto const guides = guides_of_a_wall();
    auto const apply = [&](GiveBack& to, FlatSurface surface, bool has_past) {
        to.apply(Serial{}, surface.samples, guides.views(GiveBack::Guides::channels{}), {.has_past = has_past}, surface.picture);
        return surface;
    };
    double const before = seen.error();
    CHECK(apply(give_back, seen, false).error() < .8 * before);
    CHECK(give_back.bytes() >= sizeof(glm::vec3) * static_cast<std::size_t>(size.pixels()));
    auto const with_past = apply(give_back, later, true);
    auto const without = apply(other, later, false);
    CHECK(with_past.error() < .8 * without.error());
    CHECK(apply(give_back, later, false).picture == without.picture);
    give_back.forget();
    CHECK(give_back.bytes() == 0);
    CHECK(apply(give_back, later, true).picture == without.picture);
}

TEST_CASE("light given back behind a pipeline: a picture that is as its samples stays, whatever the frame before lacked") {
    GiveBack give_back(16);
    Frame<Channels<Normal, Depth, Motion>> guides(size);
    auto const views = guides.views(GiveBack::Guides::channels{});
    FlatSurface first(stripes, .3f), second([](int, int) { return 1.f; }, 0.f);
    give_back.apply(Simd{}, first.samples, views, {}, first.picture);
    auto const before = second.picture;
    give_back.apply(Simd{}, second.samples, views, {.has_past = true}, second.picture);
    CHECK(second.picture == before);
}

TEST_CASE("light given back behind a pipeline: of other sizes nothing is given, and the next frame has no past") {
    GiveBack give_back(16), other(16);
    FlatSurface first(stripes, .1f), wrong(stripes, .1f), second(stripes, .1f, 7);
    Frame<Channels<Normal, Depth, Motion>> guides(size);
    auto const views = guides.views(GiveBack::Guides::channels{});
    give_back.apply(Simd{}, first.samples, views, {}, first.picture);
    wrong.samples.pop_back();
    CHECK_THROWS_AS(give_back.apply(Simd{}, wrong.samples, views, {.has_past = true}, wrong.picture), Error);
    auto again = second;
    give_back.apply(Simd{}, second.samples, views, {.has_past = true}, second.picture);
    other.apply(Simd{}, again.samples, views, {}, again.picture);
    CHECK(second.picture == again.picture);
}

TEST_CASE("light given back behind a pipeline: of single samples nothing is fed back to a history that is not known to hold") {
    FlatSurface const first(stripes, .3f), second(stripes, .3f, 7);
    auto const guides = guides_of_a_wall();
    auto const views = guides.views(GiveBack::Guides::channels{});
    auto const fed_back = [&](float samples, bool has_past, bool is_judged) {
        GiveBack give_back(samples);
        auto picture = second.picture;
        give_back.apply(Simd{}, second.samples, views, {has_past, is_judged}, picture);
        return picture != second.picture;
    };
    CHECK_FALSE(fed_back(1.f, true, false));
    CHECK(fed_back(1.f, true, true));
    CHECK(fed_back(1.f, false, false));
    CHECK(fed_back(16.f, true, false));
}

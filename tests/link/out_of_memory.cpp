#include "../failing.hpp"
#include "../frames.hpp"

#include <quell/pipeline/chain.hpp>
#include <quell/pipeline/composite.hpp>
#include <quell/pipeline/two_sided.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/by_evidence.hpp>
#include <quell/presets/resolve.hpp>

#include <array>

using namespace quell;

// What is made of several histories, where memory runs out between them.
namespace {

constexpr Extent size{17, 9};
template <ChannelTag Signal> constexpr Pipeline accumulated{Signal{}, Temporal{SurfaceMotion{}, RunningMean{}}};
constexpr Pipeline known_samples{radiance, KnownSamples{}, Temporal{SurfaceMotion{}, WithVariance{RunningMean{}}},
                                 Spatial{Atrous<>{.levels = 1}}};

/// A denoiser with its history and two frames, of which one is given or both, whose numbers say nothing about what follows what.
template <class P> struct Shown {
    P const& denoiser;
    History<P, tests::Failing> history{size, denoiser, tests::Failing{}};
    std::array<decltype(Frame{size, denoiser}), 2> window{Frame{size, denoiser}, Frame{size, denoiser}};

    auto picture(unsigned number) {
        tests::fill_randomly(window[0], number), tests::fill_randomly(window[1], number + 1);
        if constexpr (detail::is_two_sided<P>)
            return tests::copy_of(run(denoiser, window, history, Serial{}));
        else
            return tests::copy_of(run(denoiser, window[0], history, Serial{}));
    }
};
/// Lets the memory of a frame run out at each image that it takes, one after another, and holds the next frames against those of a fresh
/// history.
template <class P> void check_frames_after(P const& denoiser) {
    for (int fails_at = 0; fails_at < 99; ++fails_at) {
        CAPTURE(fails_at);
        Shown<P> shown{denoiser}, fresh{denoiser};
        for (unsigned number = 0; number < 2; ++number) shown.picture(number);
        shown.history.release_scratch();
        tests::Failing::left = fails_at;
        bool ran_out = false;
        try {
            shown.picture(2);
        } catch (std::bad_alloc const&) {
            ran_out = true;
        }
        tests::Failing::left = -1;
        if (!ran_out) {
            CHECK(fails_at > 1);
            return;
        }
        for (unsigned number = 3; number < 6; ++number) CHECK(shown.picture(number) == fresh.picture(number));
    }
    FAIL("memory never sufficed");
}

} // namespace

TEST_CASE("a frame that ends for want of memory leaves nothing behind in any of its histories") {
    constexpr auto plain = accumulated<Radiance>;
    constexpr TwoSided both_sides{known_samples};
    SUBCASE("of a composite") { check_frames_after(Composite{accumulated<Glossy>, accumulated<Direct>}); }
    SUBCASE("of a chain") { check_frames_after(Chain{plain, accumulated<Denoised>, accumulated<Denoised>}); }
    SUBCASE("of a chain behind a composite") {
        check_frames_after(Chain{Composite{accumulated<Glossy>, accumulated<Direct>}, accumulated<Denoised>});
    }
    SUBCASE("of both sides") { check_frames_after(both_sides); }
    SUBCASE("of a chain behind both sides") { check_frames_after(Chain{both_sides, accumulated<Denoised>}); }
    SUBCASE("of a choice by evidence") { check_frames_after(presets::by_evidence(plain)); }
    SUBCASE("of what is resolved") { check_frames_after(presets::resolve(plain)); }
    SUBCASE("of what is resolved behind a chain") { check_frames_after(presets::resolve(Chain{plain, accumulated<Denoised>})); }
    SUBCASE("of anti-aliased colours") { check_frames_after(presets::anti_aliased(plain)); }
}

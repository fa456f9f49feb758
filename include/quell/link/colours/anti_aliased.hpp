#pragma once

#include <quell/frame/modulation.hpp>
#include <quell/link/colours/anti_aliased_pixel.hpp>
#include <quell/link/seen_channels.hpp>
#include <quell/pipeline/chain.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET {

struct AntiAliased;

namespace detail {
/// Keeps what the next frame sees of this one.
struct KeepColours {
    static constexpr auto name = "keep colours";
    using reads = Channels<Albedo, Depth, Motion>;
    using keeps = Channels<SeenColour, SeenDepth, SeenMotion>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        return emitted<Real>(SeenColour{}, Demodulate{}.outward(px, splat<vec3<Real>>(Real(1.f))))
            .with(SeenDepth{}, px[depth])
            .with(SeenMotion{}, vec2<Real>(px[motion]));
    }
};

/// A pixel of this frame, and those of the frame before.
template <class Px> struct ColoursSeen {
    using Real = typename Px::Real;
    static constexpr bool has_after = false;
    Px const& px;
    decltype(px.jitter_now().x) across[3], down[3]; ///< weights of the columns and the rows around

    QUELL_KERNEL ColoursSeen(Px const& pixel, float falloff) : px(pixel) {
        auto const jitter = px.jitter_now();
        for (int i = 0; i < 3; ++i) {
            auto const x = static_cast<float>(i - 1) + jitter.x, y = static_cast<float>(i - 1) + jitter.y;
            across[i] = quell::exp(x * x * falloff), down[i] = quell::exp(y * y * falloff);
        }
    }

    struct Tap {
        Px px;
        QUELL_KERNEL auto inside() const { return px.inside(); }
        [[nodiscard]] QUELL_KERNEL bool any_row_inside() const { return px.any_row_inside(); }
        QUELL_KERNEL Real depth() const { return px[quell::depth]; }
        QUELL_KERNEL vec3<Real> colour() const { return px[SeenColour{}]; }
        QUELL_KERNEL vec2<Real> motion() const { return px[quell::motion]; }
        QUELL_KERNEL vec3<Real> light() const {
            return map([](auto p, auto c) QUELL_INLINED { return p / c; }, vec3<Real>(px.signal()), colour());
        }
    };
    struct FrameBefore {
        static constexpr bool knows_toward = false, is_last = true;
        Px const& px;
        decltype(px.jitter_then()) jitter;
        QUELL_KERNEL Real depth(auto const& place, int dx, int dy) const { return px.past(place, dx, dy)[SeenDepth{}]; }
        QUELL_KERNEL vec3<Real> colour(auto const& place, int dx, int dy) const { return px.past(place, dx, dy)[SeenColour{}]; }
        QUELL_KERNEL vec2<Real> onward(auto const& place, int dx, int dy) const { return px.past(place, dx, dy)[SeenMotion{}]; }
        QUELL_KERNEL vec2<Real> toward(auto const& place, int dx, int dy) const { return onward(place, dx, dy); }
    };

    QUELL_KERNEL auto size() const { return px.size(); }
    QUELL_KERNEL vec2<Real> position() const { return px.position(); }
    QUELL_KERNEL Tap at(int dx, int dy) const { return {px.at(dx, dy)}; }
    QUELL_KERNEL auto own_weight(int dx, int dy) const { return across[dx + 1] * down[dy + 1]; }
    QUELL_KERNEL vec3<Real> plain() const { return px.signal(); }
    QUELL_KERNEL vec3<Real> light() const { return Tap{px}.light(); }
    QUELL_KERNEL Real depth() const { return px[quell::depth]; }
    template <bool is_before> QUELL_KERNEL void each_frame(auto&& visit) const {
        if (px.has_past()) visit(FrameBefore{px, px.jitter_then()});
    }
};

/// Puts the picture together with the colours of both frames.
template <class Policy> struct MixColours {
    static constexpr auto name = "anti-alias";
    using reads = Channels<SeenColour, Depth, Motion>;
    using reads_kept = Channels<SeenColour, SeenDepth, SeenMotion>;
    static constexpr int farthest_tap = 1;
    Policy policy;

    QUELL_KERNEL auto filter(auto px) const {
        ColoursSeen<decltype(px)> const seen(px, falloff_of(policy));
        return AntiAliasedPixel<Policy, ColoursSeen<decltype(px)>, false>(policy, seen).made().value;
    }
};
} // namespace detail

/// Colours of one ray per pixel, anti-aliased by those of other frames (after Yang et al. 2009, "Amortized supersampling", with samples in
/// place of pictures, so that nothing is blurred from frame to frame). Each sample of a frame around is moved along its own motion to where
/// it is now. It counts where its depth is found among the 3x3 pixels there, and by a Gaussian of its distance from the pixel's centre.
///
/// The samples of a pixel are those of two surfaces at most, the nearest and the farthest of the 3x3: each is multiplied by the light of
/// its own surface, so that an edge is as mixed as its pixel covers of both.
///
/// As a filter of a link it takes the light from the picture, which is what the albedo leaves of it, and has the samples of this frame and
/// the one before: see presets::anti_aliased. Hosts of several signals, or of frames to come, call anti_alias().
struct AntiAliased {
    static constexpr int most_frames = 4; ///< to each side, of anti_alias()
    /// @cond
    static constexpr bool checks_jitter = true;
    /// @endcond

    float deviation = 0.5f; ///< of the Gaussian, in pixels
    float range = 0.03f;    ///< part of the depth by which samples may be off
    float own = 1.f;        ///< weight of the pixel's own sample
    bool by_surface = true; ///< whether each surface has its own light; else both have the pixel's
    float change = 0.f;     ///< colours whose mean is by more than this part none of those around have changed by themselves; 0: none does

    /// For pixels of so many samples. Of one, each surface has its light, and a pixel's own sample is one among others. What is the mean of
    /// many has the pixel's filter already, and less noise: above 8 samples it is soon nearly all.
    /// @param samples per pixel, 1 or more
    [[nodiscard]] static constexpr AntiAliased of_samples(int samples) {
        if (samples <= 1) return {.deviation = .45f, .change = .1f};
        float const square = static_cast<float>(samples) * static_cast<float>(samples);
        return {.deviation = .35f, .own = square / 16.f * std::max(1.f, square / 64.f), .by_surface = false, .change = .1f};
    }

    /// @cond
    using parts = Parts<detail::KeepColours, detail::MixColours<AntiAliased>>;
    constexpr void for_each_pass(auto&& pass) const { pass(detail::KeepColours{}), pass(detail::MixColours<AntiAliased>{*this}); }
    /// @endcond
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

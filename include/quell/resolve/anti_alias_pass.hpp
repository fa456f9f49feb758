#pragma once

#include <quell/execute/queue_executor.hpp>
#include <quell/resolve/coloured_frame.hpp>
#include <quell/resolve/pixel_in_image.hpp>

#include <array>
#include <type_traits>

/// The pass of anti_alias(), and what it reads.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What is read of a frame around.
template <class Storage> struct AroundFrame {
    ViewOf<Storage, Albedo> colour{};
    ViewOf<Storage, Depth> depth{};
    ViewOf<Storage, Motion> onward{}; ///< from there to the next frame farther away
    ViewOf<Storage, Motion> toward{}; ///< from there to the next frame nearer by; not finite: not known
    glm::vec2 jitter{0.f};
    bool knows_toward = true; ///< whether there is `toward`
};

/// Weights of the 3x3 around a pixel.
inline std::array<float, 9> own_weights_of(AntiAliased const& policy, glm::vec2 jitter) {
    std::array<float, 9> weights;
    for (int i = 0; i < 9; ++i) {
        float const x = static_cast<float>(i % 3 - 1) + jitter.x, y = static_cast<float>(i / 3 - 1) + jitter.y;
        weights[static_cast<std::size_t>(i)] = quell::exp((x * x + y * y) * falloff_of(policy));
    }
    return weights;
}

/// In place of a view: nobody asks what frames around tell by themselves.
struct NoOthers {};

/// The pass of anti_alias().
/// @tparam Others a view that takes what frames around tell of the colour, without the frame itself: not finite where that is nothing
template <class Storage, class Light, class Target, class Others = NoOthers> struct AntiAliasJob {
    static constexpr auto name = "anti-alias";
    AntiAliased policy;
    ColouredFrame<Storage> here;
    Light light;
    Target to;
    std::array<float, 9> own_weights; ///< of the 3x3
    std::array<AroundFrame<Storage>, AntiAliased::most_frames> before{}, after{};
    int count_before = 0, count_after = 0;
    [[no_unique_address]] Others others{};

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        constexpr bool tells_others = !std::is_same_v<Others, NoOthers>;
        Seen<Real> const seen{*this, x, y};
        auto const made = AntiAliasedPixel<AntiAliased, Seen<Real>, tells_others>(policy, seen).made();
        if constexpr (tells_others) store_pixels<Real>(others, x, y, made.told, count);
        store_pixels<Real>(to, x, y, made.value, count);
    }

private:
    /// A pixel of this frame, and the frames around.
    template <class R> struct Seen {
        using Real = R;
        static constexpr bool has_after = true;
        AntiAliasJob const& job;
        int x, y;

        struct Tap : PixelInImage<Real> {
            AntiAliasJob const& job;
            QUELL_KERNEL Real depth() const { return this->load(job.here.depth); }
            QUELL_KERNEL vec3<Real> colour() const { return this->load(job.here.colour); }
            QUELL_KERNEL vec2<Real> motion() const { return this->load(job.here.motion); }
            QUELL_KERNEL vec2<Real> to_next() const { return this->load(job.here.to_next); }
            QUELL_KERNEL vec3<Real> light() const { return this->load(job.light); }
        };
        struct Around {
            AroundFrame<Storage> const& of;
            Extent size;
            bool is_last;
            glm::vec2 jitter = of.jitter;
            bool knows_toward = of.knows_toward;

            QUELL_KERNEL Real depth(auto const& place, int dx, int dy) const { return fetch<Real>(of.depth, size, place, dx, dy); }
            QUELL_KERNEL vec3<Real> colour(auto const& place, int dx, int dy) const { return fetch<Real>(of.colour, size, place, dx, dy); }
            QUELL_KERNEL vec2<Real> onward(auto const& place, int dx, int dy) const { return fetch<Real>(of.onward, size, place, dx, dy); }
            QUELL_KERNEL vec2<Real> toward(auto const& place, int dx, int dy) const {
                return fetch<Real>(knows_toward ? of.toward : of.onward, size, place, dx, dy);
            }
        };

        [[nodiscard]] QUELL_KERNEL Extent size() const { return job.here.depth.size; }
        QUELL_KERNEL vec2<Real> position() const {
            return {Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
        }
        QUELL_KERNEL Tap at(int dx, int dy) const { return {{size(), x + dx, y + dy}, job}; }
        [[nodiscard]] QUELL_KERNEL float own_weight(int dx, int dy) const {
            return job.own_weights[static_cast<std::size_t>(dy * 3 + dx + 4)];
        }
        QUELL_KERNEL vec3<Real> plain() const { return vec3<Real>(load_pixels<Real>(job.here.colour, x, y)) * light(); }
        QUELL_KERNEL vec3<Real> light() const { return load_beside<Real>(job.light, x, y); }
        QUELL_KERNEL Real depth() const { return load_pixels<Real>(job.here.depth, x, y); }
        [[nodiscard]] QUELL_KERNEL int count_after() const { return job.count_after; }
        template <bool is_before> QUELL_KERNEL void each_frame(auto&& visit) const {
            int const count = is_before ? job.count_before : job.count_after;
            for (int k = 0; k < count; ++k)
                if (!visit(Around{(is_before ? job.before : job.after)[static_cast<std::size_t>(k)], size(), k + 1 == count})) return;
        }
    };
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

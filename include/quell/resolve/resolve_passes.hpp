#pragma once

#include <quell/link/resolve/resolve.hpp>
#include <quell/resolve/pixel_in_image.hpp>

#include <array>
#include <cstddef>

/// The passes of a Resolve whose frames may be of another size than its output, and what they read and write.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What a Resolve keeps of a frame, as views.
template <class Colour, class Vectors, class Depths> struct ResolvedFrame {
    Colour colour;
    Vectors motion; ///< of the nearest surface in the 3x3 around, in pixels
    Depths depth;
    Extent size{};
    glm::vec2 jitter{0.f};
};
template <class Colour, class Vectors, class Depths>
ResolvedFrame(Colour, Vectors, Depths, Extent, glm::vec2) -> ResolvedFrame<Colour, Vectors, Depths>;

/// Ranges around each pixel of this frame, as views.
template <class Colour, class Depths> struct RangeImages {
    Colour low, high; ///< of the colours, in the axes of the clamp
    Depths depths;    ///< the nearest, and the farthest
};
template <class Colour, class Depths> RangeImages(Colour, Colour, Depths) -> RangeImages<Colour, Depths>;

/// One pixel of the input: what is kept of it, and the ranges around it.
template <class Policies, class Conversion, class Picture, class HostDepth, class HostMotion, class Kept, class Ranges> struct KeepFrame {
    static constexpr auto name = "prepare resolve";
    Policies policies;
    Conversion vectors; ///< what the host's motion means
    Picture picture;    ///< what the pipeline made
    HostDepth depth;
    HostMotion motion;
    Kept kept;
    Ranges around;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        using V = Value<Picture::components, Real>;
        Tap<Real> const here{{kept.size, x, y}, *this};
        auto const ranges = ranges_around<V>(policies, here);
        store_pixels<Real>(kept.colour, x, y, here.picture(), count);
        store_pixels<Real>(kept.motion, x, y, vec2<Real>(vectors(ranges.vector)), count);
        store_pixels<Real>(kept.depth, x, y, here.depth(), count);
        store_pixels<Real>(around.low, x, y, ranges.low, count);
        store_pixels<Real>(around.high, x, y, ranges.high, count);
        store_pixels<Real>(around.depths, x, y, ranges.depths, count);
    }

private:
    template <class Real> struct Tap : PixelInImage<Real> {
        KeepFrame const& job;
        QUELL_KERNEL Tap at(int dx, int dy) const { return {{this->size, this->x + dx, this->y + dy}, job}; }
        QUELL_KERNEL Value<Picture::components, Real> picture() const { return this->load(job.picture); }
        QUELL_KERNEL Real depth() const { return this->load(job.depth); }
        QUELL_KERNEL vec2<Real> motion() const { return this->load(job.motion); }
    };
};
template <class Policies, class Conversion, class Picture, class HostDepth, class HostMotion, class Kept, class Ranges>
KeepFrame(Policies, Conversion, Picture, HostDepth, HostMotion, Kept, Ranges)
    -> KeepFrame<Policies, Conversion, Picture, HostDepth, HostMotion, Kept, Ranges>;

/// One output pixel of a Resolve.
template <class Policies, class Kept, class Ranges, class Target> struct ResolveJob {
    static constexpr auto name = "resolve";
    Policies policies;
    std::array<Kept, Policies::past_frames + 1> frames; ///< this frame, and those before it
    int frame_count;
    Ranges ranges;
    Target target;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        store_pixels<Real>(target, x, y, resolved<Value<Target::components, Real>>(policies, Seen<Real>{*this, x, y}), count);
    }

private:
    /// A frame whose places are those of the output.
    template <class Real> struct Seen {
        ResolveJob const& job;
        int x, y;

        struct Of {
            using V = Value<Target::components, Real>;
            Kept const& frame;
            glm::vec2 ratio; ///< of the output's size to that of the frame

            [[nodiscard]] QUELL_KERNEL Extent size() const { return frame.size; }
            QUELL_KERNEL vec2<Real> where(vec2<Real> const& place) const {
                return {place.x * (1.f / ratio.x) - frame.jitter.x, place.y * (1.f / ratio.y) - frame.jitter.y};
            }
            QUELL_KERNEL vec2<Real> moved(vec2<Real> const& place, vec2<Real> const& vector) const {
                return {fma(vector.x, Real(ratio.x), place.x), fma(vector.y, Real(ratio.y), place.y)};
            }
            QUELL_KERNEL vec2<Real> off_centre(vec2<Real> const& at) const {
                return {(at.x - floor(at.x) - 0.5f) * ratio.x, (at.y - floor(at.y) - 0.5f) * ratio.y};
            }
            QUELL_KERNEL V picture(auto const& place, int dx, int dy) const { return fetch<Real>(frame.colour, size(), place, dx, dy); }
            QUELL_KERNEL Real depth(auto const& place) const { return fetch<Real>(frame.depth, size(), place, 0, 0); }
            QUELL_KERNEL vec2<Real> vector(auto const& place) const { return fetch<Real>(frame.motion, size(), place, 0, 0); }
        };
        QUELL_KERNEL Of of(int i) const {
            auto const& frame = job.frames[static_cast<std::size_t>(i)];
            auto const size = job.target.size;
            return {frame,
                    {static_cast<float>(size.width) / static_cast<float>(frame.size.width),
                     static_cast<float>(size.height) / static_cast<float>(frame.size.height)}};
        }
        QUELL_KERNEL Of now() const { return of(0); }
        QUELL_KERNEL vec2<Real> place() const {
            return {Real(static_cast<float>(x) + 0.5f) + lanes<Real>(), Real(static_cast<float>(y) + 0.5f)};
        }
        QUELL_KERNEL auto contains(vec2<Real> const& place) const {
            auto const size = job.target.size;
            return both(place.x >= Real(0.f), place.x <= Real(static_cast<float>(size.width)), place.y >= Real(0.f),
                        place.y <= Real(static_cast<float>(size.height)));
        }
        QUELL_KERNEL RangesAround<typename Of::V> around(auto const& place) const {
            auto const size = job.frames[0].size;
            return {fetch<Real>(job.ranges.low, size, place, 0, 0),
                    fetch<Real>(job.ranges.high, size, place, 0, 0),
                    fetch<Real>(job.ranges.depths, size, place, 0, 0),
                    {}};
        }
        QUELL_KERNEL void each_past(auto&& visit) const {
            for (int i = 1; i < job.frame_count; ++i)
                if (!visit(of(i), of(i - 1))) return;
        }
    };
};
template <class Policies, class Kept, std::size_t n, class Ranges, class Target>
ResolveJob(Policies, std::array<Kept, n>, int, Ranges, Target) -> ResolveJob<Policies, Kept, Ranges, Target>;

/// The pass of a sharpening.
template <class Sharpening, class From, class To> struct SharpenJob {
    static constexpr auto name = "sharpen";
    Sharpening sharpening;
    From from;
    To to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        using V = Value<From::components, Real>;
        auto const tap = [&](int dx, int dy) QUELL_INLINED {
            PixelInImage<Real> const pixel{from.size, x + dx, y + dy};
            return select(pixel.inside(), V(pixel.load(from)), V(load_pixels<Real>(from, x, y)));
        };
        V const beside[] = {tap(-1, 0), tap(1, 0), tap(0, -1), tap(0, 1)};
        store_pixels<Real>(to, x, y, sharpening(V(load_pixels<Real>(from, x, y)), beside), count);
    }
};
template <class Sharpening, class From, class To> SharpenJob(Sharpening, From, To) -> SharpenJob<Sharpening, From, To>;

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <gauntlet/world.hpp>

// A sequence of frames, and what its renderer gets wrong. Everything by default is as it should be.
namespace quell::gauntlet {

/// What the camera does.
enum class Path {
    still,
    dolly,  ///< goes sideways and forwards
    turns,  ///< about the vertical
    zooms,  ///< its lens becomes longer
    shifts, ///< its lens is shifted
    cuts,   ///< goes as `dolly`, and is elsewhere from frame 5 on
};

/// What vectors say.
enum class Vectors {
    right,
    zero,
    sky_zero,     ///< 0 for the sky alone
    without_lens, ///< as if the lens had not changed
    cut_zero,     ///< 0 where the camera has jumped in between
    rigid,        ///< as if nothing had grown, nor the sky's pattern turned by itself
    things_still, ///< as if nothing but the camera had moved
    apart_zero,   ///< 0 for things that are apart
    mirrored,     ///< to the left in place of the right
    halved,
    late, ///< those of the frame before
};

/// What is done to the samples of pixels behind the renderer.
enum class Spread {
    none,
    splatted, ///< each sample counts for 3x3 pixels
    doubled,  ///< rendered at half the size, and each pixel written four times
    filtered, ///< light is a mean of 5x5 pixels of one thing: another denoiser was there before
};

/// What is wrong with a guide.
enum class Fault {
    none,
    zero,
    noisy,
    of_frame_before,
    highlight, ///< of things that are apart: a colour times 1 to 96, as a sample happens to see the lamp
    white,     ///< of things that are apart: the same, cut to 1
};

/// Which part of the picture is broken, where it is not all of it.
enum class Part { all, things, sky, shadows, flames };

/// Whose names the files have.
enum class Names { cycles, own };

struct Faults {
    Fault normal = Fault::none, depth = Fault::none, albedo = Fault::none;
    bool operator==(Faults const&) const = default;
    [[nodiscard]] bool has(Fault fault) const { return normal == fault || depth == fault || albedo == fault; }
};

struct Shot {
    World world{};
    Path path = Path::dolly;
    Vectors vectors = Vectors::right;
    bool is_held = false;      ///< every frame is there twice
    bool has_one_seed = false; ///< the same random numbers in every frame
    bool is_baked = false;     ///< the light of things that are apart has noise that goes with their surface
    Dither dither = Dither::none;
    Spread spread = Spread::none;
    double says = 1;          ///< how many times the samples that were taken the file says; 0: nothing of them
    int says_at_least = 0;    ///< and not less than this
    bool is_adaptive = false; ///< where a pixel shows one surface, an eighth of the samples
    bool has_layers = false;  ///< another view layer before the picture's, of 100 times the samples
    Names names = Names::cycles;
    Faults faults{};
    bool is_half = false;        ///< 16 bits for each number
    bool is_transparent = false; ///< the film, where nothing is hit
    Part part = Part::all;       ///< what is broken
    bool operator==(Shot const&) const = default;
};

/// The frame that a cut begins with.
inline constexpr int cut_at = 5;

/// How the frames are made.
struct Making {
    Extent size{96, 54};
    int frames = 8;
    int samples = 4;
    std::int64_t seed = 1;
};

/// The time that a frame shows, which is its number but for held ones.
[[nodiscard]] inline int time_of(Shot const& shot, int frame) { return shot.is_held ? (frame + 1) / 2 : frame; }
/// Whether the camera jumps between two times.
[[nodiscard]] inline bool has_cut(Shot const& shot, double one, double other) {
    return shot.path == Path::cuts && (one < cut_at) != (other < cut_at);
}
[[nodiscard]] View view_at(Shot const& shot, Extent size, double time);

} // namespace quell::gauntlet

#include <gauntlet/frame_file.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace quell::gauntlet {

namespace {

/// Puts planes together.
struct Planes {
    io::ExrImage& image;
    Rendered const& frame;
    io::SampleType type;

    void add(std::string const& name, auto const& value) const {
        io::Plane plane{.name = name, .type = type, .values = {}};
        for (auto const& pixel : frame.pixels) plane.values.push_back(static_cast<float>(value(pixel)));
        image.planes.push_back(std::move(plane));
    }
    void add_colour(std::string const& name, auto const& value, char const* letters = "RGB") const {
        for (int c = 0; c < 3; ++c) add(name + letters[c], [&](Pixel const& pixel) { return value(pixel)[c]; });
    }
};

/// Light is the mean of products over the mean of colours.
Vec3 over(Vec3 product, Vec3 colour) {
    Vec3 light{0.};
    for (int c = 0; c < 3; ++c) light[c] = colour[c] > 0 ? product[c] / colour[c] : 0.;
    return light;
}
constexpr auto none = [](Pixel const&) { return Vec3(0.); };

void add_cycles_lights(Planes const& to, std::string const& layer) {
    to.add_colour(layer + "DiffCol.", [](Pixel const& p) { return p.diffuse_colour; });
    to.add_colour(layer + "DiffDir.", [](Pixel const& p) { return over(p.direct, p.diffuse_colour); });
    to.add_colour(layer + "DiffInd.", [](Pixel const& p) { return over(p.indirect, p.diffuse_colour); });
    to.add_colour(layer + "GlossCol.", [](Pixel const& p) { return p.gloss_colour; });
    to.add_colour(layer + "GlossDir.", none);
    to.add_colour(layer + "GlossInd.", [](Pixel const& p) { return over(p.gloss, p.gloss_colour); });
    auto const has = [&](Vec3 Pixel::*part) {
        return std::ranges::any_of(to.frame.pixels, [&](auto const& pixel) { return pixel.*part != Vec3(0.); });
    };
    if (has(&Pixel::clear)) {
        to.add_colour(layer + "TransCol.", [](Pixel const& p) { return p.clear_colour; });
        to.add_colour(layer + "TransDir.", none);
        to.add_colour(layer + "TransInd.", [](Pixel const& p) { return over(p.clear, p.clear_colour); });
    }
    if (has(&Pixel::volume)) {
        to.add_colour(layer + "VolumeDir.", [](Pixel const& p) { return p.volume; });
        to.add_colour(layer + "VolumeInd.", none);
    }
    to.add_colour(layer + "Emit.", [](Pixel const& p) { return p.glow; });
    to.add_colour(layer + "Env.", [](Pixel const& p) { return p.sky; });
}

/// A view layer as Blender's Cycles names it. Vectors have y up, and point from the next frame.
void add_cycles_layer(Planes const& to, std::string const& layer) {
    to.add_colour(layer + "Combined.", [](Pixel const& p) { return p.combined(); });
    to.add(layer + "Combined.A", [](Pixel const& p) { return p.alpha; });
    to.add(layer + "Depth.Z", [](Pixel const& p) { return p.depth; });
    add_cycles_lights(to, layer);
    to.add_colour(
        layer + "Normal.", [](Pixel const& p) { return p.normal; }, "XYZ");
    to.add(layer + "Vector.X", [](Pixel const& p) { return p.motion.x; });
    to.add(layer + "Vector.Y", [](Pixel const& p) { return -p.motion.y; });
    to.add(layer + "Vector.Z", [](Pixel const& p) { return -p.motion_next.x; });
    to.add(layer + "Vector.W", [](Pixel const& p) { return p.motion_next.y; });
}

void add_own_layer(Planes const& to) {
    to.add_colour("", [](Pixel const& p) { return p.combined(); });
    to.add_colour("albedo.", [](Pixel const& p) { return p.diffuse_colour + p.gloss_colour + Vec3(1 - p.covered); });
    to.add("depth.Z", [](Pixel const& p) { return p.depth < 1e9 ? p.depth : std::numeric_limits<double>::infinity(); });
    to.add_colour(
        "normal.", [](Pixel const& p) { return p.normal; }, "XYZ");
    to.add("motion.X", [](Pixel const& p) { return p.motion.x; });
    to.add("motion.Y", [](Pixel const& p) { return p.motion.y; });
    to.add("motion_next.X", [](Pixel const& p) { return p.motion_next.x; });
    to.add("motion_next.Y", [](Pixel const& p) { return p.motion_next.y; });
}

/// Random numbers of what is wrong with guides.
Random random_of(int frame, std::size_t pixel, int guide) { return Random({3 + guide, frame, static_cast<int>(pixel), 0, 0}); }

void break_normals(Rendered& frame, Fault fault, int number) {
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        auto& normal = frame.pixels[i].normal;
        auto random = random_of(number, i, 0);
        double const x = random.next(), y = random.next(), z = random.next();
        if (fault == Fault::noisy && normal != Vec3(0.)) normal = glm::normalize(normal + 0.9 * (2. * Vec3(x, y, z) - 1.));
        if (fault == Fault::zero) normal = Vec3(0.);
    }
}
void break_depth(Rendered& frame, Fault fault, int number) {
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        auto& depth = frame.pixels[i].depth;
        if (fault == Fault::zero) depth = 0;
        if (fault == Fault::noisy && depth < 1e9) depth *= 0.7 + 0.6 * random_of(number, i, 1).next();
    }
}
void break_albedo(Rendered& frame, Fault fault, int number) {
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        auto& pixel = frame.pixels[i];
        double const u = random_of(number, i, 2).next(), square = u * u;
        double const seen = 1 + 95 * square * square * square;
        if (fault == Fault::highlight && pixel.broken > 0) pixel.gloss_colour *= seen;
        if (fault == Fault::white && pixel.broken > 0) pixel.gloss_colour = glm::min(pixel.gloss_colour * seen, Vec3(1.));
        if (fault == Fault::noisy) pixel.diffuse_colour *= 0.4 + 1.2 * u;
        if (fault == Fault::zero) pixel.diffuse_colour = pixel.gloss_colour = Vec3(0.), pixel.covered = 1;
    }
}

void take_from(Rendered& frame, Rendered const& before, Shot const& shot) {
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        auto& pixel = frame.pixels[i];
        auto const& then = before.pixels[i];
        if (shot.vectors == Vectors::late) pixel.motion = then.motion, pixel.motion_next = then.motion_next;
        if (shot.faults.normal == Fault::of_frame_before) pixel.normal = then.normal;
        if (shot.faults.depth == Fault::of_frame_before) pixel.depth = then.depth;
        if (shot.faults.albedo == Fault::of_frame_before)
            pixel.diffuse_colour = then.diffuse_colour, pixel.gloss_colour = then.gloss_colour, pixel.covered = then.covered;
    }
}

Rendered with_faults(Shot const& shot, Making const& making, int frame) {
    auto made = rendered(shot, making, frame);
    if (shot.vectors == Vectors::late || shot.faults.has(Fault::of_frame_before)) take_from(made, rendered(shot, making, frame - 1), shot);
    break_normals(made, shot.faults.normal, frame), break_depth(made, shot.faults.depth, frame),
        break_albedo(made, shot.faults.albedo, frame);
    return made;
}

std::string said(double samples) { return std::to_string(std::max(1, static_cast<int>(std::lround(samples)))); }

} // namespace

std::string picture_layer(Shot const& shot) {
    if (shot.names == Names::own) return "";
    return shot.has_layers ? "Front.Combined." : "ViewLayer.Combined.";
}

io::ExrImage file_of(Shot const& shot, Making const& making, int frame) {
    auto const made = with_faults(shot, making, frame);
    io::ExrImage image{.name = "frame " + std::to_string(frame), .size = making.size};
    auto const type = shot.is_half ? io::SampleType::half : io::SampleType::float32;
    auto const count = said(std::max(making.samples * shot.says, static_cast<double>(shot.says_at_least)));
    auto const layer = std::string(shot.has_layers ? "Front" : "ViewLayer");
    if (shot.says > 0) image.attributes["cycles." + layer + ".samples"] = count;
    Planes const to{image, made, type};
    if (shot.names == Names::own) return add_own_layer(to), image;
    if (shot.has_layers) {
        auto const clean = reference(shot, making, frame);
        image.attributes["cycles.Back.samples"] = said(100. * making.samples);
        add_cycles_layer(Planes{image, clean, type}, "Back.");
    }
    add_cycles_layer(to, layer + ".");
    return image;
}

} // namespace quell::gauntlet

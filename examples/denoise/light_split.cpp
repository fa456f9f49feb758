#include <denoise/guide_noise.hpp>
#include <denoise/light_split.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace quell::examples {

namespace {

using Pixels = std::vector<glm::vec3>;

/// A noisy guide's error may be this part of what its structure would lose.
constexpr float tolerated_noise = 0.245f;
/// What loses less than this part of the guides' noise goes with them.
constexpr float small_loss = 1.f;

std::vector<io::Source> ones() { return std::vector<io::Source>(3, io::Source{{}, 1.f}); }
bool is_constant(std::vector<io::Source> const& sources) {
    return std::ranges::all_of(sources, [](auto const& source) { return source.sum.empty(); });
}
bool is_usable(glm::vec3 const& p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); }

/// How far a number may be from what was stored.
struct Rounding {
    float relative = 0, absolute = 0;

    Rounding(io::ExrImage const& image, std::vector<io::Source> const& sources) {
        for (auto const& source : sources)
            for (auto const& name : source.sum) {
                bool const half = image[name].type == io::SampleType::half;
                relative = std::max(relative, std::ldexp(1.f, half ? -11 : -24));
                absolute += half ? std::ldexp(std::abs(source.scale), -25) : 0.f;
            }
    }
    [[nodiscard]] float of(float value) const { return std::abs(value) * relative + absolute; }
};

/// A signal as a part of the picture: light times what it is multiplied by.
struct Part {
    metrics::Picture light, factor, picture;
    metrics::Picture colour; ///< that is taken as it is where the signal is denoised by itself; empty: none
    Pixels rounding;         ///< of the picture
};

Part part_of(io::ExrImage const& image, io::SignalNames const& signal, bool by_albedo) {
    auto const light = io::sources_of(signal.channels, radiance), own = io::sources_of(signal.channels, albedo);
    Part part{picture_of(image, light, 0.f), picture_of(image, signal.factor, 1.f), {image.size, {}}, {}, {}};
    if (!signal.factor.empty())
        part.colour = part.factor;
    else if (by_albedo && !is_constant(own))
        part.colour = picture_of(image, own, 1.f);
    Rounding const of_light(image, light), of_factor(image, signal.factor);
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        auto const &l = part.light.pixels[i], &f = part.factor.pixels[i];
        part.picture.pixels.push_back(l * f);
        auto& error = part.rounding.emplace_back();
        for (int c = 0; c < 3; ++c) error[c] = std::abs(f[c]) * of_light.of(l[c]) + std::abs(l[c]) * of_factor.of(f[c]);
    }
    return part;
}

/// A frame while its light is divided.
class Splitting {
    io::ExrImage& image;
    io::SequenceNames const& names;
    SplitRule const& rule;
    std::vector<Part> parts;
    metrics::Picture added, whole, rest;
    bool has_rest = false, has_less_light = false, has_less_added = false;
    Pixels rounding; ///< of the sum

public:
    Splitting(io::ExrImage& frame, io::SequenceNames const& n, SplitRule const& r)
        : image(frame), names(n), rule(r),
          added(picture_of(frame, n.added, 0.f)), rest{frame.size, Pixels(frame.pixels(), glm::vec3(0.f))} {
        for (auto const& signal : names.of_signals) parts.push_back(part_of(image, signal, rule.by_albedo));
        add_up();
        if (knows_picture()) compare(picture_of(image, names.picture, 0.f));
    }

    LightSplit split() {
        LightSplit result{names.of_signals, choose(), names.added};
        bool const adds = result.active.back();
        result.active.pop_back();
        for (std::size_t s = 0; s < parts.size(); ++s)
            if (!result.active[s])
                give_to_rest(parts[s].picture);
            else if (has_less_light)
                result.signals[s].channels.sources["radiance"] = put("signal " + std::to_string(s), parts[s].light);
        if (!adds)
            give_to_rest(added), result.added.clear();
        else if (has_less_added)
            result.added = put("added", added);
        auto last = names.of_signals[0];
        last.name = rest_name, last.factor.clear();
        last.channels.sources["albedo"] = ones();
        if (has_rest) last.channels.sources["radiance"] = put("rest", rest);
        result.signals.push_back(std::move(last));
        result.active.push_back(has_rest);
        return result;
    }

private:
    [[nodiscard]] bool knows_picture() const {
        return !names.picture.empty() &&
               std::ranges::all_of(io::planes_of(names.picture), [&](auto const& plane) { return image.find(plane) != nullptr; });
    }
    /// The sum of all parts, and how far rounding may take it from the picture.
    void add_up() {
        Rounding const of_added(image, names.added);
        whole = added;
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            auto& error = rounding.emplace_back();
            for (int c = 0; c < 3; ++c) error[c] = of_added.of(added.pixels[i][c]);
            for (auto const& part : parts) whole.pixels[i] += part.picture.pixels[i], error += part.rounding[i];
        }
    }
    /// Where the parts are less than the picture there is a rest; where they are more, they are scaled down.
    void compare(metrics::Picture const& picture) {
        Rounding const of_picture(image, names.picture);
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            auto const &sum = whole.pixels[i], &target = picture.pixels[i];
            if (!is_usable(sum) || !is_usable(target)) continue;
            for (int c = 0; c < 3; ++c) {
                // Sums of sums are rounded as well.
                float const tolerated = 2.f * (rounding[i][c] + of_picture.of(target[c]));
                if (sum[c] > target[c] + tolerated) scale_down(i, c, target[c]);
                if (sum[c] < target[c] - tolerated) leave(i, c, target[c] - sum[c]);
            }
        }
        whole = picture;
    }
    void leave(std::size_t i, int c, float light) { rest.pixels[i][c] += light, has_rest = true; }
    void scale_down(std::size_t i, int c, float target) {
        auto& extra = added.pixels[i][c];
        float signals = 0;
        for (auto const& part : parts) signals += part.picture.pixels[i][c];
        if (extra > 0.f) extra = std::clamp(target - signals, 0.f, extra), has_less_added = true;
        float const left = target - extra;
        if (signals <= left) return;
        has_less_light = true;
        float const share = left > 0.f && signals > 0.f ? left / signals : 0.f;
        for (auto& part : parts) part.picture.pixels[i][c] *= share, part.light.pixels[i][c] *= share;
        if (left < 0.f) leave(i, c, left);
    }
    void give_to_rest(metrics::Picture const& part) {
        for (std::size_t i = 0; i < part.pixels.size(); ++i) rest.pixels[i] += part.pixels[i];
        has_rest = true;
    }
    /// Which of the signals, and last whether what is added, stays out of the rest.
    [[nodiscard]] std::vector<bool> choose() const {
        std::vector<bool> stays(parts.size() + 1, true);
        if (!rule.finds_noise) return stays;
        std::vector<GuideErrors> errors;
        for (auto const& part : parts)
            errors.push_back(part.colour.pixels.empty() ? GuideErrors{}
                                                        : guide_errors(part.colour, GuideKind::factor, part.picture, whole));
        errors.push_back(names.added.empty() ? GuideErrors{} : guide_errors(added, GuideKind::added, whole, whole));
        float noise = 0;
        for (std::size_t s = 0; s < errors.size(); ++s)
            if (errors[s].noise > tolerated_noise * errors[s].loss) stays[s] = false, noise += errors[s].noise;
        // What is a smaller part of the picture's error than that is filtered best together with it.
        for (std::size_t s = 0; s < errors.size() && noise > 0.f; ++s)
            if (errors[s].loss < small_loss * noise) stays[s] = false;
        return stays;
    }
    std::vector<io::Source> put(std::string const& name, metrics::Picture const& picture) {
        std::vector<io::Source> sources;
        for (int c = 0; c < 3; ++c) {
            io::Plane plane{.name = "quell:" + name + "." + "RGB"[c], .values = {}};
            for (auto const& pixel : picture.pixels) plane.values.push_back(pixel[c]);
            sources.push_back({{plane.name}});
            image.planes.push_back(std::move(plane));
        }
        return sources;
    }
};

/// Mean over the (2 radius + 1)^2 pixels around each, as far as they are in the picture.
metrics::Picture box_mean(metrics::Picture const& picture, int radius) {
    auto const along = [radius](metrics::Picture const& from, bool rows) {
        metrics::Picture to{from.size, Pixels(from.pixels.size())};
        int const length = rows ? from.size.width : from.size.height, lines = rows ? from.size.height : from.size.width;
        auto const index = [&](int line, int i) {
            return rows ? static_cast<std::size_t>(line) * static_cast<std::size_t>(from.size.width) + static_cast<std::size_t>(i)
                        : static_cast<std::size_t>(i) * static_cast<std::size_t>(from.size.width) + static_cast<std::size_t>(line);
        };
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i) {
                glm::vec3 sum(0.f);
                int const first = std::max(i - radius, 0), last = std::min(i + radius, length - 1);
                for (int j = first; j <= last; ++j) sum += from.pixels[index(line, j)];
                to.pixels[index(line, i)] = sum / static_cast<float>(last - first + 1);
            }
        return to;
    };
    return along(along(picture, true), false);
}

/// Whether there is one picture, which is not divided by anything and is all there is.
bool is_simple(io::SequenceNames const& names, SplitRule const& rule) {
    if (has_several_signals(names) || !names.picture.empty()) return false;
    auto const& only = names.of_signals[0];
    return only.factor.empty() && !(rule.by_albedo && !is_constant(io::sources_of(only.channels, albedo)));
}

} // namespace

metrics::Picture picture_of(io::ExrImage const& image, std::vector<io::Source> const& sources, float otherwise) {
    if (sources.empty()) return {image.size, Pixels(image.pixels(), glm::vec3(otherwise))};
    std::array<std::vector<float>, 3> components;
    for (std::size_t c = 0; c < 3; ++c) components[c] = io::component_of(image, sources[c]);
    metrics::Picture picture{image.size, {}};
    for (std::size_t i = 0; i < image.pixels(); ++i) picture.pixels.emplace_back(components[0][i], components[1][i], components[2][i]);
    return picture;
}

bool has_several_signals(io::SequenceNames const& names) { return names.of_signals.size() > 1 || !names.added.empty(); }

std::vector<std::string> split_planes(io::ExrFile const& file, io::SequenceNames const& names) {
    auto planes = io::planes_of(names.added);
    auto const want = [&](std::vector<io::Source> const& sources) {
        auto const more = io::planes_of(sources);
        planes.insert(planes.end(), more.begin(), more.end());
    };
    for (auto const& signal : names.of_signals) want(signal.factor);
    if (file.has_all(io::planes_of(names.picture))) want(names.picture);
    return planes;
}

RestShares rest_shares(io::ExrImage const& image, LightSplit const& split, io::SequenceNames const& names, SplitRule const& rule) {
    constexpr int radius = 7; // pixels: single samples of the rest don't say much of what it is made of
    RestShares result;
    auto const rest = split.active.back() ? io::sources_of(split.signals.back().channels, radiance) : std::vector<io::Source>();
    auto const whole = box_mean(picture_of(image, rest, 0.f), radius);
    for (std::size_t s = 0; s < names.of_signals.size(); ++s) {
        auto const part = part_of(image, names.of_signals[s], rule.by_albedo);
        auto const none = metrics::Picture{image.size, Pixels(image.pixels(), glm::vec3(1.f))};
        result.colours.push_back(part.colour.pixels.empty() ? none : part.colour);
        auto& shares = result.shares.emplace_back();
        if (split.active[s]) continue;
        shares = box_mean(part.picture, radius);
        for (std::size_t i = 0; i < shares.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                shares.pixels[i][c] = whole.pixels[i][c] > 0.f ? std::clamp(shares.pixels[i][c] / whole.pixels[i][c], 0.f, 1.f) : 0.f;
    }
    return result;
}

LightSplit split_light(io::ExrImage& image, io::SequenceNames const& names, SplitRule const& rule) {
    if (!is_simple(names, rule)) return Splitting(image, names, rule).split();
    return {names.of_signals, std::vector<bool>(names.of_signals.size(), true), names.added};
}

} // namespace quell::examples

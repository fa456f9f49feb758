#include <denoise/guide_noise.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/light_split.hpp>
#include <denoise/unlit_film.hpp>

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>
#include <quell/io/frame_image.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace quell::examples {

namespace {

/// The noise of guides may be this part of what a filter would lose of their structure. Between 0.24, where renders with depth of field,
/// fog, leaves and textures still had less error with guides as they are, and 0.26, where they had more (bench/cycles.sh).
constexpr float tolerated_noise = 0.25f;
/// The same of the rest's noise: no guide tells it from structure where it is filtered alone. Between 0.3 (wide gamut at 8 samples), where
/// renders had less error by their parts, and 0.9 (the same at 1 sample), where they had more; of glass it is 5 to 66 (bench/cycles.sh).
constexpr float tolerated_rest = 0.75f;

std::vector<io::Source> ones() { return std::vector<io::Source>(3, io::Source{{}, 1.f}); }
bool is_constant(std::vector<io::Source> const& sources) { return io::planes_of(sources).empty(); }

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
    ReadPicture light, factor;
    LinearPicture picture;
    ReadPicture colour{}; ///< that is taken as it is where the signal is denoised by itself; empty: none
    LinearPicture less{}; ///< light that is scaled down; empty: it is not
    Rounding of_light, of_factor;

    /// Of a component of the picture.
    [[nodiscard]] float rounding(int c, std::size_t i) const {
        float const l = light.at(c, i), f = factor.at(c, i);
        return std::abs(f) * of_light.of(l) + std::abs(l) * of_factor.of(f);
    }
};

Part part_of(io::ExrImage const& image, io::SignalNames const& signal, bool by_albedo) {
    auto const light = io::sources_of(signal.channels, radiance), own = io::sources_of(signal.channels, albedo);
    Part part{.light = light_of(image, signal),
              .factor = picture_of(image, signal.factor, 1.f),
              .picture = LinearPicture(image.size),
              .of_light = {image, light},
              .of_factor = {image, signal.factor}};
    if (!signal.factor.empty())
        part.colour = part.factor;
    else if (by_albedo && !is_constant(own))
        part.colour = picture_of(image, own, 1.f);
    for (std::size_t i = 0; i < image.pixels(); ++i) part.picture[i] = part.light[i] * part.factor[i];
    return part;
}

/// Mean over the (2 radius + 1)^2 pixels around each, as far as they are in the picture.
LinearPicture box_mean(LinearView const& picture, int radius) {
    auto const along = [radius](LinearView const& from, bool rows) {
        LinearPicture to(from.size);
        int const length = rows ? from.size.width : from.size.height, lines = rows ? from.size.height : from.size.width;
        auto const index = [&](int line, int i) {
            return rows ? static_cast<std::size_t>(line) * static_cast<std::size_t>(from.size.width) + static_cast<std::size_t>(i)
                        : static_cast<std::size_t>(i) * static_cast<std::size_t>(from.size.width) + static_cast<std::size_t>(line);
        };
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i) {
                glm::vec3 sum(0.f);
                int const first = std::max(i - radius, 0), last = std::min(i + radius, length - 1);
                for (int j = first; j <= last; ++j) sum += from[index(line, j)];
                to[index(line, i)] = sum / static_cast<float>(last - first + 1);
            }
        return to;
    };
    return along(along(picture, true), false);
}

/// A frame while its light is divided.
class Splitting {
    io::ExrImage const& image;
    io::SequenceNames const& names;
    SplitRule const& rule;
    std::vector<Part> parts;
    LinearPicture added, rest;
    ReadPicture whole;
    bool has_rest = false, has_less_light = false, has_less_added = false;

public:
    std::vector<io::Plane> made; ///< of the split

    Splitting(io::ExrImage const& frame, io::SequenceNames const& n, SplitRule const& r)
        : image(frame), names(n), rule(r), added(picture_of(frame, n.added, 0.f)), rest(frame.size) {
        for (auto const& signal : names.of_signals) parts.push_back(part_of(image, signal, rule.by_albedo));
        LinearPicture sum(added);
        for (auto const& part : parts)
            for (std::size_t k = 0; k < sum.values.size(); ++k) sum.values[k] += part.picture.values[k];
        whole = knows_picture() ? picture_of(image, names.picture, 0.f) : ReadPicture();
        if (!whole.empty())
            compare(sum);
        else
            whole = ReadPicture(std::move(sum));
    }

    LightSplit split(bool as_one) {
        LightSplit result{names.of_signals, std::vector<bool>(parts.size(), !as_one), names.added, {}};
        if (as_one) {
            for (auto const& part : parts) give_to_rest(part.picture);
            give_to_rest(added);
            result.added.clear();
        } else {
            for (std::size_t s = 0; s < parts.size() && has_less_light; ++s)
                put_light(result.signals[s], "signal " + std::to_string(s), parts[s].less);
            if (has_less_added) result.added = put("added", added);
            for (std::size_t s = 0; s < parts.size() && !rule.film.empty(); ++s) hide_factor(result.signals[s], parts[s], s);
        }
        auto last = names.of_signals[0];
        last.name = rest_name, last.factor.clear();
        last.channels.sources["albedo"] = ones();
        if (has_rest) put_light(last, as_one ? "all" : "rest", rest);
        result.signals.push_back(std::move(last));
        result.active.push_back(has_rest);
        if (!rule.alpha.empty()) divide_alpha(result, as_one ? "quell:all.A" : "quell:rest.A");
        return result;
    }

    /// They have samples in common, so that what one of them loses another gains: one answer for all.
    [[nodiscard]] bool is_better_as_one() const {
        auto const source = io::sources_of(names.of_signals[0].channels, quell::depth)[0];
        bool const knows_depth = image.has_all(source.sum);
        auto const depth = knows_depth ? io::component_of(image, source) : std::vector<float>();
        float noise = 0, loss = 0;
        auto const count = [&](GuideErrors const& errors) { noise += errors.noise, loss += errors.loss; };
        for (auto const& part : parts)
            if (!part.colour.empty()) count(guide_errors(part.colour, GuideKind::factor, part.picture, whole, depth));
        if (!names.added.empty()) count(guide_errors(added, GuideKind::added, whole, whole, depth));
        float const of_rest = has_rest ? guide_errors(rest, GuideKind::added, rest, whole, {}).noise : 0.f;
        return noise > tolerated_noise * rule.samples_of_guides * loss || of_rest > tolerated_rest * loss;
    }

    [[nodiscard]] ReadPicture const& picture() const { return whole; }

    [[nodiscard]] SignalShares shares() const {
        constexpr int radius = 7, colour_radius = 2; // pixels: single samples don't say much of what the picture is made of
        SignalShares result;
        auto const all = box_mean(whole, radius);
        LinearPicture const none(image.size, 1.f);
        auto const add = [&](LinearView const& colour, LinearView const& light) {
            result.colours.push_back(colour.empty() ? none : box_mean(colour, colour_radius));
            auto& share = result.shares.emplace_back(box_mean(light, radius));
            for (std::size_t k = 0; k < share.values.size(); ++k)
                share.values[k] = all.values[k] > 0.f ? std::clamp(share.values[k] / all.values[k], 0.f, 1.f) : 0.f;
        };
        for (auto const& part : parts) add(part.colour, part.picture);
        add({}, rest);
        result.added = box_mean(added, colour_radius);
        return result;
    }

private:
    [[nodiscard]] bool knows_picture() const { return !names.picture.empty() && image.has_all(io::planes_of(names.picture)); }
    /// Where the parts are less than the picture there is a rest; where they are more, they are scaled down.
    void compare(LinearView const& sums) {
        Rounding const of_picture(image, names.picture), of_added(image, names.added);
        for (std::size_t i = 0; i < sums.pixels(); ++i) {
            auto const sum = sums[i], target = whole[i];
            if (!all_finite(sum) || !all_finite(target)) continue;
            for (int c = 0; c < 3; ++c) {
                float rounding = of_added.of(added.at(c, i));
                for (auto const& part : parts) rounding += part.rounding(c, i);
                // Sums of sums are rounded as well.
                float const tolerated = 2.f * (rounding + of_picture.of(target[c]));
                if (sum[c] > target[c] + tolerated) scale_down(i, c, target[c]);
                if (sum[c] < target[c] - tolerated) leave(i, c, target[c] - sum[c]);
            }
        }
    }
    void begin_to_scale(std::size_t s) {
        LayoutChanges::Of const of(names.of_signals[s].name);
        parts[s].less = LinearPicture(parts[s].light);
    }
    void leave(std::size_t i, int c, float light) { rest.at(c, i) += light, has_rest = true; }
    void scale_down(std::size_t i, int c, float target) {
        auto& extra = added.at(c, i);
        float signals = 0;
        for (auto const& part : parts) signals += part.picture.at(c, i);
        if (extra > 0.f) extra = std::clamp(target - signals, 0.f, extra), has_less_added = true;
        float const left = target - extra;
        if (signals <= left) return;
        has_less_light = true;
        float const share = left > 0.f && signals > 0.f ? left / signals : 0.f;
        for (std::size_t s = 0; s < parts.size(); ++s) {
            if (parts[s].less.empty()) begin_to_scale(s);
            parts[s].picture.at(c, i) *= share, parts[s].less.at(c, i) *= share;
        }
        if (left < 0.f) leave(i, c, left);
    }
    /// Light that filters spread stays off what the film does not show.
    void hide_factor(io::SignalNames& signal, Part const& part, std::size_t s) {
        if (signal.factor.empty()) return;
        LinearPicture factor(part.factor);
        bool is_changed = false;
        auto const& film = image[rule.film].values;
        for (std::size_t i = 0; i < factor.pixels(); ++i) {
            if (film[i] != 0.f || whole[i] != glm::vec3(0.f) || glm::vec3(factor[i]) == glm::vec3(0.f)) continue;
            factor[i] = glm::vec3(0.f), is_changed = true;
        }
        if (is_changed) signal.factor = put("factor " + std::to_string(s), factor);
    }
    /// Alpha goes where the light goes, and is a signal of its own where there is none.
    void divide_alpha(LightSplit& result, std::string const& name) {
        bool const is_only = !has_several_signals(names) && names.of_signals[0].factor.empty() && result.active[0];
        auto const carrier = is_only ? 0 : parts.size();
        bool const is_one_picture = is_only || !result.active[0];
        auto const alpha = alpha_with_light(result, is_one_picture, name + ".own");
        if (!rule.carries_alpha || !result.active[carrier]) {
            result.kept_alpha = alpha;
            return;
        }
        auto const& light = is_only ? parts[0].picture : rest;
        bool const is_all = std::ranges::count(result.active, true) == 1 && result.added.empty();
        result.shares_alpha = !is_all;
        std::vector<float> with_light;
        for (std::size_t i = 0; i < alpha.size(); ++i) {
            float const all = luminance(whole[i]);
            float const share = is_all ? 1.f : all > 0.f ? std::clamp(luminance(light[i]) / all, 0.f, 1.f) : 0.f;
            with_light.push_back(alpha[i] * share);
            result.kept_alpha.push_back(is_finite(alpha[i]) ? alpha[i] * (1.f - share) : 0.f);
        }
        auto& sources = result.signals[carrier].channels.sources;
        auto four = io::sources_of(result.signals[carrier].channels, radiance);
        four.push_back({{name}});
        sources[std::string(radiance_alpha.name)] = four;
        result.alpha_with = carrier;
        // The denoiser of the rest takes alpha, since in other frames it has it. Nobody reads what it makes of this one.
        if (is_only && has_rest) {
            auto with_none = io::sources_of(result.signals.back().channels, radiance);
            with_none.push_back({{}, 1.f});
            result.signals.back().channels.sources[std::string(radiance_alpha.name)] = with_none;
        }
        made.push_back({.name = name, .values = std::move(with_light)});
    }
    /// The part of alpha that light speaks for. The other one becomes a signal of its own.
    std::vector<float> alpha_with_light(LightSplit& result, bool is_one_picture, std::string const& name) {
        auto with_light = image[rule.alpha].values;
        if (std::ranges::all_of(with_light, [](float a) { return a == 1.f; })) return with_light;
        auto own = with_light;
        auto unlit = unlit_film(lit(is_one_picture), image, names.of_signals[0].channels);
        bool has_own = false;
        for (std::size_t i = 0; i < own.size(); ++i) {
            has_own = has_own || (unlit[i] && own[i] != 0.f);
            if (unlit[i])
                with_light[i] = 0.f;
            else
                own[i] = std::numeric_limits<float>::quiet_NaN();
        }
        if (!has_own) return image[rule.alpha].values;
        result.own_alpha = std::move(unlit);
        result.names_of_own_alpha = names.of_signals[0].channels;
        auto& sources = result.names_of_own_alpha.sources;
        sources["radiance"] = std::vector<io::Source>(3, io::Source{{name}});
        sources["albedo"] = ones();
        made.push_back({.name = name, .values = std::move(own)});
        return with_light;
    }
    /// Which pixels have light that alpha belongs to: of one picture all light, else that which is multiplied by colours as they are, or
    /// added. The light of a volume, which is denoised by itself, says nothing of alpha.
    [[nodiscard]] std::vector<bool> lit(bool is_one_picture) const {
        std::vector<bool> is_lit;
        for (std::size_t i = 0; i < whole.pixels(); ++i) {
            glm::vec3 light = is_one_picture ? whole[i] : glm::vec3(added[i]) + glm::vec3(rest[i]);
            for (auto const& part : parts)
                if (!is_one_picture && !part.colour.empty()) light += part.picture[i];
            is_lit.push_back(light != glm::vec3(0.f));
        }
        return is_lit;
    }
    void give_to_rest(LinearPicture const& part) {
        for (std::size_t k = 0; k < part.values.size(); ++k) rest.values[k] += part.values[k];
        has_rest = true;
    }
    std::vector<io::Source> put(std::string const& name, LinearView const& picture) { return put_picture(made, name, picture); }
    void put_light(io::SignalNames& signal, std::string const& name, LinearView const& light) {
        LayoutChanges::Of const of(signal.name);
        signal.channels.sources["radiance"] = put(name, light);
    }
};

/// Whether there is one picture, which is not divided by anything and is all there is.
bool is_simple(io::SequenceNames const& names, SplitRule const& rule) {
    if (has_several_signals(names) || !names.picture.empty() || !rule.alpha.empty()) return false;
    auto const& only = names.of_signals[0];
    return only.factor.empty() && !(rule.by_albedo && !is_constant(io::sources_of(only.channels, albedo)));
}

} // namespace

ReadPicture picture_of(io::ExrImage const& image, std::vector<io::Source> const& sources, float otherwise) {
    if (sources.empty()) return ReadPicture(LinearPicture(image.size, otherwise));
    bool const are_planes =
        std::ranges::all_of(sources, [](auto const& s) { return s.sum.size() == 1 && s.scale == 1.f && s.offset == 0.f; });
    if (!are_planes) {
        LinearPicture picture(image.size);
        for (std::size_t c = 0; c < 3; ++c) {
            std::span const to(picture.target().planes[c], image.pixels());
            if (sources[c].sum.empty() || sources[c].offset != 0.f) {
                std::ranges::copy(io::component_of(image, sources[c]), to.begin());
                continue;
            }
            for (bool is_first = true; auto const& name : sources[c].sum) {
                auto const& values = io::detail::plane_for(image, name, false).values;
                for (std::size_t i = 0; i < to.size(); ++i) to[i] = is_first ? values[i] : to[i] + values[i];
                is_first = false;
            }
            for (auto& value : to) value *= sources[c].scale;
        }
        return ReadPicture(std::move(picture));
    }
    LinearView where{image.size};
    for (std::size_t c = 0; c < 3; ++c) where.planes[c] = io::detail::plane_for(image, sources[c].sum[0], false).values.data();
    return ReadPicture(where);
}

ReadPicture light_of(io::ExrImage const& image, io::SignalNames const& signal, float otherwise) {
    return picture_of(image, io::sources_of(signal.channels, radiance), otherwise);
}

std::vector<io::Source> put_picture(std::vector<io::Plane>& planes, std::string const& name, LinearView const& picture) {
    LayoutChanges::add();
    std::vector<io::Source> sources;
    for (std::size_t c = 0; c < 3; ++c) {
        auto const* const values = picture.planes[c];
        planes.push_back({.name = "quell:" + name + "." + "RGB"[c], .values = {values, values + picture.pixels()}});
        sources.push_back({{planes.back().name}});
    }
    return sources;
}

std::vector<io::Source> put_picture(io::ExrImage& image, std::string const& name, LinearView const& picture,
                                    std::vector<io::Source> const& instead_of) {
    auto const type = image[io::planes_of(instead_of).front()].type;
    auto sources = put_picture(image.planes, name, picture);
    for (auto plane = image.planes.end() - 3; plane != image.planes.end(); ++plane) plane->type = type;
    return sources;
}

bool has_several_signals(io::SequenceNames const& names) { return names.of_signals.size() > 1 || !names.added.empty(); }

std::vector<std::string> split_planes(io::ExrListing const& file, io::SequenceNames const& names) {
    auto planes = io::planes_of(names.added);
    auto const want = [&](std::vector<io::Source> const& sources) {
        auto const more = io::planes_of(sources);
        planes.insert(planes.end(), more.begin(), more.end());
    };
    for (auto const& signal : names.of_signals) want(signal.factor);
    if (file.has_all(io::planes_of(names.picture))) want(names.picture);
    return planes;
}

ReadPicture whole_picture(io::ExrImage const& image, io::SequenceNames const& names) { return Splitting(image, names, {}).picture(); }

SignalShares signal_shares(io::ExrImage const& image, io::SequenceNames const& names, SplitRule const& rule) {
    return Splitting(image, names, rule).shares();
}

bool is_better_as_one(io::ExrImage const& image, io::SequenceNames const& names, SplitRule const& rule) {
    return !is_simple(names, rule) && Splitting(image, names, rule).is_better_as_one();
}

LightSplit split_light(io::ExrImage& image, io::SequenceNames const& names, SplitRule const& rule, bool as_one) {
    if (is_simple(names, rule)) return {names.of_signals, std::vector<bool>(names.of_signals.size(), true), names.added, {}};
    Splitting splitting(image, names, rule);
    auto split = splitting.split(as_one);
    for (auto& plane : splitting.made) image.planes.push_back(std::move(plane));
    return split;
}

} // namespace quell::examples

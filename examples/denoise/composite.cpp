#include <denoise/composite.hpp>
#include <denoise/map_file.hpp>

#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/io/part_names.hpp>

#include <algorithm>
#include <array>

namespace quell::examples {

namespace {

/// A colour, or black where it is not finite, which is counted.
glm::vec3 finite(glm::vec3 const& p, long long& missing) {
    if (all_finite(p)) return p;
    ++missing;
    return glm::vec3(0.f);
}
void drop_non_finite(LinearPicture& picture, long long& missing) {
    for (std::size_t i = 0; i < picture.pixels(); ++i) picture[i] = finite(picture[i], missing);
}

/// All planes of the picture itself, without guides.
std::vector<std::string> picture_planes(io::ExrListing const& file, io::SequenceNames const& names) {
    auto planes = split_planes(file, names);
    for (auto const& signal : names.of_signals) {
        auto const more = io::planes_of(Channels<Radiance>{}, signal.channels);
        planes.insert(planes.end(), more.begin(), more.end());
    }
    return planes;
}

/// The names that a converged frame goes by.
io::SequenceNames names_of_reference(io::ExrListing const& file, ReferenceNames const& names) {
    for (auto const& choice : names.any_of)
        if (file.has_all(picture_planes(file, choice))) return choice;
    if (names.or_recognised) return recognised(file);
    return names.any_of.at(0); // reading it says what it lacks
}

} // namespace

LinearPicture composite(io::ExrImage const& image, LightSplit const& split, std::function<ReadPicture(std::size_t)> const& signal,
                        long long& missing, std::vector<LinearPicture>& parts, Resolve const& resolve) {
    parts.clear();
    auto const added = picture_of(image, split.added, 0.f);
    std::optional<LinearPicture> off; // what anti-aliasing changes of what is added
    LinearPicture sum(image.size);
    auto const anti_aliased = resolve && !split.added.empty() ? resolve(split.signals.size() - 1, nullptr) : std::nullopt;
    if (anti_aliased) off.emplace(image.size);
    for (std::size_t i = 0; i < sum.pixels(); ++i) {
        if (off) (*off)[i] = finite((*anti_aliased)[i] - added[i], missing);
        sum[i] = finite(anti_aliased ? (*anti_aliased)[i] : added[i], missing);
    }
    for (std::size_t s = 0; s < split.signals.size(); ++s) {
        if (!split.active[s]) {
            parts.emplace_back(image.size);
            continue;
        }
        auto const light = signal(s);
        auto const& of_factor = split.signals[s].factor;
        auto resolved = resolve && !of_factor.empty() ? resolve(s, &light) : std::nullopt;
        auto const factor = resolved ? ReadPicture() : picture_of(image, of_factor, 1.f);
        auto& part = parts.emplace_back(resolved ? std::move(*resolved) : light.in_place());
        for (std::size_t i = 0; i < sum.pixels(); ++i) {
            part[i] = resolved ? finite(part[i], missing) : light[i] * finite(factor[i], missing);
            sum[i] += part[i];
        }
    }
    drop_non_finite(sum, missing); // numbers that are finite can have a product that isn't
    // The parts and what the file adds are to make up the picture.
    if (off && !parts.empty())
        for (std::size_t k = 0; k < off->values.size(); ++k) parts.back().values[k] += off->values[k];
    return sum;
}

LinearPicture read_reference(std::filesystem::path const& path, ReferenceNames const& any) {
    io::ExrFile const file(path);
    auto const names = io::names_in_parts(names_of_reference(file, any), file);
    auto image = file.read(picture_planes(file, names));
    auto const split = split_light(image, names, {}, false);
    long long ignored = 0;
    std::vector<LinearPicture> parts;
    return composite(
        image, split, [&](std::size_t s) { return light_of(image, split.signals[s]); }, ignored, parts);
}

LinearPicture read_reference(std::filesystem::path const& path, ReferenceNames const& names, Extent size) {
    auto reference = read_reference(path, names);
    if (reference.size == size) return reference;
    throw Error(path.string(), "it is " + to_string(reference.size) + " but the frame is " + to_string(size),
                "compare pictures of one size");
}

std::vector<long long> numbers_of_references(FramePattern const& references, FrameRange const& frames) {
    auto numbers = references.on_disk(frames.first, frames.last);
    if (!numbers.empty()) return numbers;
    throw Error(references.text(), "there is none for frames " + std::to_string(frames.first) + " to " + std::to_string(frames.last),
                "give converged frames with the numbers of the noisy ones");
}

} // namespace quell::examples

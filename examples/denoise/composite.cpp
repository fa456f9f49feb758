#include <denoise/composite.hpp>
#include <denoise/map_file.hpp>

#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/io/part_names.hpp>

#include <algorithm>
#include <array>

namespace quell::examples {

namespace {

void drop_non_finite(metrics::Picture& picture, long long& missing) {
    for (auto& p : picture.pixels) {
        if (is_finite(p.x) && is_finite(p.y) && is_finite(p.z)) continue;
        p = glm::vec3(0.f);
        ++missing;
    }
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

metrics::Picture composite(io::ExrImage const& image, LightSplit const& split, std::function<metrics::Picture(std::size_t)> const& signal,
                           long long& missing, std::vector<metrics::Picture>& parts, Resolve const& resolve) {
    parts.clear();
    auto sum = picture_of(image, split.added, 0.f);
    auto off = picture_of(image, {}, 0.f); // what anti-aliasing changes of what is added
    if (resolve && !split.added.empty())
        if (auto resolved = resolve(split.signals.size() - 1, nullptr)) {
            off = *resolved;
            for (std::size_t i = 0; i < off.pixels.size(); ++i) off.pixels[i] -= sum.pixels[i];
            drop_non_finite(off, missing);
            sum = std::move(*resolved);
        }
    drop_non_finite(sum, missing);
    for (std::size_t s = 0; s < split.signals.size(); ++s) {
        auto& part = parts.emplace_back(split.active[s] ? signal(s) : picture_of(image, {}, 0.f));
        if (!split.active[s]) continue;
        if (resolve && !split.signals[s].factor.empty())
            if (auto resolved = resolve(s, &part)) {
                part = std::move(*resolved);
                drop_non_finite(part, missing);
                for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += part.pixels[i];
                continue;
            }
        auto factor = picture_of(image, split.signals[s].factor, 1.f);
        drop_non_finite(factor, missing);
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
            part.pixels[i] *= factor.pixels[i];
            sum.pixels[i] += part.pixels[i];
        }
    }
    drop_non_finite(sum, missing); // numbers that are finite can have a product that isn't
    // The parts and what the file adds are to make up the picture.
    if (!parts.empty())
        for (std::size_t i = 0; i < off.pixels.size(); ++i) parts.back().pixels[i] += off.pixels[i];
    return sum;
}

metrics::Picture read_reference(std::filesystem::path const& path, ReferenceNames const& any) {
    io::ExrFile const file(path);
    auto const names = io::names_in_parts(names_of_reference(file, any), file);
    auto image = file.read(picture_planes(file, names));
    auto const split = split_light(image, names, {}, false);
    long long ignored = 0;
    std::vector<metrics::Picture> parts;
    return composite(
        image, split, [&](std::size_t s) { return light_of(image, split.signals[s]); }, ignored, parts);
}

metrics::Picture read_reference(std::filesystem::path const& path, ReferenceNames const& names, Extent size) {
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

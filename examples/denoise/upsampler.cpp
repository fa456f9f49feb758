#include <denoise/seen_frame.hpp>
#include <denoise/upsampler.hpp>

#include <quell/core/real.hpp>
#include <quell/execute/threads.hpp>
#include <quell/image/borrowed.hpp>
#include <quell/io/exr_file.hpp>
#include <quell/presets/general.hpp>
#include <quell/presets/resolve.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace quell::examples {

namespace {

constexpr auto colour = quell::presets::resolve(quell::presets::none(radiance));
constexpr auto opacity = quell::presets::resolve(quell::presets::none(visibility)); // of one component, as alpha is

constexpr auto jitter_attribute = "quell:jitter";

/// Jitter of the first frames that can be read, as far as they say it.
std::vector<std::optional<glm::vec2>> first_jitters(FramePattern const& in, std::vector<long long> const& frames) {
    constexpr std::size_t enough = 3;
    std::vector<std::optional<glm::vec2>> jitters;
    for (auto const number : frames) {
        if (jitters.size() == enough) break;
        if (!std::filesystem::exists(in.path(number))) continue;
        try {
            io::ExrFile const file(in.path(number));
            auto const found = file.attributes.find(jitter_attribute);
            auto const* const jitter = found == file.attributes.end() ? nullptr : std::get_if<glm::vec2>(&found->second);
            jitters.push_back(jitter ? std::optional(*jitter) : std::nullopt);
        } catch (Error const&) { // whoever denoises it complains
        }
    }
    return jitters;
}

void check_jitter(io::ExrImage const& image, glm::vec2 jitter) {
    auto const is_in_range = [](float a) { return is_finite(a) && std::abs(a) <= quell::detail::most_jitter; };
    if (is_in_range(jitter.x) && is_in_range(jitter.y)) return;
    throw Error(image.name, std::string("its ") + jitter_attribute + " is " + std::to_string(jitter.x) + ", " + std::to_string(jitter.y),
                "write the samples' offset from the pixels' centres in pixels, or leave out --upsample");
}

} // namespace

Extent Upsampling::enlarged(Extent size) const {
    auto const scaled = [&](int a) { return std::max(1LL, std::llround(static_cast<double>(a) * static_cast<double>(ratio))); };
    auto const width = scaled(size.width), height = scaled(size.height);
    if (width * height > io::detail::max_pixels)
        throw Error("--upsample", "frames of " + to_string(size) + " become " + std::to_string(width) + "x" + std::to_string(height),
                    "give a smaller ratio: images have at most " + std::to_string(io::detail::max_pixels) + " pixels");
    return {static_cast<int>(width), static_cast<int>(height)};
}

Upsampling upsampling_for(float ratio, FramePattern const& in, std::vector<long long> const& frames) {
    auto const jitters = first_jitters(in, frames);
    auto const is_unknown = [](auto const& jitter) { return !jitter; };
    if (jitters.empty() || std::ranges::any_of(jitters, is_unknown))
        return {ratio, std::string("the files do not say where samples lie in their pixels (attribute ") + jitter_attribute + ")"};
    if (std::ranges::all_of(jitters, [](auto const& jitter) { return *jitter == glm::vec2(0.f); }))
        return {ratio, std::string("samples lie at the same place of the pixel in all frames (attribute ") + jitter_attribute + " is 0)"};
    return {ratio};
}

/// With the frame that they are shown.
struct Upsampler::Histories {
    Frame<Channels<Radiance, Visibility, Depth, Motion>, Borrowed<>> frame;
    History<std::remove_const_t<decltype(colour)>> colours;
    std::optional<History<std::remove_const_t<decltype(opacity)>>> alphas{}; ///< none before there was alpha
};

Upsampler::Upsampler(Extent size, Upsampling upsampling, int count)
    : how(std::move(upsampling)), threads(count),
      histories(new Histories{decltype(Histories::frame)(size), decltype(Histories::colours)(how.enlarged(size), colour)}) {}
Upsampler::~Upsampler() = default;

void Upsampler::next(SeenFrame& seen, io::ChannelNames const& names, LinearPicture& picture, std::vector<float>& alpha) {
    auto const& image = seen.image;
    auto const* const jitter = image.attribute<glm::vec2>(jitter_attribute);
    if (!jitter && how.resolves())
        throw Error(image.name, std::string("it has no attribute ") + jitter_attribute + " of two floats, and frames before it have",
                    "write it into all frames, or leave out --upsample");
    auto& [frame, colours, alphas] = *histories;
    auto const size = frame.size;
    auto const given = std::exchange(picture, LinearPicture(colours.size()));
    auto const pixels = static_cast<std::ptrdiff_t>(given.pixels());
    frame[radiance] = {given.values.data(), size, 1, size.width, pixels};
    frame[visibility] = {alpha.data(), size, 1, size.width};
    auto const depths = seen.guide(depth, names), vectors = seen.guide(motion, names);
    LinearPicture const still(how.resolves() ? Extent{} : size);
    if (how.resolves()) {
        auto const of_depth = depths->view(depth);
        auto const of_motion = vectors->view(motion);
        frame[depth] = {of_depth.planes[0], size, 1, of_depth.row_stride()};
        frame[motion] = {of_motion.planes[0], size, 1, of_motion.row_stride(), of_motion.planes[1] - of_motion.planes[0]};
    } else { // neither motion nor depth counts
        frame[depth] = {still.values.data(), size, 1, size.width};
        frame[motion] = {still.values.data(), size, 1, size.width, pixels};
        colours.forget();
        if (alphas) alphas->forget();
    }
    frame.number = seen.number;
    frame.camera.jitter = jitter ? *jitter : glm::vec2(0.f);
    check_jitter(image, frame.camera.jitter);

    auto const begin = std::chrono::steady_clock::now();
    Threads<> const executor{.count = threads};
    run_into(picture.target(), colour, frame, colours, executor);
    if (!alpha.empty()) {
        if (!alphas) alphas.emplace(colours.size(), opacity);
        auto const enlarged = run(opacity, frame, *alphas, executor);
        alpha.clear();
        for (int y = 0; y < enlarged.size.height; ++y)
            for (int x = 0; x < enlarged.size.width; ++x) alpha.push_back(enlarged.get(0, x, y));
    }
    taken += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void Upsampler::release_scratch() {
    histories->colours.release_scratch();
    if (histories->alphas) histories->alphas->release_scratch();
}

double Upsampler::bytes_per_pixel() const {
    auto const& [frame, colours, alphas] = *histories;
    auto const bytes = colours.bytes() + (alphas ? alphas->bytes() : 0);
    return static_cast<double>(bytes) / static_cast<double>(frame.size.pixels());
}

} // namespace quell::examples

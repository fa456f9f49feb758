#pragma once

#include "quell.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// quell as a library for C++: a class without templates over quell.h. It includes none of quell's other headers, has no name in common with
// them, and depends on no flag of the compiler's.
namespace quell {

/// What a Denoiser throws. Where exceptions are off, the program prints the sentence and aborts.
struct DenoiserError : std::runtime_error {
    quell_status status; ///< see quell.h
    /// A sentence.
    DenoiserError(quell_status s, char const* sentence) : std::runtime_error(sentence), status(s) {}
};

/// Denoises the frames of one view.
///
///     quell::Denoiser denoiser("general", 1920, 1080);
///     denoiser.set("radiance", rgb, 3).set("albedo", albedo, 3).set("normal", normals, 3).set("depth", depth, 1).set("motion", motion, 2);
///     denoiser.run(out, 3); // floats, rows without gaps; see quell_image for other memory
class Denoiser {
    quell_denoiser* denoiser = nullptr;
    std::vector<std::pair<std::string, quell_image>> images;
    std::vector<std::pair<std::string, quell_samples>> patterns;
    std::vector<quell_channel> channels;
    std::vector<quell_samples> samples;
    quell_camera seen_by{};
    bool has_camera = false;

public:
    quell_frame frame = QUELL_FRAME; ///< number, shutter and size of the next frame; the rest is set by run()

    /// @param preset one of docs/presets.md
    /// @throws DenoiserError
    Denoiser(char const* preset, int width, int height) : Denoiser(with(preset, width, height)) {}
    /// @throws DenoiserError
    explicit Denoiser(quell_settings const& settings) { check(quell_create(&settings, &denoiser)); }
    Denoiser(Denoiser const&) = delete;
    Denoiser& operator=(Denoiser const&) = delete;
    Denoiser(Denoiser&& other) noexcept { *this = std::move(other); }
    Denoiser& operator=(Denoiser&& other) noexcept {
        std::swap(denoiser, other.denoiser), std::swap(images, other.images), std::swap(frame, other.frame);
        std::swap(patterns, other.patterns);
        std::swap(seen_by, other.seen_by), std::swap(has_camera, other.has_camera);
        return *this;
    }
    ~Denoiser() { quell_destroy(denoiser); }

    /// The image of a channel for this frame and all that follow. Its memory must live until the last run().
    Denoiser& set(std::string const& channel, quell_image const& image) {
        for (auto& each : images)
            if (each.first == channel) return each.second = image, *this;
        images.emplace_back(channel, image);
        return *this;
    }
    /// Floats, so many components of a pixel side by side, rows without gaps.
    Denoiser& set(std::string const& channel, float const* pixels, int components) {
        return set(channel, QUELL_PIXELS(pixels, components));
    }
    /// Which pixels have a sample of a channel, in the next frame and those that follow, where it has fewer samples than pixels.
    Denoiser& set_samples(std::string const& channel, quell_samples const& pattern) {
        for (auto& each : patterns)
            if (each.first == channel) return each.second = pattern, *this;
        patterns.emplace_back(channel, pattern);
        return *this;
    }
    /// The camera of the next frame and those that follow.
    Denoiser& set_camera(quell_camera const& camera) { return seen_by = camera, has_camera = true, *this; }

    /// Where the samples of the next frame and those that follow lie, from the pixels' centres: in pixels, y down. For a denoiser with
    /// the stage resolve or colours whose preset needs no camera; else it is of the camera.
    Denoiser& set_jitter(float x, float y) { return seen_by.jitter[0] = x, seen_by.jitter[1] = y, has_camera = true, *this; }

    /// Denoises a frame. @throws DenoiserError
    void run(quell_image const& output) {
        channels.clear(), samples.clear();
        for (auto const& each : images) {
            channels.push_back({each.first.c_str(), each.second});
            samples.push_back({});
            for (auto const& pattern : patterns)
                if (pattern.first == each.first) samples.back() = pattern.second;
        }
        frame.channels = channels.data(), frame.channel_count = channels.size();
        frame.samples = patterns.empty() ? nullptr : samples.data();
        frame.output = output;
        frame.camera = has_camera ? &seen_by : nullptr;
        check(quell_run(denoiser, &frame));
    }
    /// To floats, so many components of a pixel side by side, rows without gaps.
    void run(float* output, int components) { run(QUELL_PIXELS(output, components)); }

    /// Copies a guide that was accumulated with the light to an image of the frame's size: mean_albedo or mean_normal of the preset
    /// accumulated. @throws DenoiserError
    void copy_guide(char const* name, quell_image const& image) { check(quell_copy_guide(denoiser, name, &image)); }
    /// To floats, three components of a pixel side by side, rows without gaps.
    void copy_guide(char const* name, float* pixels) { copy_guide(name, QUELL_PIXELS(pixels, 3)); }

    /// Drops the history: for cuts and teleports.
    void forget() { check(quell_forget(denoiser)); }
    /// Counts so far.
    [[nodiscard]] quell_statistics statistics() const {
        quell_statistics counted = QUELL_STATISTICS;
        check(quell_get_statistics(denoiser, &counted));
        return counted;
    }
    /// Its passes in order, what each reads and writes, and memory: a table in Markdown.
    [[nodiscard]] std::string plan() const { return quell_plan(denoiser); }
    /// Names of the channels that it reads.
    [[nodiscard]] std::vector<std::string> reads() const {
        std::vector<std::string> names;
        while (char const* const name = quell_channel_name(denoiser, static_cast<int32_t>(names.size()))) names.emplace_back(name);
        return names;
    }

private:
    static quell_settings with(char const* preset, int width, int height) {
        quell_settings settings = QUELL_SETTINGS;
        settings.preset = preset, settings.width = width, settings.height = height;
        return settings;
    }
    static void check(quell_status status) {
        if (status == QUELL_OK) return;
#if defined(__cpp_exceptions)
        throw DenoiserError(status, quell_error());
#else
        std::fprintf(stderr, "quell: %s\n", quell_error());
        std::abort();
#endif
    }
};

} // namespace quell

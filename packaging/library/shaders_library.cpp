// The functions of quell_shaders.h.
#define QUELL_CALL __attribute__((visibility("default")))
#include "quell_shaders.h"

#include "calls.hpp"
#include "recorded_presets.hpp"

#include <quell/core/error.hpp>
#include <quell/pipeline/graph/check_frame.hpp>
#include <quell/shader/write_plan.hpp>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

struct quell_shaders {
    std::vector<quell::ShaderFile> files;
    std::string plan;
};

namespace {

using namespace quell_library;
using quell::shaders::RecordedPreset;

struct Language {
    char const *name, *extension;
    quell::ShaderLanguage language;
};
constexpr std::array<Language, 2> languages{{{"wgsl", "wgsl", quell::ShaderLanguage::wgsl}, {"glsl", "comp", quell::ShaderLanguage::glsl}}};

std::vector<RecordedPreset> const& presets() {
    static auto const all = quell::shaders::recorded_presets();
    return all;
}
std::string names(auto const& all) {
    std::string text;
    for (auto const& each : all) (text += text.empty() ? "" : ", ") += each.name;
    return text;
}
auto find(auto const& all, std::string_view name) {
    return std::find_if(all.begin(), all.end(), [&](auto const& each) { return each.name == name; });
}

quell_status create(std::string const& preset, std::string const& language, quell_shaders_options const& options, quell_shaders** shaders) {
    auto const found = find(presets(), preset);
    if (found == presets().end())
        return fail(QUELL_UNKNOWN_PRESET, "preset: there is no '" + preset + "' that can be written; give one of: " + names(presets()));
    auto const in = find(languages, language);
    if (in == languages.end()) {
        bool const is_translated = language == "spirv" || language == "hlsl" || language == "metal";
        if (is_translated)
            return fail(QUELL_NOT_SUPPORTED,
                        "language: '" + language + "' is made from glsl by other programs; the program quell-shaders runs them");
        return fail(QUELL_INVALID_ARGUMENT, "language: '" + language + "'; give one of: " + names(languages));
    }
    if (options.samples_per_pixel < 0)
        return fail(QUELL_INVALID_ARGUMENT, "options.samples_per_pixel: " + std::to_string(options.samples_per_pixel) +
                                                "; give their number, or 0 where that is not known");
    constexpr int most_fill_holes = quell::RecordOptions::most_fill_holes;
    if (options.fill_holes < 0 || options.fill_holes > most_fill_holes)
        return fail(QUELL_INVALID_ARGUMENT, "options.fill_holes: " + std::to_string(options.fill_holes) + "; give 0 to " +
                                                std::to_string(most_fill_holes) + " passes");
    if (options.most_slots < 0)
        return fail(QUELL_INVALID_ARGUMENT,
                    "options.most_slots: " + std::to_string(options.most_slots) + "; give 1 or more, or 0 for no limit");
    if (options.texel_loads != 0 && in->language != quell::ShaderLanguage::glsl)
        return fail(QUELL_INVALID_ARGUMENT, "options.texel_loads: the language is " + language + "; give glsl");
    auto const threads = [](std::int32_t given) { return given == 0 ? 8 : given; };
    quell::Extent const workgroup{threads(options.workgroup_width), threads(options.workgroup_height)};
    if (!quell::RecordOptions::is_workgroup(workgroup))
        return fail(QUELL_INVALID_ARGUMENT, "options.workgroup_width, workgroup_height: " + quell::to_string(workgroup) +
                                                "; give 1 or more along each axis, " + std::to_string(quell::RecordOptions::most_threads) +
                                                " in all at most");
    auto const plan = found->record({.repair_guides = options.repair_guides != 0,
                                     .fill_holes = options.fill_holes,
                                     .counts = options.counts != 0,
                                     .half_precision = options.half_precision != 0,
                                     .most_slots = options.most_slots,
                                     .texel_loads = options.texel_loads != 0,
                                     .workgroup = workgroup},
                                    static_cast<float>(std::max(options.samples_per_pixel, 1)));
    *shaders = new quell_shaders{quell::shader_files(plan, in->language, in->extension), quell::to_json(plan, in->extension)};
    return QUELL_OK;
}
quell::Camera camera_of(quell_camera const& given) {
    return {glm::make_mat4(given.view), glm::make_mat4(given.projection), glm::make_vec2(given.jitter)};
}
/// A sentence where rays of pixels can't be had of a camera.
std::string check_camera(std::string const& name, quell::Camera const& camera) {
    std::pair<char const*, glm::mat4 const&> const matrices[] = {{"view", camera.view}, {"projection", camera.projection}};
    for (auto const& [what, matrix] : matrices)
        if (!quell::detail::usable(matrix)) return name + "." + what + ": a singular or non-finite matrix; give the host's";
    auto const& p = camera.projection;
    return p[0][3] == 0.f && p[1][3] == 0.f && p[2][3] == 0.f
               ? name + ".projection: a matrix without perspective; give the host's, orthographic ones are not supported"
               : std::string();
}
quell_status write_block(quell_shaders_frame const& frame, void* block, std::size_t bytes) {
    quell::FrameBlock own{.size = {frame.width, frame.height},
                          .frame_index = frame.number,
                          .shutter = frame.shutter,
                          .shutter_then = frame.shutter_then,
                          .needs_camera = frame.needs_camera != 0};
    auto const wrong = [](std::string const& sentence) { return fail(QUELL_INVALID_ARGUMENT, sentence); };
    if (frame.width < 1 || frame.height < 1)
        return wrong("frame.width, frame.height: " + quell::to_string(own.size) + "; give the frame's size in pixels");
    for (auto const& [what, shutter] : {std::pair{"shutter", frame.shutter}, {"shutter_then", frame.shutter_then}})
        if (!quell::is_finite(shutter) || shutter < 0.f)
            return wrong(std::string("frame.") + what + ": " + std::to_string(shutter) +
                         "; give a part of the time between frames, 0 or more");
    if (own.needs_camera && frame.camera == nullptr) return wrong("frame.camera: null; the preset needs the camera, as its plan says");
    if (frame.camera != nullptr) own.camera = camera_of(*frame.camera);
    own.camera_then = frame.camera_then != nullptr ? camera_of(*frame.camera_then) : own.camera;
    if (own.needs_camera)
        for (auto const& [what, camera] : {std::pair{"frame.camera", own.camera}, {"frame.camera_then", own.camera_then}})
            if (auto const sentence = check_camera(what, camera); !sentence.empty()) return wrong(sentence);
    auto const words = own.as_words();
    if (block == nullptr || bytes < sizeof(words))
        return wrong("block: " + std::string(block == nullptr ? "null" : std::to_string(bytes) + " bytes") + "; give it " +
                     std::to_string(sizeof(words)) + " bytes");
    std::memcpy(block, words.data(), sizeof(words));
    return QUELL_OK;
}
/// A name or text of a file; null beyond the last.
char const* of_file(quell_shaders const* shaders, std::int32_t index, std::string quell::ShaderFile::*part) {
    if (shaders == nullptr || index < 0 || static_cast<std::size_t>(index) >= shaders->files.size()) return nullptr;
    return (shaders->files[static_cast<std::size_t>(index)].*part).c_str();
}

} // namespace

extern "C" {

char const* quell_shaders_error() { return last_error().c_str(); }
char const* quell_shaders_preset_name(std::int32_t index) {
    // Names are literals.
    return index >= 0 && static_cast<std::size_t>(index) < presets().size() ? presets()[static_cast<std::size_t>(index)].name.data()
                                                                            : nullptr;
}
char const* quell_shaders_language_name(std::int32_t index) {
    return index >= 0 && static_cast<std::size_t>(index) < languages.size() ? languages[static_cast<std::size_t>(index)].name : nullptr;
}

quell_status quell_shaders_create(char const* preset, char const* language, quell_shaders** shaders) {
    return quell_shaders_create_with(preset, language, nullptr, shaders);
}
quell_status quell_shaders_create_with(char const* preset, char const* language, quell_shaders_options const* options,
                                       quell_shaders** shaders) {
    return guarded([&] {
        if (shaders == nullptr) return fail(QUELL_INVALID_ARGUMENT, "shaders: null; point it at a pointer");
        *shaders = nullptr;
        for (auto const& [what, text] : {std::pair{"preset", preset}, {"language", language}})
            if (text == nullptr) return fail(QUELL_INVALID_ARGUMENT, std::string(what) + ": null; give its name");
        auto own = QUELL_SHADERS_OPTIONS;
        auto const* const given = reinterpret_cast<std::byte const*>(options != nullptr ? options : &own);
        if (auto const wrong = take_struct(own, given, "options", "QUELL_SHADERS_OPTIONS", sizeof(own), "quell_shaders.h"); !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        return create(preset, language, own, shaders);
    });
}
void quell_shaders_destroy(quell_shaders* shaders) { delete shaders; }

char const* quell_shaders_name(quell_shaders const* shaders, std::int32_t index) {
    return of_file(shaders, index, &quell::ShaderFile::name);
}
char const* quell_shaders_text(quell_shaders const* shaders, std::int32_t index) {
    return of_file(shaders, index, &quell::ShaderFile::text);
}
char const* quell_shaders_plan(quell_shaders const* shaders) { return shaders != nullptr ? shaders->plan.c_str() : ""; }

std::size_t quell_shaders_block_size() { return std::size_t{4} * quell::FrameBlock::words; }
quell_status quell_shaders_block(quell_shaders_frame const* frame, void* block, std::size_t bytes) {
    return guarded([&] {
        if (frame == nullptr) return fail(QUELL_INVALID_ARGUMENT, "frame: null; start from QUELL_SHADERS_FRAME");
        auto own = QUELL_SHADERS_FRAME;
        auto const* const given = reinterpret_cast<std::byte const*>(frame);
        if (auto const wrong = take_struct(own, given, "frame", "QUELL_SHADERS_FRAME", sizeof(own), "quell_shaders.h"); !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        return write_block(own, block, bytes);
    });
}
}

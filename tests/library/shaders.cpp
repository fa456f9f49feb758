#include <quell_shaders.h>

#include <quell/shader/frame_block.hpp>

#include <doctest/doctest.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <string>

namespace {

/// What it says of a call that it refuses.
std::string refused(char const* preset, char const* language, quell_status status) {
    auto* shaders = reinterpret_cast<quell_shaders*>(&status);
    CHECK(quell_shaders_create(preset, language, &shaders) == status);
    CHECK(shaders == nullptr);
    return quell_shaders_error();
}

quell::Camera camera_at(float x) {
    return {glm::lookAt(glm::vec3(x, 1, 8), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)), glm::perspective(0.9f, 1.5f, 0.1f, 100.f),
            glm::vec2(0.1f * x, -0.2f)};
}
quell_camera in_c(quell::Camera const& camera) {
    quell_camera made;
    std::copy_n(glm::value_ptr(camera.view), 16, made.view);
    std::copy_n(glm::value_ptr(camera.projection), 16, made.projection);
    std::copy_n(glm::value_ptr(camera.jitter), 2, made.jitter);
    return made;
}
using Words = std::array<std::uint32_t, std::size_t{quell::FrameBlock::words}>;
/// What it says of a frame that it refuses.
std::string refused(quell_shaders_frame const& frame) {
    Words block{};
    CHECK(quell_shaders_block(&frame, block.data(), sizeof(block)) == QUELL_INVALID_ARGUMENT);
    CHECK(block == Words{});
    return quell_shaders_error();
}

} // namespace

TEST_CASE("shaders: the block of uniforms is that of C++") {
    CHECK(quell_shaders_block_size() == sizeof(Words));
    auto const now = camera_at(1.f), then = camera_at(2.f);
    auto const in_c_now = in_c(now), in_c_then = in_c(then);
    auto frame = QUELL_SHADERS_FRAME;
    frame.width = 60, frame.height = 40, frame.number = -7, frame.shutter = 0.25f;
    Words block{};
    auto const is = [&](quell::FrameBlock const& wanted) {
        CHECK(quell_shaders_block(&frame, block.data(), sizeof(block)) == QUELL_OK);
        return block == wanted.as_words();
    };
    quell::FrameBlock wanted{.size = {60, 40}, .frame_index = -7, .shutter = 0.25f, .shutter_then = 0.5f};
    CHECK(is(wanted));
    frame.camera = &in_c_now; // in the first frame the previous camera is the same
    wanted.camera = wanted.camera_then = now;
    CHECK(is(wanted));
    frame.camera_then = &in_c_then, frame.needs_camera = 1;
    wanted.camera_then = then, wanted.needs_camera = true;
    CHECK(is(wanted));
}

TEST_CASE("shaders: a frame that no block can be made of is refused in one sentence") {
    auto frame = QUELL_SHADERS_FRAME;
    CHECK(refused(frame).find("frame.width, frame.height: 0x0; ") == 0);
    frame.width = frame.height = 8;
    char block[304];
    CHECK(quell_shaders_block(nullptr, block, sizeof(block)) == QUELL_INVALID_ARGUMENT);
    CHECK(quell_shaders_block(&frame, nullptr, sizeof(block)) == QUELL_INVALID_ARGUMENT);
    CHECK(quell_shaders_block(&frame, block, sizeof(block) - 1) == QUELL_INVALID_ARGUMENT);
    CHECK(std::string(quell_shaders_error()) == "block: 303 bytes; give it 304 bytes");
    frame.needs_camera = 1;
    CHECK(refused(frame).find("frame.camera: null; ") == 0);
    auto camera = in_c(camera_at(0.f)), other = camera;
    frame.camera = &camera, frame.camera_then = &other;
    other.view[0] = std::numeric_limits<float>::quiet_NaN();
    CHECK(refused(frame).find("frame.camera_then.view: a singular or non-finite matrix; ") == 0);
    other = in_c({});
    CHECK(refused(frame).find("frame.camera_then.projection: a matrix without perspective; ") == 0);
    frame.shutter = -1.f;
    CHECK(refused(frame).find("frame.shutter: -1") == 0);
    frame.struct_size = 4;
    CHECK(refused(frame).find("frame.struct_size: 4; start from QUELL_SHADERS_FRAME of this library's quell_shaders.h") == 0);
}

TEST_CASE("shaders: names, texts and a plan that calls them by name") {
    for (int i = 0; char const* const preset = quell_shaders_preset_name(i); ++i) {
        CAPTURE(preset);
        quell_shaders* shaders = nullptr;
        REQUIRE(quell_shaders_create(preset, "wgsl", &shaders) == QUELL_OK);
        CHECK(std::string(quell_shaders_error()).empty());
        std::string const plan = quell_shaders_plan(shaders), quote = "\"";
        CHECK(plan.find("\"name\": \"" + std::string(preset) + quote) != std::string::npos);
        int count = 0;
        for (; char const* const name = quell_shaders_name(shaders, count); ++count) {
            CHECK(plan.find(quote + name + quote) != std::string::npos);
            CHECK(std::string(quell_shaders_text(shaders, count)).find("@compute") != std::string::npos);
        }
        CHECK(count > 0);
        for (int const none : {-1, count, 1 << 30}) {
            CHECK(quell_shaders_name(shaders, none) == nullptr);
            CHECK(quell_shaders_text(shaders, none) == nullptr);
        }
        quell_shaders_destroy(shaders);
        break; // others are the same code with other steps
    }
}

TEST_CASE("shaders: what can't be written is refused in one sentence") {
    quell_shaders_destroy(nullptr);
    CHECK(quell_shaders_create("none", "wgsl", nullptr) == QUELL_INVALID_ARGUMENT);
    CHECK(refused(nullptr, "wgsl", QUELL_INVALID_ARGUMENT).find("preset: null") == 0);
    CHECK(refused("no-such-preset", "wgsl", QUELL_UNKNOWN_PRESET).find("preset: there is no 'no-such-preset'") == 0);
    char const* const preset = quell_shaders_preset_name(0);
    if (preset == nullptr) return; // QUELL_PRESETS has none that can be recorded
    auto options = QUELL_SHADERS_OPTIONS;
    quell_shaders* shaders = nullptr;
    options.counts = options.most_slots = 1;
    REQUIRE(quell_shaders_create_with(preset, "wgsl", &options, &shaders) == QUELL_OK);
    CHECK(std::string(quell_shaders_plan(shaders)).find(R"("counts": [)") != std::string::npos);
    CHECK(std::string(quell_shaders_plan(shaders)).find(R"("name": "inputs_2")") != std::string::npos);
    quell_shaders_destroy(shaders);
    auto as_written = QUELL_SHADERS_OPTIONS;
    as_written.half_precision = as_written.texel_loads = 1, as_written.workgroup_width = 64, as_written.workgroup_height = 1;
    REQUIRE(quell_shaders_create_with(preset, "glsl", &as_written, &shaders) == QUELL_OK);
    std::string const text = quell_shaders_text(shaders, 0);
    for (auto const* const part : {"local_size_x = 64, local_size_y = 1", "texelFetch", "packHalf2x16"})
        CHECK_MESSAGE(text.find(part) != std::string::npos, part);
    quell_shaders_destroy(shaders);
    CHECK(quell_shaders_create_with(preset, "wgsl", &as_written, &shaders) == QUELL_INVALID_ARGUMENT);
    CHECK(std::string(quell_shaders_error()) == "options.texel_loads: the language is wgsl; give glsl");
    as_written.texel_loads = 0, as_written.workgroup_height = 3;
    CHECK(quell_shaders_create_with(preset, "wgsl", &as_written, &shaders) == QUELL_INVALID_ARGUMENT);
    CHECK(std::string(quell_shaders_error()).find("options.workgroup_width, workgroup_height: 64x3; give") == 0);
    options.fill_holes = -1;
    CHECK(quell_shaders_create_with(preset, "wgsl", &options, &shaders) == QUELL_INVALID_ARGUMENT);
    CHECK(std::string(quell_shaders_error()) == "options.fill_holes: -1; give 0 to 16 passes");
    CHECK(refused(preset, nullptr, QUELL_INVALID_ARGUMENT).find("language: null") == 0);
    CHECK(refused(preset, "cuda", QUELL_INVALID_ARGUMENT) == "language: 'cuda'; give one of: wgsl, glsl");
    CHECK(refused(preset, "spirv", QUELL_NOT_SUPPORTED).find("quell-shaders") != std::string::npos);
}

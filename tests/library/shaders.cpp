#include <quell_shaders.h>

#include <doctest/doctest.h>

#include <string>

namespace {

/// What it says of a call that it refuses.
std::string refused(char const* preset, char const* language, quell_status status) {
    auto* shaders = reinterpret_cast<quell_shaders*>(&status);
    CHECK(quell_shaders_create(preset, language, &shaders) == status);
    CHECK(shaders == nullptr);
    return quell_shaders_error();
}

} // namespace

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
    CHECK(refused(preset, nullptr, QUELL_INVALID_ARGUMENT).find("language: null") == 0);
    CHECK(refused(preset, "cuda", QUELL_INVALID_ARGUMENT) == "language: 'cuda'; give one of: wgsl, glsl");
    CHECK(refused(preset, "spirv", QUELL_NOT_SUPPORTED).find("quell-shaders") != std::string::npos);
}

// What libquell makes of a preset with its history and without: what the headers make of the same preset.
#include "wall.hpp"

#include <quell/presets/by_evidence.hpp>
#include <quell/presets/general.hpp>

#include <cmath>
#include <limits>

using namespace wall_test;

namespace {

constexpr auto of_headers = quell::presets::by_evidence(quell::presets::surface_clamp(quell::radiance, quell::Demodulate{}));
constexpr unsigned frames = 4, broken = 2;

/// A wall whose light jumps in the third frame, where one sample is broken.
struct JumpingWall : Wall {
    void look(unsigned number) {
        shine(number);
        for (auto& value : rgb) value *= number < broken ? 1.f : 5.f;
        if (number == broken) rgb[300] = std::numeric_limits<float>::quiet_NaN();
        for (std::size_t p = 0; p < pixels; ++p) motion[2 * p] = 0.75f, motion[2 * p + 1] = -0.25f;
    }
};
template <class RunFrame> std::vector<std::vector<float>> pictures_of(RunFrame&& run_frame) {
    JumpingWall wall;
    std::vector<std::vector<float>> all;
    for (unsigned i = 0; i < frames; ++i) {
        wall.look(i);
        run_frame(wall);
        all.push_back(wall.out);
    }
    return all;
}
std::vector<std::vector<float>> pictures_in_c(quell_settings const& settings) {
    auto const denoiser = made(settings);
    return pictures_of([&](Wall& wall) { REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK); });
}
quell_settings choosing(char const* preset) {
    auto settings = settings_of(preset);
    settings.stages = "evidence", settings.samples_per_pixel = 1;
    return settings;
}
bool has(char const* preset) {
    for (int32_t i = 0; char const* const name = quell_preset_name(i); ++i)
        if (std::string(name) == preset) return true;
    return false;
}
/// How much a picture varies, over its mean.
double deviation_of(std::vector<float> const& picture) {
    double sum = 0, squares = 0;
    for (float const value : picture) sum += static_cast<double>(value), squares += static_cast<double>(value) * static_cast<double>(value);
    double const mean = sum / static_cast<double>(picture.size());
    return std::sqrt(std::max(squares / static_cast<double>(picture.size()) - mean * mean, 0.)) / mean;
}

} // namespace

TEST_CASE("a choice of histories: bit for bit what the headers make, in C and in C++, on any threads") {
    using namespace quell;
    if (!has("surface-clamp")) return;
    Frame frame{Extent{width, height}, of_headers};
    History history{Extent{width, height}, of_headers};
    auto const wanted = pictures_of([&](Wall& wall) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const p = static_cast<std::size_t>(y * width + x);
                auto const three = [&](std::vector<float> const& from) { return glm::vec3(from[3 * p], from[3 * p + 1], from[3 * p + 2]); };
                frame[radiance].set(x, y, three(wall.rgb)), frame[albedo].set(x, y, three(wall.albedo));
                frame[normal].set(x, y, three(wall.normal)), frame[depth].set(x, y, wall.depth[p]);
                frame[motion].set(x, y, {wall.motion[2 * p], wall.motion[2 * p + 1]});
            }
        auto const picture = run(of_headers, frame, history);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c) wall.out[static_cast<std::size_t>(3 * (y * width + x) + c)] = picture.get(c, x, y);
    });
    auto settings = choosing("surface-clamp");
    CHECK(pictures_in_c(settings) == wanted);
    settings.threads = 1;
    CHECK(pictures_in_c(settings) == wanted);
    Denoiser denoiser(settings);
    CHECK(pictures_of([&](Wall& wall) {
              denoiser.set("radiance", wall.rgb.data(), 3).set("albedo", wall.albedo.data(), 3).set("normal", wall.normal.data(), 3);
              denoiser.set("depth", wall.depth.data(), 1).set("motion", wall.motion.data(), 2);
              denoiser.run(wall.out.data(), 3);
          }) == wanted);
    CHECK(denoiser.statistics().frames == frames);
    CHECK(denoiser.plan().find("put together by evidence") != std::string::npos);
    settings.stages = nullptr;
    CHECK(pictures_in_c(settings) != wanted);
}

TEST_CASE("a choice of histories: nothing is allocated in warm frames, also behind and before other settings; forget() drops the past") {
    struct Counted {
        int count = 0;
        static void* allocate(void* user, std::size_t bytes, std::size_t alignment) {
            ++static_cast<Counted*>(user)->count;
            return ::operator new (bytes, std::align_val_t{alignment});
        }
        static void release(void*, void* memory) { ::operator delete (memory, std::align_val_t{64}); }
    };
    for (char const* const preset : {"svgf", "general", "final-frame"})
        for (bool const more : {false, true}) {
            if (!has(preset)) continue;
            CAPTURE(preset);
            Counted counted;
            auto settings = choosing(preset);
            settings.allocate = Counted::allocate, settings.release = Counted::release, settings.memory_user = &counted;
            if (more) settings.stages = "evidence,resolve,steady-depth";
            auto const denoiser = made(settings);
            JumpingWall wall;
            quell_camera const camera{};
            wall.frame.camera = &camera;
            int warm = 0;
            for (unsigned i = 0; i < 12; ++i) {
                wall.look(i % 2);
                REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
                if (i == 9) warm = counted.count;
            }
            CHECK(counted.count == warm);
            for (float const value : wall.out) CHECK(std::isfinite(value));
            REQUIRE(quell_forget(denoiser.get()) == QUELL_OK);
            wall.look(0);
            REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
            auto const first = wall.out;
            auto const other = made(settings);
            REQUIRE(quell_run(other.get(), wall.ready()) == QUELL_OK);
            CHECK(wall.out == first);
        }
}

TEST_CASE("a choice of histories: the history has the say where nothing changes, and frames to come are made use of") {
    for (char const* const preset : {"general", "final-frame"}) {
        if (!has(preset)) continue;
        CAPTURE(preset);
        auto settings = choosing(preset);
        settings.stages = "two-sided, evidence";
        auto const denoiser = made(settings);
        auto const alone = made(settings_of(preset));
        std::vector<JumpingWall> walls(10);
        std::vector<quell_frame> window;
        for (unsigned i = 0; i < walls.size(); ++i) {
            walls[i].shine(i);
            window.push_back(*walls[i].ready());
        }
        for (std::size_t i = 0; i + 2 < window.size(); ++i) REQUIRE(quell_run_two_sided(denoiser.get(), &window[i], 3) == QUELL_OK);
        auto const chosen = walls[7].out;
        REQUIRE(quell_run(alone.get(), &window[7]) == QUELL_OK);
        CHECK(deviation_of(chosen) < .9 * deviation_of(walls[7].out));
    }
}

TEST_CASE("a choice of histories: frames to come are told by another rule, which more samples than 32 change and more than 16 do not") {
    for (char const* const preset : {"general", "final-frame"}) {
        if (!has(preset)) continue;
        CAPTURE(preset);
        auto const picture_of = [&](std::size_t frames_each, int32_t samples) {
            auto settings = choosing(preset);
            settings.stages = "two-sided,evidence", settings.samples_per_pixel = samples;
            auto const denoiser = made(settings);
            std::vector<JumpingWall> walls(6);
            std::vector<quell_frame> window;
            for (unsigned i = 0; i < walls.size(); ++i) walls[i].look(i), window.push_back(*walls[i].ready());
            for (std::size_t i = 0; i < 4; ++i) REQUIRE(quell_run_two_sided(denoiser.get(), &window[i], frames_each) == QUELL_OK);
            return walls[3].out;
        };
        // Caution ends at 16 samples, with frames to come at 97.
        auto const of_past = [&](int32_t samples) { return picture_of(1, samples); };
        CHECK(of_past(1) != of_past(16));
        CHECK(of_past(16) == of_past(64));
        auto const of_all = [&](int32_t samples) { return picture_of(3, samples); };
        CHECK(of_all(16) == of_all(32));
        CHECK(of_all(32) != of_all(64));
    }
}

TEST_CASE("a choice of histories: what has none is refused with a sentence") {
    quell_denoiser* none = nullptr;
    for (char const* const preset : {"none", "trmv"}) {
        if (!has(preset)) continue;
        auto settings = settings_of(preset);
        settings.stages = "evidence";
        check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"settings.stages", preset, "leave 'evidence' out"});
    }
    auto settings = settings_of("none");
    settings.samples_per_pixel = -4;
    check_refused(quell_create(&settings, &none), QUELL_INVALID_ARGUMENT, {"settings.samples_per_pixel", "-4"});
}

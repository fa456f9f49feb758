// Light that libquell gives back behind a preset: what the headers give back to what it makes without.
#include "link_pictures.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/pipeline/plan.hpp>

#include <cmath>
#include <limits>

using namespace wall_test;

namespace {

constexpr unsigned frames = 4;
constexpr int32_t samples = 16;

/// A wall with stripes that a filter takes for noise, one sample of which is broken. Nothing is seen at one pixel.
struct StripedWall : Wall {
    void look(unsigned number) {
        shine(number);
        for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = .5f * rgb[i] + (i / 3 % width / 3 % 2 == 0 ? 1.f : .5f);
        rgb[3 * (100 + number)] = std::numeric_limits<float>::quiet_NaN();
        depth[200] = std::numeric_limits<float>::infinity();
        frame.number = number, frame.has_number = 1;
    }
};
quell_settings giving_back(char const* preset = "svgf") {
    auto settings = settings_of(preset);
    settings.stages = "light", settings.samples_per_pixel = samples;
    return settings;
}
std::vector<std::vector<float>> pictures_of(quell_settings const& settings) {
    return wall_test::pictures_of<StripedWall>(settings, frames);
}
bool has(char const* preset) {
    for (int32_t i = 0; char const* const name = quell_preset_name(i); ++i)
        if (std::string(name) == preset) return true;
    return false;
}
bool is_finite(std::vector<float> const& values) {
    for (float const value : values)
        if (!std::isfinite(value)) return false;
    return true;
}

} // namespace

TEST_CASE("light given back: bit for bit what the headers give back, in C and in C++, on any threads") {
    using namespace quell;
    auto const plain = pictures_of(settings_of());
    constexpr auto link = light_given_back(radiance, static_cast<float>(samples));
    auto const wanted = behind<StripedWall>(plain, link);
    auto settings = giving_back();
    auto const given = pictures_of(settings);
    CHECK(given == wanted);
    CHECK(given != plain);
    for (int32_t const threads : {1, 2, 3}) {
        settings.threads = threads;
        CHECK(pictures_of(settings) == wanted);
    }
    settings.parallel = [](void*, int32_t count, void (*task)(void*, int32_t), void* context) {
        for (int32_t i = count; i-- > 0;) task(context, i);
    };
    CHECK(pictures_of(settings) == wanted);
    settings.stages = nullptr;
    CHECK(pictures_of(settings) == plain);
    CHECK(quell::Denoiser(giving_back()).plan().find("Behind it, light:") != std::string::npos);
    CHECK(quell::Denoiser(settings_of()).plan().find("Behind it, light:") == std::string::npos);
}

TEST_CASE("light given back: an even picture stays, and stripes that the filter blurs come back") {
    auto const denoiser = made(giving_back()), plain = made();
    Wall wall;
    wall.rgb.assign(wall.rgb.size(), .25f);
    for (int i = 0; i < 3; ++i) REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    for (float const value : wall.out) CHECK(value == doctest::Approx(.25f).epsilon(1e-5));
    auto const error_of = [](std::vector<float> const& picture) {
        double sum = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) // light is .25 in the mean
            sum += std::pow(static_cast<double>(picture[i]) - (i / 3 % width / 3 % 2 == 0 ? 1.25 : .75), 2.);
        return sum;
    };
    CHECK(error_of(pictures_of(giving_back()).back()) < .8 * error_of(pictures_of(settings_of()).back()));
}

TEST_CASE("light given back: a cut and frames that do not follow begin anew, and a refused frame changes nothing") {
    auto const first = pictures_of(giving_back()).front();
    auto const denoiser = made(giving_back());
    StripedWall wall;
    auto const run = [&] { REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK); };
    for (unsigned const i : {1u, 2u}) wall.look(i), run();
    REQUIRE(quell_forget(denoiser.get()) == QUELL_OK);
    wall.look(0), wall.frame.number = 3, run(); // which would follow
    CHECK(wall.out == first);
    for (unsigned const i : {1u, 2u}) wall.look(i), run();
    wall.look(0), run(); // behind 2
    CHECK(wall.out == first);
    auto const wanted = pictures_of(giving_back());
    for (unsigned const i : {1u, 2u, 3u}) {
        wall.look(i);
        wall.frame.channel_count = 1;
        auto refused = wall.frame;
        CHECK(quell_run(denoiser.get(), &refused) == QUELL_INVALID_ARGUMENT);
        run();
        CHECK(wall.out == wanted[i]);
    }
}

TEST_CASE("light given back: with frames to come, a choice of histories, steady guides and anti-aliasing, but not with alpha") {
    for (char const* const preset : {"general", "final-frame"}) {
        if (!has(preset)) continue;
        CAPTURE(preset);
        auto const run = [&](std::string const& stages) {
            auto settings = settings_of(preset);
            settings.stages = stages.c_str(), settings.samples_per_pixel = samples;
            auto const denoiser = made(settings);
            StripedWall wall;
            quell_camera const camera{};
            wall.frame.camera = &camera;
            for (unsigned i = 0; i < 3; ++i) {
                wall.look(i);
                std::vector<quell_frame> const window(3, *wall.ready()); // numbers that do not follow end it
                REQUIRE(quell_run_two_sided(denoiser.get(), window.data(), 1) == QUELL_OK);
            }
            return wall.out;
        };
        for (std::string const others : {"two-sided", "evidence,two-sided", "two-sided,resolve", "resolve,two-sided,evidence"}) {
            auto const with = run(others + ",light"), without = run(others);
            CHECK(is_finite(with));
            CHECK(with != without);
        }
        auto transparent = settings_of(preset);
        transparent.alpha = 1, transparent.stages = "light";
        quell_denoiser* none = nullptr;
        check_refused(quell_create(&transparent, &none), QUELL_NOT_SUPPORTED, {"settings.stages", "alpha", "leave 'light' out"});
    }
    auto settings = giving_back();
    settings.stages = "light,steady-depth,steady-albedo", settings.output_width = 2 * width, settings.output_height = 2 * height;
    quell::Denoiser denoiser(settings);
    StripedWall wall;
    std::vector<float> out(4 * wall.out.size());
    for (unsigned i = 0; i < 3; ++i) {
        wall.look(i);
        denoiser.set("radiance", wall.rgb.data(), 3).set("albedo", wall.albedo.data(), 3).set("normal", wall.normal.data(), 3);
        denoiser.set("depth", wall.depth.data(), 1).set("motion", wall.motion.data(), 2).set_jitter(.25f, 0.f);
        denoiser.frame.width = i == 1 ? width - 1 : 0, denoiser.frame.height = i == 1 ? height : 0;
        if (i == 1) {
            StripedWall smaller;
            smaller.look(i);
            for (auto* const values : {&smaller.rgb, &smaller.albedo, &smaller.normal, &smaller.depth, &smaller.motion})
                values->resize(values->size() / width * (width - 1));
            denoiser.set("radiance", smaller.rgb.data(), 3).set("albedo", smaller.albedo.data(), 3);
            denoiser.set("normal", smaller.normal.data(), 3).set("depth", smaller.depth.data(), 1).set("motion", smaller.motion.data(), 2);
            denoiser.run(out.data(), 3);
        } else
            denoiser.run(out.data(), 3);
        CHECK(is_finite(out));
    }
}

TEST_CASE("light given back: bad guides and samples spread nothing; of half of the samples comes what comes of NaN in their place") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    auto const denoiser = made(giving_back());
    StripedWall wall;
    for (unsigned i = 0; i < 3; ++i) {
        wall.look(i);
        for (std::size_t p = i; p < pixels; p += 7) {
            wall.normal[3 * p] = nan, wall.depth[(p * 3) % pixels] = p % 2 == 0 ? nan : -1.f, wall.motion[2 * p] = infinity;
            wall.rgb[3 * p + 1] = p % 3 == 0 ? infinity : 1e30f;
        }
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        CHECK(is_finite(wall.out));
    }
    StripedWall whole;
    whole.look(3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if ((x + y) % 2 != 0) whole.rgb[static_cast<std::size_t>(3 * (y * width + x))] = nan;
    auto const of_nan = made(giving_back()), of_samples = made(giving_back());
    REQUIRE(quell_run(of_nan.get(), whole.ready()) == QUELL_OK);
    auto const wanted = whole.out;
    std::vector<quell_samples> pattern(whole.channels.size());
    pattern[0] = {2, 1, 1, 0, 0, width, height};
    whole.frame.samples = pattern.data();
    REQUIRE(quell_run(of_samples.get(), whole.ready()) == QUELL_OK);
    CHECK(whole.out == wanted);
}

TEST_CASE("light given back: its memory is counted, warm frames take none, and without memory a denoiser begins anew") {
    struct Counted {
        long long calls = 0, allowed = std::numeric_limits<long long>::max();
    } counted;
    auto settings = giving_back();
    settings.memory_user = &counted;
    settings.allocate = [](void* user, std::size_t bytes, std::size_t alignment) -> void* {
        auto& its = *static_cast<Counted*>(user);
        return ++its.calls > its.allowed ? nullptr : ::operator new (bytes, std::align_val_t{alignment}, std::nothrow);
    };
    settings.release = [](void*, void* memory) { ::operator delete (memory, std::align_val_t{64}); };
    auto const bytes_with = [&](char const* stages) {
        settings.stages = stages;
        quell::Denoiser denoiser(settings);
        StripedWall wall;
        for (unsigned i = 0; i < 3; ++i) {
            wall.look(i);
            denoiser.set("radiance", wall.rgb.data(), 3).set("albedo", wall.albedo.data(), 3).set("normal", wall.normal.data(), 3);
            denoiser.set("depth", wall.depth.data(), 1).set("motion", wall.motion.data(), 2);
            denoiser.run(wall.out.data(), 3);
        }
        return denoiser.statistics().bytes;
    };
    auto const planned = quell::plan_of(quell::light_given_back(quell::radiance, 1.f)).bytes_per_pixel;
    auto const more_bytes = static_cast<double>(bytes_with("light") - bytes_with(nullptr)) / static_cast<double>(pixels);
    CHECK(more_bytes > planned); // rows of images are padded, and normals and depths copied
    CHECK(more_bytes < 1.6 * planned + 60.);

    settings.stages = "light";
    auto const denoiser = made(settings);
    StripedWall wall;
    long long warm = 0;
    for (unsigned i = 0; i < 4; ++i) {
        wall.look(i);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        if (i == 2) warm = counted.calls;
    }
    CHECK(counted.calls == warm);
    auto const wanted = pictures_of(giving_back());
    // Whichever image it is that there is no memory for.
    bool failed = true;
    long long more = 0;
    for (; failed; ++more) {
        CAPTURE(more);
        auto const other = made(settings);
        counted.allowed = counted.calls + more;
        wall.look(0);
        failed = quell_run(other.get(), wall.ready()) == QUELL_NO_MEMORY;
        counted.allowed = std::numeric_limits<long long>::max();
        if (!failed) CHECK(wall.out == wanted[0]);
        for (unsigned i = failed ? 0 : 1; i < frames; ++i) {
            wall.look(i);
            REQUIRE(quell_run(other.get(), wall.ready()) == QUELL_OK);
            CHECK(wall.out == wanted[i]);
        }
    }
    CHECK(more > 4); // of the three guides among them
}

TEST_CASE("light given back: what can't is refused with a sentence") {
    quell_denoiser* none = nullptr;
    for (char const* const preset : {"none", "atrous", "shadow", "trmv", "blur"}) {
        if (!has(preset)) continue;
        CAPTURE(preset);
        auto const settings = giving_back(preset);
        check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"settings.stages", preset, "leave 'light' out"});
    }
}

// Temporal anti-aliasing behind presets of libquell: what the headers make of the same pictures.
#include "../frames.hpp"
#include "wall.hpp"

#include <quell/presets/resolve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>

using namespace wall_test;

namespace {

using quell::Extent;

constexpr auto of_colour = quell::presets::resolve(quell::presets::none(quell::radiance));
constexpr auto of_light = quell::presets::resolve(quell::presets::none(quell::visibility));

/// A wall that moves, with a step in it, and samples at other places in each frame.
struct Moving : Wall {
    std::vector<float> light = std::vector<float>(pixels), rgba = std::vector<float>(pixels * 4);
    quell_camera camera{};

    Moving() {
        for (std::size_t p = 0; p < pixels; ++p) {
            depth[p] = p % width < width / 2 ? 3.f : 4.f;
            motion[2 * p] = p % width < width / 2 ? 1.25f : 0.f, motion[2 * p + 1] = -0.5f;
        }
        // For presets that need more of it than the jitter.
        for (std::size_t i = 0; i < 16; i += 5) camera.view[i] = camera.projection[i] = 1;
        camera.projection[11] = camera.projection[14] = -1, camera.projection[15] = 0;
        frame.camera = &camera;
    }
    void move(unsigned number) {
        shine(number);
        for (std::size_t p = 0; p < pixels; ++p) {
            light[p] = rgb[3 * p] > 0.5f ? 1.f : 0.f;
            for (std::size_t c = 0; c < 4; ++c) rgba[4 * p + c] = c == 3 ? 0.5f + 0.5f * rgb[3 * p] : rgb[3 * p + c];
        }
        camera.jitter[0] = static_cast<float>(number * 7 % 16) / 16.f - 0.5f;
        camera.jitter[1] = static_cast<float>(number * 5 % 16) / 16.f - 0.5f;
    }
    /// Has the channels that a denoiser reads.
    quell_frame const* ready_for(quell_denoiser const* denoiser, std::vector<float>& to, int components) {
        std::pair<std::string, float*> const made_here[] = {
            {"radiance", rgb.data()},  {"radiance_alpha", rgba.data()}, {"visibility", light.data()}, {"albedo", albedo.data()},
            {"normal", normal.data()}, {"depth", depth.data()},         {"motion", motion.data()}};
        channels.clear();
        for (int32_t i = 0; char const* const name = quell_channel_name(denoiser, i); ++i) {
            auto const found = std::ranges::find(made_here, name, &std::pair<std::string, float*>::first);
            channels.push_back(
                {name, QUELL_PIXELS(found != std::end(made_here) ? found->second : rgba.data(), quell_channel_components(denoiser, name))});
        }
        frame.output = QUELL_PIXELS(to.data(), components);
        return ready();
    }
};

/// Pixels of a picture, one after another: some components of them.
void put(quell::Frame<quell::Channels<quell::Radiance, quell::Visibility, quell::Motion, quell::Depth>>& frame, Moving const& moving,
         std::vector<float> const& picture, int components) {
    auto const n = static_cast<std::size_t>(components);
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const p = static_cast<std::size_t>(y * frame.size.width + x);
            if (n >= 3) frame[quell::radiance].set(x, y, {picture[n * p], picture[n * p + 1], picture[n * p + 2]});
            if (n != 3) frame[quell::visibility].set(x, y, picture[n * p + n - 1]);
            frame[quell::depth].set(x, y, moving.depth[p]);
            frame[quell::motion].set(x, y, {moving.motion[2 * p], moving.motion[2 * p + 1]});
        }
    frame.camera.jitter = {moving.camera.jitter[0], moving.camera.jitter[1]};
}

quell_settings resolved_settings(char const* preset, Extent output) {
    auto settings = settings_of(preset);
    settings.stages = "resolve", settings.output_width = output.width, settings.output_height = output.height;
    return settings;
}
/// Whether this library has a preset: it may be built for others.
bool has(std::string const& preset) {
    for (int32_t i = 0; char const* const name = quell_preset_name(i); ++i)
        if (name == preset) return true;
    return false;
}
std::size_t values(Extent size, int components) { return static_cast<std::size_t>(size.pixels()) * static_cast<std::size_t>(components); }

/// How many values of nine frames differ from what the headers make of the same denoised pictures.
/// @param others stages besides; null: none
long long differ_from_headers(quell_settings const& settings, char const* others = nullptr) {
    auto plain = settings;
    plain.stages = others, plain.output_width = plain.output_height = 0;
    auto const denoiser = made(plain), resolved = made(settings);
    auto const n = quell_output_components(resolved.get());
    Extent const output{quell_output_width(resolved.get()), quell_output_height(resolved.get())};
    std::vector<float> picture(values({width, height}, n)), out(values(output, n));
    quell::Frame<quell::Channels<quell::Radiance, quell::Visibility, quell::Motion, quell::Depth>> frame({width, height});
    quell::History colours(output, of_colour);
    quell::History lights(output, of_light);
    Moving moving;
    long long differ = 0;
    auto const compare = [&](auto const& wanted, int first) {
        for (int y = 0; y < output.height; ++y)
            for (int x = 0; x < output.width; ++x)
                for (int c = 0; c < wanted.components; ++c)
                    differ += wanted.get(c, x, y) != out[static_cast<std::size_t>((y * output.width + x) * n + first + c)];
    };
    for (unsigned i = 0; i < 9; ++i) {
        moving.move(i);
        REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), picture, n)) == QUELL_OK);
        REQUIRE(quell_run(resolved.get(), moving.ready_for(resolved.get(), out, n)) == QUELL_OK);
        put(frame, moving, picture, n);
        if (n >= 3) compare(run(of_colour, frame, colours), 0);
        if (n != 3) compare(run(of_light, frame, lights), n - 1);
    }
    return differ;
}

} // namespace

TEST_CASE("anti-aliased: bit for bit what the headers make of the same denoised frames, of a colour, of one component, with alpha") {
    for (std::string const preset : {"none", "svgf", "general", "shadow"}) {
        if (!has(preset)) continue;
        for (Extent const output : {Extent{width, height}, Extent{2 * width, 2 * height}, Extent{91, 136}}) {
            CAPTURE(preset);
            CAPTURE(to_string(output));
            CHECK(differ_from_headers(resolved_settings(preset.c_str(), output)) == 0);
        }
    }
    auto settings = resolved_settings("general", {91, 51});
    settings.stages = "two-sided,resolve", settings.alpha = 1;
    CHECK(differ_from_headers(settings, "two-sided") == 0);
}

TEST_CASE("anti-aliased: an output of the frames' own size is plain unless settings.stages has resolve, and needs no camera then") {
    auto settings = settings_of();
    settings.output_width = width, settings.output_height = height;
    Wall wall;
    REQUIRE(quell_run(made(settings).get(), wall.ready()) == QUELL_OK);
    CHECK(quell_needs_camera(made(settings).get()) == 0);
    settings.stages = "resolve";
    CHECK(quell_needs_camera(made(settings).get()) == 1);
}

TEST_CASE("anti-aliased: any strides and halves, any threads, numbers, and forget()") {
    Extent const output{2 * width, 2 * height};
    auto settings = resolved_settings("svgf", output);
    auto const third_of = [&](quell_settings const& its, auto&& change) {
        auto const denoiser = made(its);
        Moving moving;
        std::vector<float> out(values(output, 3));
        for (unsigned i = 0; i < 3; ++i) {
            moving.move(i);
            static_cast<void>(moving.ready_for(denoiser.get(), out, 3));
            change(denoiser.get(), moving, i);
            REQUIRE(quell_run(denoiser.get(), &moving.frame) == QUELL_OK);
        }
        return out;
    };
    auto const nothing = [](auto&&...) {};
    auto const wanted = third_of(settings, nothing);
    settings.threads = 1;
    CHECK(third_of(settings, nothing) == wanted);
    std::vector<std::uint16_t> half(values(output, 4), 0x7c00);
    third_of(settings, [&](auto, Moving& moving, unsigned) { moving.frame.output = {half.data(), QUELL_FLOAT16, 4, 0, 0, 0}; });
    for (std::size_t p = 0; p < half.size(); ++p)
        if (p % 4 == 3)
            REQUIRE(half[p] == 0x7c00);
        else
            REQUIRE(std::abs(quell::Float16::get(&half[p]) - wanted[p / 4 * 3 + p % 4]) < 2e-3f);
    // Depth and motion as planes of floats, rows from the bottom up.
    std::vector<float> planes(pixels * 3);
    auto const planar = third_of(settings, [&](auto, Moving& moving, unsigned) {
        for (std::size_t p = 0; p < pixels; ++p) {
            auto const at = (height - 1 - p / width) * width + p % width;
            planes[at] = moving.depth[p], planes[pixels + at] = moving.motion[2 * p], planes[2 * pixels + at] = moving.motion[2 * p + 1];
        }
        for (auto& each : moving.channels) {
            auto* const last = planes.data() + (height - 1) * width;
            if (each.name == std::string("depth")) each.image = {last, QUELL_FLOAT32, 1, 0, 4, -4 * width};
            if (each.name == std::string("motion"))
                each.image = {last + pixels, QUELL_FLOAT32, 2, 4 * std::ptrdiff_t{pixels}, 4, -4 * width};
        }
    });
    CHECK(planar == wanted);
    auto const alone = third_of(settings, [](auto denoiser, auto&&...) { REQUIRE(quell_forget(denoiser) == QUELL_OK); });
    CHECK(alone != wanted);
    CHECK(third_of(settings, [](auto, Moving& moving, unsigned i) { moving.frame.has_number = 1, moving.frame.number = 2 * i; }) == alone);
}

TEST_CASE("anti-aliased: frames of several sizes keep what was resolved") {
    if (!has("none")) return;
    Extent const output{2 * width, 2 * height}, smaller{48, 30};
    auto const denoiser = made(resolved_settings("none", output));
    quell::History history(output, of_colour);
    std::vector<float> out(values(output, 3));
    for (unsigned i = 0; i < 6; ++i) {
        Moving moving;
        moving.move(i);
        Extent const size = i % 3 == 2 ? smaller : Extent{width, height};
        moving.frame.width = size.width, moving.frame.height = size.height;
        REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)) == QUELL_OK);
        quell::Frame<quell::Channels<quell::Radiance, quell::Visibility, quell::Motion, quell::Depth>> frame(size);
        put(frame, moving, moving.rgb, 3);
        auto const wanted = run(of_colour, frame, history);
        long long differ = 0;
        for (int y = 0; y < output.height; ++y)
            for (int x = 0; x < output.width; ++x)
                for (int c = 0; c < 3; ++c) differ += wanted.get(c, x, y) != out[static_cast<std::size_t>((y * output.width + x) * 3 + c)];
        CHECK(differ == 0);
    }
}

TEST_CASE("anti-aliased: where frames' size changes, motion that contains the jitter's change is what is left of it without") {
    if (!has("none")) return;
    Extent const large{60, 34}, small{30, 17}, output{2 * large.width, 2 * large.height};
    auto settings = resolved_settings("none", output);
    settings.width = large.width, settings.height = large.height;
    auto const without = made(settings);
    settings.motion.has_jitter = 1;
    auto const with = made(settings);
    Moving moving;
    std::ranges::fill(moving.depth, 3.f);
    std::vector<float> wanted(values(output, 3)), out(values(output, 3));
    Extent then = large;
    float jitter_then[2] = {};
    for (unsigned i = 0; i < 7; ++i) {
        moving.move(i);
        Extent const size = i % 3 == 2 ? small : large;
        moving.frame.width = size.width, moving.frame.height = size.height;
        auto const ratio = static_cast<float>(size.width) / static_cast<float>(then.width); // the same for the heights
        std::ranges::fill(moving.motion, 0.f);
        REQUIRE(quell_run(without.get(), moving.ready_for(without.get(), wanted, 3)) == QUELL_OK);
        // A point that stands still lies at -jitter in the pixels of its frame.
        for (std::size_t k = 0; k < moving.motion.size(); ++k) moving.motion[k] = moving.camera.jitter[k % 2] - ratio * jitter_then[k % 2];
        REQUIRE(quell_run(with.get(), moving.ready_for(with.get(), out, 3)) == QUELL_OK);
        CHECK(out == wanted);
        then = size;
        for (std::size_t c = 0; c < 2; ++c) jitter_then[c] = moving.camera.jitter[c];
    }
}

TEST_CASE("anti-aliased: guides are of the last frame's size, and none is there after a frame for which memory ran out") {
    if (!has("accumulated")) return;
    struct Limited {
        long long left = 1LL << 40;
    } limited;
    auto settings = resolved_settings("accumulated", {2 * width, 2 * height});
    settings.memory_user = &limited;
    settings.allocate = [](void* user, size_t bytes, size_t alignment) -> void* {
        return static_cast<Limited*>(user)->left-- > 0 ? ::operator new[](bytes, std::align_val_t{alignment}, std::nothrow) : nullptr;
    };
    settings.release = [](void*, void* memory) { ::operator delete[](memory, std::align_val_t{64}); };
    std::vector<float> out(values({2 * width, 2 * height}, 3));
    Extent const small{48, 30};
    auto const guide_of = [&](quell_denoiser* denoiser, Extent size, std::vector<float>& guide) {
        guide.assign(values(size, 3) + 1, -1.f);
        auto const image = QUELL_PIXELS(guide.data(), 3);
        return quell_copy_guide(denoiser, "mean_albedo", &image);
    };
    std::vector<float> guide, alone(out);
    Moving still;
    REQUIRE(quell_run(made(settings).get(), still.ready_for(made(settings).get(), alone, 3)) == QUELL_OK);
    int failures = 0;
    for (;; ++failures) {
        auto const denoiser = made(settings);
        Moving moving;
        moving.frame.width = small.width, moving.frame.height = small.height;
        REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)) == QUELL_OK);
        REQUIRE(guide_of(denoiser.get(), small, guide) == QUELL_OK);
        CHECK((guide.front() == doctest::Approx(0.5) && guide.end()[-2] == doctest::Approx(0.5) && guide.back() == -1.f));

        moving.frame.width = width, moving.frame.height = height;
        limited.left = failures;
        auto const status = quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3));
        limited.left = 1LL << 40;
        if (status == QUELL_OK) break;
        CHECK(status == QUELL_NO_MEMORY);
        check_refused(guide_of(denoiser.get(), small, guide), QUELL_INVALID_ARGUMENT, {"the last one failed"});
        CHECK(std::ranges::all_of(guide, [](float value) { return value == -1.f; }));
        REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)) == QUELL_OK);
        CAPTURE(failures);
        CHECK(out == alone);
        REQUIRE(guide_of(denoiser.get(), {width, height}, guide) == QUELL_OK);
        CHECK((guide.end()[-2] == doctest::Approx(0.5) && guide.back() == -1.f));
    }
    CHECK(failures > 1);
}

TEST_CASE("anti-aliased: once eight frames have run, no image is made, and all memory goes back") {
    struct Counted {
        long long now = 0, calls = 0;
    } counted;
    auto settings = resolved_settings("svgf", {2 * width, 2 * height});
    settings.memory_user = &counted;
    settings.allocate = [](void* user, size_t bytes, size_t alignment) -> void* {
        auto& its = *static_cast<Counted*>(user);
        ++its.calls, ++its.now;
        return ::operator new[](bytes, std::align_val_t{alignment}, std::nothrow);
    };
    settings.release = [](void* user, void* memory) {
        --static_cast<Counted*>(user)->now;
        ::operator delete[](memory, std::align_val_t{64});
    };
    {
        auto const denoiser = made(settings);
        CHECK(std::string(quell_plan(denoiser.get())).find("anti-aliased") != std::string::npos);
        Moving moving;
        std::vector<float> out(values({2 * width, 2 * height}, 3));
        auto calls = counted.calls;
        quell_statistics counts = QUELL_STATISTICS;
        std::size_t bytes = 0;
        for (unsigned i = 0; i < 10; ++i) {
            if (i == 8) calls = counted.calls, bytes = counts.bytes;
            moving.move(i);
            REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)) == QUELL_OK);
            REQUIRE(quell_get_statistics(denoiser.get(), &counts) == QUELL_OK);
        }
        CHECK(counted.calls == calls);
        CHECK(counts.bytes == bytes);
        CHECK(counts.frames == 10);
    }
    CHECK(counted.now == 0);
}

TEST_CASE("anti-aliased: wrong sizes, ratios, jitter and cameras are refused with a sentence, and the denoiser works as before") {
    quell_denoiser* none = nullptr;
    auto const refuses = [&](int32_t w, int32_t h, std::vector<std::string> const& words) {
        auto settings = settings_of();
        settings.output_width = w, settings.output_height = h;
        check_refused(quell_create(&settings, &none), QUELL_INVALID_ARGUMENT, words);
        CHECK(none == nullptr);
    };
    refuses(4 * width + 1, 4 * height, {"245x136", "61x34", "1 to 4 times"});
    refuses(width - 1, height, {"60x34", "61x34"});
    refuses(2 * width, 0, {"122x0", "output_height"});
    refuses(-1, -1, {"-1x-1"});
    refuses(std::numeric_limits<int32_t>::max(), std::numeric_limits<int32_t>::max(), {"2147483647"});

    Extent const output{2 * width, 2 * height};
    auto const denoiser = made(resolved_settings("svgf", output)), other = made(resolved_settings("svgf", output));
    std::vector<float> out(values(output, 3)), same(out);
    Moving moving;
    auto const step = [&](unsigned i) {
        moving.move(i);
        REQUIRE(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)) == QUELL_OK);
        REQUIRE(quell_run(other.get(), moving.ready_for(other.get(), same, 3)) == QUELL_OK);
        CHECK(out == same);
    };
    auto const refused = [&](std::vector<std::string> const& words) {
        check_refused(quell_run(denoiser.get(), moving.ready_for(denoiser.get(), out, 3)), QUELL_INVALID_ARGUMENT, words);
    };
    step(0), step(1);
    auto& frame = moving.frame;
    frame.camera = nullptr, refused({"camera", "jitter"}), frame.camera = &moving.camera;
    for (float const jitter : {8.5f, -9.f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        moving.camera.jitter[1] = jitter, refused({"camera", "jitter", "at most 8"});
    moving.camera.jitter[1] = 0;
    frame.width = 30, frame.height = 34, refused({"30x34", "122x68", "1 to 4"});
    frame.width = 123, frame.height = 34, refused({"123x34", "122x68"});
    frame.width = 61, frame.height = 0, refused({"61x0"});
    frame.width = 0;
    frame.shutter = -1, refused({"shutter", "-1"}), frame.shutter = 0.5f;
    static_cast<void>(moving.ready_for(denoiser.get(), out, 3));
    std::erase_if(moving.channels, [](quell_channel const& each) { return each.name == std::string("motion"); });
    check_refused(quell_run(denoiser.get(), moving.ready()), QUELL_INVALID_ARGUMENT, {"'motion'", "missing"});
    step(2), step(3);

    auto const plain = made();
    frame.width = 30, frame.height = 34;
    check_refused(quell_run(plain.get(), moving.ready_for(plain.get(), out, 3)), QUELL_INVALID_ARGUMENT, {"30x34", "61x34", "resolve"});
}

TEST_CASE("anti-aliased: the C++ class says the jitter, and presets that read neither depth nor motion then do") {
    if (!has("none")) return;
    quell::Denoiser denoiser(resolved_settings("none", {2 * width, 2 * height}));
    CHECK(denoiser.reads() == std::vector<std::string>{"radiance", "motion", "depth"});
    Wall wall;
    denoiser.set("radiance", wall.rgb.data(), 3).set("motion", wall.motion.data(), 2).set("depth", wall.depth.data(), 1);
    std::vector<float> out(values({2 * width, 2 * height}, 3));
    CHECK_THROWS_AS(denoiser.run(out.data(), 3), quell::DenoiserError); // no jitter
    denoiser.set_jitter(0.25f, 0.f).run(out.data(), 3);
    CHECK(quell::tests::all_finite(out));
}

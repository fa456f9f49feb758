#include "wall.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <thread>

extern "C" float difference_of_both(int width, int height);

using namespace wall_test;

namespace {

/// The third of three frames.
std::vector<float> third(quell_denoiser* denoiser, Wall& wall) {
    for (unsigned i = 0; i < 3; ++i) {
        wall.shine(i);
        REQUIRE(quell_run(denoiser, wall.ready()) == QUELL_OK);
    }
    return wall.out;
}

} // namespace

TEST_CASE("a host with the headers too, fast math and no exceptions gets the same from both") {
    CHECK(difference_of_both(67, 33) < 2e-5f);
    CHECK(difference_of_both(3, 5) < 2e-5f);
}

TEST_CASE("any strides and formats that hold the same numbers give the same") {
    Wall wall;
    auto const wanted = third(made().get(), wall);
    SUBCASE("planes, rows from the bottom up, with gaps") {
        Wall other;
        constexpr std::ptrdiff_t gap = 7, row = (width + gap) * 4, plane = row * height;
        std::vector<float> planes((width + gap) * height * 3), output(planes.size(), -1.f);
        auto const image = [&](std::vector<float>& memory) {
            return quell_image{memory.data() + (width + gap) * (height - 1), QUELL_FLOAT32, 3, plane, 4, -row};
        };
        other.channels[0].image = image(planes), other.frame.output = image(output);
        auto const denoiser = made();
        auto const at = [&](std::size_t pixel, std::size_t c) {
            return c * static_cast<std::size_t>(plane / 4) + (height - 1 - pixel / width) * (width + gap) + pixel % width;
        };
        for (unsigned i = 0; i < 3; ++i) {
            other.shine(i);
            for (std::size_t p = 0; p < pixels * 3; ++p) planes[at(p / 3, p % 3)] = other.rgb[p];
            REQUIRE(quell_run(denoiser.get(), other.ready()) == QUELL_OK);
        }
        for (std::size_t p = 0; p < pixels * 3; ++p) REQUIRE(output[at(p / 3, p % 3)] == wanted[p]);
        CHECK(std::ranges::count(output, -1.f) == gap * height * 3); // gaps are not written
    }
    SUBCASE("four components, of which three are read and written") {
        Wall other;
        std::vector<float> rgba(pixels * 4, -1.f), output(pixels * 4, -1.f);
        other.channels[0].image = QUELL_PIXELS(rgba.data(), 4), other.frame.output = QUELL_PIXELS(output.data(), 4);
        auto const denoiser = made();
        for (unsigned i = 0; i < 3; ++i) {
            other.shine(i);
            for (std::size_t p = 0; p < pixels * 3; ++p) rgba[p / 3 * 4 + p % 3] = other.rgb[p];
            REQUIRE(quell_run(denoiser.get(), other.ready()) == QUELL_OK);
        }
        for (std::size_t p = 0; p < pixels * 3; ++p) REQUIRE(output[p / 3 * 4 + p % 3] == wanted[p]);
        CHECK(output[3] == -1.f);
    }
    SUBCASE("halves") {
        Wall other;
        // 0.5 in all components, as a half.
        std::vector<std::uint16_t> half(pixels * 3, 0x3800);
        other.channels[1].image = {half.data(), QUELL_FLOAT16, 3, 0, 0, 0};
        CHECK(third(made().get(), other) == wanted);
    }
}

TEST_CASE("motion of another convention is read as what it means") {
    auto const of_motion = [](quell_motion motion, float dx, float dy) {
        auto settings = settings_of();
        settings.motion = motion;
        auto const denoiser = made(settings);
        Wall wall;
        quell_camera camera{};
        camera.view[0] = camera.view[5] = camera.view[10] = camera.view[15] = 1;
        camera.projection[0] = camera.projection[5] = 1, camera.projection[11] = -1, camera.projection[14] = -1;
        wall.frame.camera = &camera;
        for (unsigned i = 0; i < 3; ++i) {
            camera.jitter[0] = motion.has_jitter != 0 ? 0.5f * static_cast<float>(i % 2) : 0;
            float const jitter = motion.has_jitter != 0 ? (i % 2 == 0 ? -0.5f : 0.5f) : 0; // before - now, taken off
            wall.shine(i);
            for (std::size_t p = 0; p < pixels; ++p) wall.motion[2 * p] = dx + jitter, wall.motion[2 * p + 1] = dy;
            REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        }
        return wall.out;
    };
    auto const wanted = of_motion({}, 3, -2);
    auto const same = [&](std::vector<float> const& out) {
        double worst = 0;
        for (std::size_t i = 0; i < out.size(); ++i) worst = std::max(worst, std::abs(static_cast<double>(out[i]) - wanted[i]));
        return worst < 1e-4;
    };
    CHECK(of_motion({1, 0, 0, 0}, -3, 2) == wanted);
    CHECK(of_motion({0, 0, 1, 0}, 3, 2) == wanted);
    CHECK(same(of_motion({0, 1, 0, 0}, 3.f / width, -2.f / height)));
    CHECK(same(of_motion({0, 2, 1, 0}, 6.f / width, 4.f / height)));
    CHECK(same(of_motion({0, 0, 0, 1}, 3, -2)));
    CHECK_FALSE(same(of_motion({}, 3, 2)));
}

TEST_CASE("motion that contains the jitter's change is what is left of it without, of the frames after too") {
    auto settings = settings_of("general");
    settings.stages = "two-sided";
    auto const last_with = [&](int has_jitter) {
        settings.motion.has_jitter = has_jitter;
        auto const denoiser = made(settings);
        std::vector<Wall> walls(6);
        std::vector<quell_camera> cameras(walls.size());
        std::vector<quell_frame> frames;
        for (std::size_t i = 0; i < walls.size(); ++i) {
            walls[i].shine(static_cast<unsigned>(i));
            auto& camera = cameras[i];
            camera.view[0] = camera.view[5] = camera.view[10] = camera.view[15] = 1;
            camera.projection[0] = camera.projection[5] = 1, camera.projection[11] = camera.projection[14] = -1;
            camera.jitter[0] = .25f * static_cast<float>(i * 3 % 4);
            float const change = camera.jitter[0] - (i > 0 ? cameras[i - 1].jitter[0] : 0.f);
            for (std::size_t p = 0; p < pixels; ++p) walls[i].motion[2 * p] = has_jitter != 0 ? 2.f + change : 2.f;
            walls[i].frame.camera = &camera;
            frames.push_back(*walls[i].ready());
        }
        for (std::size_t i = 0; i + 3 <= frames.size(); ++i) REQUIRE(quell_run_two_sided(denoiser.get(), &frames[i], 3) == QUELL_OK);
        return walls[frames.size() - 3].out;
    };
    CHECK(last_with(1) == last_with(0));
}

TEST_CASE("frames after the first make a picture cleaner, with alpha too") {
    auto settings = settings_of("general");
    settings.stages = "two-sided";
    auto const noise_with = [&](std::size_t count) {
        auto const denoiser = made(settings);
        bool const alpha = settings.alpha != 0;
        CHECK(quell_output_components(denoiser.get()) == (alpha ? 4 : 3));
        CHECK(quell_channel_is_optional(denoiser.get(), "motion_next") == 1);
        CHECK(quell_channel_is_optional(denoiser.get(), "motion") == 0);
        std::vector<Wall> walls(count);
        std::vector<std::vector<float>> rgba(count, std::vector<float>(pixels * 4, 0.5f));
        std::vector<float> out(pixels * 4);
        std::vector<quell_frame> frames;
        for (std::size_t i = 0; i < count; ++i) {
            walls[i].shine(static_cast<unsigned>(i));
            if (alpha) {
                for (std::size_t p = 0; p < pixels * 3; ++p) rgba[i][p / 3 * 4 + p % 3] = walls[i].rgb[p];
                walls[i].channels[0] = {"radiance_alpha", QUELL_PIXELS(rgba[i].data(), 4)};
            }
            frames.push_back(*walls[i].ready());
            frames.back().number = static_cast<int64_t>(i), frames.back().has_number = 1;
        }
        frames[0].output = QUELL_PIXELS(out.data(), alpha ? 4 : 3);
        REQUIRE(quell_run_two_sided(denoiser.get(), frames.data(), count) == QUELL_OK);
        std::size_t const components = alpha ? 4 : 3;
        double squares = 0;
        for (std::size_t p = 0; p < pixels; ++p) {
            for (std::size_t c = 0; c < 3; ++c) squares += std::pow(out[p * components + c] - 0.5, 2);
            if (alpha) CHECK(out[p * 4 + 3] == doctest::Approx(0.5));
        }
        return squares;
    };
    CHECK(noise_with(3) < 0.7 * noise_with(1));
    settings.alpha = 1;
    CHECK(noise_with(3) < 0.7 * noise_with(1));

    auto const denoiser = made();
    Wall wall;
    check_refused(quell_run_two_sided(denoiser.get(), wall.ready(), 1), QUELL_NOT_SUPPORTED, {"settings.stages", "two-sided"});
    check_refused(quell_run_two_sided(denoiser.get(), nullptr, 1), QUELL_INVALID_ARGUMENT, {"frames"});
    quell_denoiser* none = nullptr;
    settings.preset = "svgf";
    check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"alpha", "svgf", "general"});
    settings.alpha = 0;
    check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"two-sided", "svgf"});
}

TEST_CASE("results depend neither on the number of threads nor on whose they are") {
    Wall wall;
    auto const wanted = third(made().get(), wall);
    auto settings = settings_of();
    settings.threads = 1;
    CHECK(third(made(settings).get(), wall) == wanted);
    std::atomic<int> tasks = 0;
    settings.parallel_user = &tasks;
    settings.parallel = [](void* user, int32_t count, void (*task)(void*, int32_t), void* context) {
        for (int32_t i = count; i-- > 0;) task(context, i);
        *static_cast<std::atomic<int>*>(user) += count;
    };
    CHECK(third(made(settings).get(), wall) == wanted);
    CHECK(tasks > 0);
}

TEST_CASE("images lie in the caller's memory, a warm frame takes none, and all goes back") {
    struct Counted {
        long long now = 0, calls = 0, allowed = std::numeric_limits<long long>::max();
    } counted;
    auto settings = settings_of();
    settings.memory_user = &counted;
    settings.allocate = [](void* user, size_t bytes, size_t alignment) -> void* {
        auto& its = *static_cast<Counted*>(user);
        if (its.calls >= its.allowed) return nullptr;
        ++its.calls, ++its.now;
        return ::operator new[](bytes, std::align_val_t{alignment}, std::nothrow);
    };
    settings.release = [](void* user, void* memory) {
        --static_cast<Counted*>(user)->now;
        ::operator delete[](memory, std::align_val_t{64});
    };
    Wall wall;
    {
        auto const denoiser = made(settings);
        auto const wanted = third(denoiser.get(), wall);
        auto const calls = counted.calls;
        CHECK(calls > 0);
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
        CHECK(counted.calls == calls);
        // No memory is an error, after which the denoiser works as before.
        auto const other = made(settings);
        counted.allowed = counted.calls + 3;
        CHECK(quell_run(other.get(), wall.ready()) == QUELL_NO_MEMORY);
        counted.allowed = std::numeric_limits<long long>::max();
        CHECK(third(other.get(), wall) == wanted);
    }
    CHECK(counted.now == 0);
}

TEST_CASE("no image of the caller's is copied as a whole, except guides that passes look at from afar") {
    // Tall, so that one component of an image is more than all strips.
    constexpr int across = 64, down = 4096;
    constexpr std::size_t count = std::size_t{across} * down;
    constexpr double bytes_of_component = (across + 16) * down * 4.;
    struct Counted {
        std::map<void*, std::size_t> blocks;
        std::size_t bytes = 0;
    } counted;
    auto settings = settings_of();
    settings.width = across, settings.height = down, settings.threads = 1;
    settings.memory_user = &counted;
    settings.allocate = [](void* user, size_t bytes, size_t alignment) -> void* {
        auto& its = *static_cast<Counted*>(user);
        auto* const block = ::operator new[](bytes, std::align_val_t{alignment}, std::nothrow);
        its.blocks[block] = bytes, its.bytes += bytes;
        return block;
    };
    settings.release = [](void* user, void* memory) {
        auto& its = *static_cast<Counted*>(user);
        its.bytes -= its.blocks[memory];
        ::operator delete[](memory, std::align_val_t{64});
    };
    std::vector<float> const light(count * 3, 0.5f), depth(count, 4.f), motion(count * 2);
    std::vector<float> normal(count * 3), output(count * 3);
    for (std::size_t i = 2; i < normal.size(); i += 3) normal[i] = 1;
    quell_channel const channels[] = {{"radiance", QUELL_PIXELS(light.data(), 3)},
                                      {"albedo", QUELL_PIXELS(light.data(), 3)},
                                      {"normal", QUELL_PIXELS(normal.data(), 3)},
                                      {"depth", QUELL_PIXELS(depth.data(), 1)},
                                      {"motion", QUELL_PIXELS(motion.data(), 2)}};
    quell_frame frame = QUELL_FRAME;
    frame.channels = channels, frame.channel_count = std::size(channels), frame.output = QUELL_PIXELS(output.data(), 3);
    // How many components more than the plan says of a frame in planes of quell's own.
    auto const copied = [&](char const* preset) {
        settings.preset = preset;
        auto const denoiser = made(settings);
        for (int i = 0; i < 3; ++i) REQUIRE(quell_run(denoiser.get(), &frame) == QUELL_OK);
        CHECK(std::ranges::all_of(output, [](float value) { return std::abs(value - 0.5f) < 1e-6f; }));
        std::string const plan = quell_plan(denoiser.get());
        auto const planned = std::stod(plan.substr(plan.rfind(':') + 1)) / 4.;
        return static_cast<double>(counted.bytes) / bytes_of_component - planned;
    };
    CHECK(copied("surface-clamp") < 0.5 - 3); // the plan has an output of three
    CHECK(copied("svgf") < 0.5 + 4);          // depth and normal
    CHECK(counted.bytes == 0);
}

TEST_CASE("of fewer samples than pixels comes the same as of an image with NaN in all other pixels") {
    struct Pattern {
        quell_samples samples;
        bool side_by_side;
    };
    for (auto const& [given, side_by_side] : {Pattern{{2, 2, 0, 1, 0, 0, 0}, true}, Pattern{{2, 2, 0, 1, 1, width / 2, height / 2}, true},
                                              Pattern{{2, 1, 1, 1, 0, 0, 0}, true}, Pattern{{2, 1, 1, 0, 0, width, height}, false}}) {
        CAPTURE(given.columns);
        CAPTURE(given.rows);
        Wall wall, other;
        int const w = given.width > 0 ? given.width : (width + 1) / given.columns,
                  h = given.height > 0 ? given.height : height / given.rows;
        std::vector<float> stored(static_cast<std::size_t>(w * h * 3));
        std::vector<quell_samples> samples(5);
        samples[0] = given;
        other.channels[0].image = QUELL_PIXELS(stored.data(), 3), other.frame.samples = samples.data();
        auto const denoiser = made(), second = made();
        for (unsigned i = 0; i < 3; ++i) {
            wall.shine(i);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    int const column = x / given.columns, row = y / given.rows;
                    int const wanted_x = column * given.columns + (given.phase_x + (given.staggered != 0 ? row : 0)) % given.columns;
                    bool const has = x == wanted_x && y == row * given.rows + given.phase_y && (!side_by_side || (column < w && row < h));
                    for (int c = 0; c < 3; ++c) {
                        auto& value = wall.rgb[static_cast<std::size_t>((y * width + x) * 3 + c)];
                        if (has)
                            stored[static_cast<std::size_t>(side_by_side ? (row * w + column) * 3 + c : (y * w + x) * 3 + c)] = value;
                        else
                            value = std::numeric_limits<float>::quiet_NaN();
                    }
                }
            REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
            REQUIRE(quell_run(second.get(), other.ready()) == QUELL_OK);
        }
        CHECK(wall.out == other.out);
        quell_statistics counted = QUELL_STATISTICS;
        REQUIRE(quell_get_statistics(second.get(), &counted) == QUELL_OK);
        CHECK(counted.missing_samples >= static_cast<int64_t>(pixels) / 2);
    }
}

TEST_CASE("wrong frames are refused with a sentence, and the denoiser works as before") {
    Wall wall;
    auto const denoiser = made();
    auto const refused = [&](std::vector<std::string> const& words) {
        check_refused(quell_run(denoiser.get(), wall.ready()), QUELL_INVALID_ARGUMENT, words);
    };
    auto const good = wall.channels;
    auto const restore = [&] { wall.channels = good; };
    wall.channels.pop_back(), refused({"'motion'", "missing", "radiance"}), restore();
    wall.channels[1].name = "colour", refused({"'colour'", "svgf", "albedo"}), restore();
    wall.channels[1].name = nullptr, refused({"channels[1]", "null"}), restore();
    wall.channels[1].name = "depth", refused({"'depth'", "twice"}), restore();
    wall.channels.push_back(good[0]), refused({"'radiance'", "twice"}), restore();
    wall.channels[0].image.data = nullptr, refused({"'radiance'", "null"}), restore();
    wall.channels[0].image.format = 7, refused({"'radiance'", "format 7", "QUELL_FLOAT32"}), restore();
    wall.channels[0].image.components = 2, refused({"'radiance'", "2 components", "3"}), restore();
    wall.channels[0].image.row_stride = width * 12 + 2, refused({"'radiance'", "stride", "4"}), restore();
    wall.channels[0].image.data = reinterpret_cast<char*>(wall.rgb.data()) + 1, refused({"'radiance'", "aligned"}), restore();
    wall.frame.output.data = nullptr, refused({"output", "null"});
    wall.frame.output = QUELL_PIXELS(wall.rgb.data() + 30, 3), refused({"output", "overlaps", "radiance"});
    wall.frame.output = QUELL_PIXELS(wall.out.data(), 3);
    wall.frame.struct_size = 8, refused({"struct_size", "QUELL_FRAME"}), wall.frame.struct_size = sizeof(quell_frame);
    wall.frame.device = &wall, refused({"device"}), wall.frame.device = nullptr;
    int32_t const fractions[] = {1, 2, 1, 1, 1};
    wall.frame.fractions = fractions, refused({"'albedo'", "fraction of 2"}), wall.frame.fractions = nullptr;
    wall.frame.struct_size += 8, refused({"struct_size"}), wall.frame.struct_size -= 8; // what lies behind it is set
    wall.frame.shutter = -1, refused({"shutter", "-1"}), wall.frame.shutter = 0.5f;
    std::vector<quell_samples> samples(5);
    wall.frame.samples = samples.data();
    samples[0] = {2, 2, 0, 0, 0, 20, 17}, refused({"'radiance'", "20x17", "61x34", "31x17"});
    samples[0] = {9, 2, 0, 0, 0, 0, 0}, refused({"'radiance'", "9x2", "1 to 8"});
    samples[0] = {2, 1, 1, 0, 1, 0, 0}, refused({"'radiance'", "phase of 0, 1", "2x1"});
    samples[0] = {0, 0, 0, 0, 0, 8, 8}, refused({"'radiance'", "8x8", "61x34", "1 to 8"});
    samples[0] = {}, samples[3] = {2, 2, 0, 0, 0, 0, 0}, refused({"'depth'", "every pixel"});
    wall.frame.samples = nullptr;
    auto const other = made();
    Wall same;
    CHECK(third(denoiser.get(), wall) == third(other.get(), same));
}

TEST_CASE("wrong settings and wrong calls are refused with a sentence") {
    quell_denoiser* denoiser = nullptr;
    auto const refused = [&](quell_settings const& settings, quell_status status, std::vector<std::string> const& words) {
        check_refused(quell_create(&settings, &denoiser), status, words);
        CHECK(denoiser == nullptr);
    };
    refused(settings_of("best"), QUELL_UNKNOWN_PRESET, {"'best'", "svgf"});
    refused(settings_of(nullptr), QUELL_UNKNOWN_PRESET, {"svgf"});
    auto settings = settings_of();
    settings.width = 0, refused(settings, QUELL_INVALID_ARGUMENT, {"0x34"}), settings.width = width;
    settings.output_width = 5, refused(settings, QUELL_INVALID_ARGUMENT, {"5x0", "output_width"}), settings.output_width = 0;
    settings.motion.unit = 3, refused(settings, QUELL_INVALID_ARGUMENT, {"motion.unit", "3"}), settings.motion.unit = 0;
    settings.threads = -1, refused(settings, QUELL_INVALID_ARGUMENT, {"threads"}), settings.threads = 0;
    settings.device = 7, refused(settings, QUELL_INVALID_ARGUMENT, {"device", "7", "QUELL_CPU"}), settings.device = QUELL_CUDA;
    if (quell_device_preset_name(QUELL_CUDA, 0) == nullptr) refused(settings, QUELL_NOT_SUPPORTED, {"without CUDA", "QUELL_CUDA=ON"});
    settings.device = QUELL_CPU;
    CHECK(std::string(quell_device_preset_name(QUELL_CPU, 0)) == quell_preset_name(0));
    settings.instruction_set = "z80", refused(settings, QUELL_NOT_SUPPORTED, {"'z80'", quell_instruction_set_name(0)});
    settings.instruction_set = nullptr, settings.struct_size = 1, refused(settings, QUELL_INVALID_ARGUMENT, {"struct_size"});
    settings = settings_of(), settings.width = settings.height = 1 << 20;
    CHECK(quell_create(&settings, &denoiser) == QUELL_OK); // images are made by the first frame
    Owned const huge(denoiser);
    Wall wall;
    CHECK(quell_run(huge.get(), wall.ready()) != QUELL_OK);
    CHECK(std::string(quell_error()) != "");

    check_refused(quell_create(nullptr, &denoiser), QUELL_INVALID_ARGUMENT, {"settings"});
    check_refused(quell_create(&settings, nullptr), QUELL_INVALID_ARGUMENT, {"denoiser"});
    check_refused(quell_run(nullptr, wall.ready()), QUELL_INVALID_ARGUMENT, {"denoiser"});
    auto const good = made();
    check_refused(quell_run(good.get(), nullptr), QUELL_INVALID_ARGUMENT, {"frame"});
    CHECK(quell_channel_name(good.get(), -1) == nullptr);
    CHECK(quell_channel_components(good.get(), "nothing") == 0);
    quell_destroy(nullptr);
}

TEST_CASE("two threads with one denoiser: one of them is told so; with two they do not meet") {
    Wall wall;
    auto settings = settings_of();
    static quell_denoiser* running;
    static quell_frame const* frame;
    static quell_status meanwhile;
    // From within a frame, as another thread would.
    settings.parallel = [](void*, int32_t count, void (*task)(void*, int32_t), void* context) {
        std::thread([] { meanwhile = quell_run(running, frame); }).join();
        for (int32_t i = 0; i < count; ++i) task(context, i);
    };
    auto const denoiser = made(settings);
    running = denoiser.get(), frame = wall.ready();
    CHECK(quell_run(denoiser.get(), frame) == QUELL_OK);
    CHECK(meanwhile == QUELL_BUSY);

    std::vector<float> first, second;
    auto const alone = [](std::vector<float>& to) {
        Wall own;
        to = third(made().get(), own);
    };
    std::thread a([&] { alone(first); }), b([&] { alone(second); });
    a.join(), b.join();
    CHECK((first == second && !first.empty()));
}

TEST_CASE("the C++ class: channels, plan, statistics, cuts, errors, moves") {
    quell::Denoiser denoiser("svgf", width, height);
    CHECK(denoiser.reads() == std::vector<std::string>{"radiance", "albedo", "motion", "depth", "normal"});
    CHECK(denoiser.plan().find("| temporal |") != std::string::npos);
    CHECK_THROWS_AS(quell::Denoiser("best", width, height), quell::DenoiserError);
    Wall wall;
    for (auto const& each : wall.channels) denoiser.set(each.name, each.image);
    denoiser.run(wall.out.data(), 3);
    auto moved = std::move(denoiser);
    moved.run(wall.out.data(), 3);
    CHECK(moved.statistics().frames == 2);
    moved.forget();
    wall.rgb[0] = std::numeric_limits<float>::quiet_NaN(), wall.normal[2] = 2;
    moved.run(wall.out.data(), 3);
    auto const counted = moved.statistics();
    CHECK((counted.frames == 1 && counted.resets == 2 && counted.missing_samples == 1 && counted.repaired_guides == 1));
    CHECK(counted.bytes > pixels * 50);
}

TEST_CASE("guides that a preset accumulates are copied: the means of the frames so far") {
    auto const settings = settings_of("accumulated");
    quell_denoiser* created = nullptr;
    auto const status = quell_create(&settings, &created);
    Owned const denoiser(created);
    if (status == QUELL_UNKNOWN_PRESET) return; // the library was built for others
    REQUIRE(status == QUELL_OK);
    CHECK(quell_guide_name(denoiser.get(), 0) == std::string("mean_albedo"));
    CHECK(quell_guide_name(denoiser.get(), 1) == std::string("mean_normal"));
    CHECK(quell_guide_name(denoiser.get(), 2) == nullptr);
    Wall wall;
    std::vector<float> guide(pixels * 4, -1.f);
    auto const image = QUELL_PIXELS(guide.data(), 4);
    check_refused(quell_copy_guide(denoiser.get(), "mean_albedo", &image), QUELL_INVALID_ARGUMENT, {"no frame"});
    for (float const albedo : {0.5f, 0.25f}) {
        std::ranges::fill(wall.albedo, albedo);
        std::ranges::fill(wall.rgb, albedo); // light of 1, which does not change
        REQUIRE(quell_run(denoiser.get(), wall.ready()) == QUELL_OK);
    }
    REQUIRE(quell_copy_guide(denoiser.get(), "mean_albedo", &image) == QUELL_OK);
    CHECK(guide[4 * 700 + 1] == doctest::Approx(0.375));
    CHECK(guide[4 * 700 + 3] == -1.f);
    REQUIRE(quell_copy_guide(denoiser.get(), "mean_normal", &image) == QUELL_OK);
    CHECK(guide[4 * 700 + 2] == 1.f);

    // A frame that is refused leaves them as they were.
    wall.frame.shutter = -1;
    check_refused(quell_run(denoiser.get(), wall.ready()), QUELL_INVALID_ARGUMENT, {"shutter"});
    std::vector<float> same(pixels * 4, -1.f);
    auto const there = QUELL_PIXELS(same.data(), 4);
    REQUIRE(quell_copy_guide(denoiser.get(), "mean_normal", &there) == QUELL_OK);
    CHECK(same == guide);

    auto const two = QUELL_PIXELS(guide.data(), 2);
    check_refused(quell_copy_guide(denoiser.get(), "mean_normal", &two), QUELL_INVALID_ARGUMENT, {"mean_normal", "2 components"});
    check_refused(quell_copy_guide(denoiser.get(), "depth", &image), QUELL_NOT_SUPPORTED, {"depth", "mean_albedo"});
    check_refused(quell_copy_guide(made().get(), "mean_normal", &image), QUELL_NOT_SUPPORTED, {"svgf", "the preset accumulated"});
    check_refused(quell_copy_guide(denoiser.get(), nullptr, &image), QUELL_INVALID_ARGUMENT, {"null"});
    CHECK(quell_guide_name(nullptr, 0) == nullptr);
    CHECK(quell_guide_name(made().get(), 0) == nullptr);
}

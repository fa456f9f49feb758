#include "device.hpp"
#include "sequence.hpp"

#include <doctest/doctest.h>

#include <library/cuda/cuda_presets.hpp>
#include <library/images_of_frame.hpp>
#include <quell_denoiser.hpp>

#include <memory>

/// A preset as programs know it, of which no code for a CPU is there.
std::vector<quell_library::CompiledPreset> const& quell_library::compiled_presets() {
    static auto const all = [] {
        CompiledPreset svgf{.name = "svgf"}, other{.name = "general"};
        for_each_channel(decltype(emulated_cuda::preset<2>())::reads{},
                         [&](auto c) { svgf.usual.channels.push_back({.name = c.name, .components = c.components}); });
        svgf.usual.output_components = 3;
        return std::vector{svgf, other};
    }();
    return all;
}

// libquell on the emulated device: what a host hands over lies in memory that the host itself can't touch.
namespace {
namespace device = emulated_cuda;

constexpr auto svgf = device::preset<2>();
using Frame = quell::Frame<decltype(svgf)::reads>;
constexpr int width = device::Step{}.width, height = device::Step{}.height;
constexpr std::size_t pixels = std::size_t{width} * height;

struct Destroy {
    void operator()(quell_denoiser* denoiser) const { quell_destroy(denoiser); }
};
using Owned = std::unique_ptr<quell_denoiser, Destroy>;

quell_settings settings_of(cudaStream_t stream = nullptr) {
    quell_settings settings = QUELL_SETTINGS;
    settings.preset = "svgf", settings.width = width, settings.height = height;
    settings.device = QUELL_CUDA, settings.stream = stream;
    return settings;
}
Owned made(quell_settings const& settings) {
    quell_denoiser* denoiser = nullptr;
    auto const status = quell_create(&settings, &denoiser);
    INFO(std::string(quell_error()));
    REQUIRE(status == QUELL_OK);
    return Owned(denoiser);
}
std::string refused(quell_settings const& settings, quell_status wanted) {
    quell_denoiser* denoiser = nullptr;
    CHECK(quell_create(&settings, &denoiser) == wanted);
    CHECK(denoiser == nullptr);
    return quell_error();
}

/// Memory of the host or of the device, filled with numbers of the host's.
class Block {
    void* memory = nullptr;
    bool on_device;

public:
    Block(bool d, void const* from, std::size_t bytes) : on_device(d) {
        if (!on_device)
            memory = ::operator new(bytes), std::memcpy(memory, from, bytes);
        else {
            REQUIRE(cudaMalloc(&memory, bytes) == cudaSuccess);
            REQUIRE(cudaMemcpy(memory, from, bytes, cudaMemcpyDefault) == cudaSuccess);
        }
    }
    Block(Block const&) = delete;
    Block& operator=(Block const&) = delete;
    ~Block() { on_device ? static_cast<void>(cudaFree(memory)) : ::operator delete(memory); }
    [[nodiscard]] void* data() const { return memory; }
};

/// A frame in the words of quell.h, pixel by pixel.
struct Given {
    std::vector<std::unique_ptr<Block>> blocks;
    std::vector<quell_channel> channels;
    std::vector<quell_samples> samples;
    quell_camera camera{};
    quell_frame frame = QUELL_FRAME;
    std::unique_ptr<Block> output;

    /// @param is_on_device of a channel's name
    /// @param halves for the albedo
    Given(Frame const& from, auto const& is_on_device, bool halves = false) {
        for_each_channel(Frame::channels{}, [&](auto c) {
            bool const half = halves && std::string_view(c.name) == quell::albedo.name;
            std::vector<float> numbers;
            std::vector<std::uint16_t> short_numbers;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    for (int k = 0; k < c.components; ++k) {
                        numbers.push_back(from[c].get(k, x, y)), short_numbers.emplace_back();
                        quell::Float16::set(&short_numbers.back(), numbers.back());
                    }
            auto const& block =
                half ? blocks.emplace_back(std::make_unique<Block>(is_on_device(c.name), short_numbers.data(), short_numbers.size() * 2))
                     : blocks.emplace_back(std::make_unique<Block>(is_on_device(c.name), numbers.data(), numbers.size() * 4));
            channels.push_back({c.name, {block->data(), half ? QUELL_FLOAT16 : QUELL_FLOAT32, c.components, 0, 0, 0}});
        });
        std::memcpy(camera.view, &from.camera.view, sizeof(camera.view));
        std::memcpy(camera.projection, &from.camera.projection, sizeof(camera.projection));
        camera.jitter[0] = from.camera.jitter.x, camera.jitter[1] = from.camera.jitter.y;
        std::vector<float> const nothing(pixels * 3, -1.f);
        output = std::make_unique<Block>(is_on_device("output"), nothing.data(), nothing.size() * 4);
        frame.channels = channels.data(), frame.channel_count = channels.size(), frame.camera = &camera;
        frame.number = *from.number, frame.has_number = 1;
        frame.output = QUELL_PIXELS(output->data(), 3);
    }
    [[nodiscard]] std::vector<float> picture() const {
        std::vector<float> numbers(pixels * 3);
        REQUIRE(cudaMemcpy(numbers.data(), output->data(), numbers.size() * 4, cudaMemcpyDefault) == cudaSuccess);
        return numbers;
    }
};
Frame rendered(std::size_t step) {
    Frame frame({width, height});
    device::fill(frame, device::steps[step]);
    return frame;
}
constexpr auto everywhere = [](std::string_view) { return true; };
constexpr auto nowhere = [](std::string_view) { return false; };

/// The pictures of the steps of one size.
/// @param stages behind the preset; null: none
/// @param number of the preset that Serial runs
void check_bits(auto const& is_on_device, char const* stages = nullptr, int number = 2) {
    auto const expected = device::by_serial(number);
    cudaStream_t stream = nullptr;
    cudaStreamCreate(&stream);
    {
        auto settings = settings_of(stream);
        settings.stages = stages, settings.samples_per_pixel = 4;
        auto const denoiser = made(settings);
        for (std::size_t i = 0; i < 6; ++i) {
            CAPTURE(i);
            if (device::steps[i].forgotten) quell_forget(denoiser.get());
            Given const given(rendered(i), is_on_device);
            auto const status = quell_run(denoiser.get(), &given.frame);
            CAPTURE(std::string(quell_error()));
            REQUIRE(status == QUELL_OK);
            cudaStreamSynchronize(stream);
            CHECK(given.picture() == expected[i].picture);
            quell_statistics counted = QUELL_STATISTICS;
            REQUIRE(quell_get_statistics(denoiser.get(), &counted) == QUELL_OK);
            CHECK(counted.missing_samples == expected[i].missing);
            CHECK(counted.repaired_guides == expected[i].repaired);
        }
    }
    cudaStreamDestroy(stream);
}
} // namespace

TEST_CASE("libquell gives the bits of Serial from device pointers, from the host's, and from some of each") {
    check_bits(everywhere);
    check_bits(nowhere);
    check_bits([](std::string_view name) { return name == "normal" || name == "output"; });
}

TEST_CASE(
    "libquell puts stages behind a preset on the device: light, colours and resolve with the bits of Serial, and one of a host's own") {
    check_bits(everywhere, "light", 5);
    check_bits(nowhere, "light", 5);
    check_bits([](std::string_view name) { return name == "radiance"; }, "light", 5);
    check_bits(everywhere, "colours", 6);
    check_bits(everywhere, "resolve", 7);

    auto settings = settings_of();
    settings.stages = "half";
    auto const denoiser = made(settings);
    Given const given(rendered(0), everywhere);
    REQUIRE(quell_run(denoiser.get(), &given.frame) == QUELL_OK);
    cudaStreamSynchronize(nullptr);
    auto const picture = given.picture(), plain = device::by_serial(2)[0].picture;
    auto const samples = device::components_of_picture(rendered(0)[quell::radiance].view());
    for (std::size_t i = 0; i < picture.size(); ++i)
        CHECK(picture[i] == doctest::Approx(quell::is_finite(samples[i]) ? .5f * (plain[i] + samples[i]) : plain[i]));
}

TEST_CASE("a warm frame of device pointers allocates nothing, waits for nothing and is on its way when quell_run returns") {
    auto settings = settings_of();
    settings.stages = "light,half";
    auto const denoiser = made(settings);
    Given given(rendered(0), everywhere);
    for (int i = 0; i < 4; ++i, ++given.frame.number) REQUIRE(quell_run(denoiser.get(), &given.frame) == QUELL_OK);
    cudaStreamSynchronize(nullptr);
    auto const before = device::counts();
    REQUIRE(quell_run(denoiser.get(), &given.frame) == QUELL_OK);
    auto const& now = device::counts();
    CHECK(now.kernels == before.kernels);
    CHECK(now.waits == before.waits);
    CHECK(now.allocations == before.allocations);
    CHECK(now.graphs == before.graphs);
    cudaStreamSynchronize(nullptr);
    CHECK(now.kernels > before.kernels);
}

TEST_CASE("what has to be converted is, on the device as from the host") {
    std::vector<std::vector<float>> pictures;
    for (bool const on_device : {false, true}) {
        auto settings = settings_of();
        settings.motion = {.from_previous = 1, .unit = 1, .y_up = 1, .has_jitter = 1};
        auto const denoiser = made(settings);
        for (std::size_t i = 0; i < 3; ++i) {
            Given given(
                rendered(i), [&](std::string_view) { return on_device; }, true);
            given.samples.resize(given.channels.size());
            for (std::size_t c = 0; c < given.channels.size(); ++c)
                if (std::string_view(given.channels[c].name) == quell::radiance.name)
                    given.samples[c] = {2, 1, 1, static_cast<int>(i % 2), 0, width, height};
            given.frame.samples = given.samples.data();
            REQUIRE(quell_run(denoiser.get(), &given.frame) == QUELL_OK);
            cudaStreamSynchronize(nullptr);
            pictures.push_back(given.picture());
        }
    }
    for (std::size_t i = 0; i < 3; ++i) CHECK(pictures[i] == pictures[i + 3]);
    CHECK(pictures[2] != device::by_serial(2)[2].picture);
    CHECK(std::ranges::none_of(pictures[2], [](float value) { return value == -1.f || !quell::is_finite(value); }));
}

TEST_CASE("what a device can't do is said, and what it lacks") {
    auto const settings = settings_of();
    auto changed = settings;
    changed.stages = "two-sided";
    CHECK(refused(changed, QUELL_NOT_SUPPORTED) ==
          "settings.stages: there is no 'two-sided' for CUDA; give some of these, with commas between: light, colours, half, resolve");
    changed = settings, changed.output_width = 2 * width, changed.output_height = 2 * height;
    CHECK(refused(changed, QUELL_NOT_SUPPORTED).find("QUELL_CUDA with an output of another size") != std::string::npos);
    changed = settings, changed.stages = "colours,resolve";
    CHECK(refused(changed, QUELL_NOT_SUPPORTED).find("leave one of the two out") != std::string::npos);
    changed = settings, changed.preset = "trmv";
    CHECK(refused(changed, QUELL_UNKNOWN_PRESET) == "settings.preset: there is no 'trmv' for CUDA; give one of: svgf");
    changed = settings, changed.device = 7;
    CHECK(refused(changed, QUELL_INVALID_ARGUMENT) == "settings.device: 7; give QUELL_CPU or QUELL_CUDA");
    CHECK(std::string(quell_device_preset_name(QUELL_CUDA, 0)) == "svgf");
    CHECK(quell_device_preset_name(QUELL_CUDA, 1) == nullptr);
    CHECK(std::string(quell_stage_name(QUELL_CUDA, 0)) == "light");
    CHECK(std::string(quell_stage_name(QUELL_CUDA, 2)) == "half");
    CHECK(quell_stage_name(QUELL_CUDA, 4) == nullptr);

    device::fail("cudaGetDeviceCount", 0, cudaErrorNoDevice);
    CHECK(refused(settings, QUELL_NOT_SUPPORTED) ==
          "the device: there is no GPU to run on (no CUDA-capable device is detected); use a machine with an NVIDIA "
          "GPU and a driver that is as new as CUDA, or the CPU");
    device::restart();
}

TEST_CASE("too little memory is told beforehand, and how much there must be") {
    auto const held = device::counts().bytes;
    device::limit_memory(held + 1000);
    auto const said = refused(settings_of(), QUELL_NO_MEMORY);
    CHECK(said.find("memory of the device: history and scratch of 75x43 pixels take ") == 0);
    CHECK(said.find(" bytes, and 1000 are free; give smaller frames") != std::string::npos);
    auto const needed = std::stoul(said.substr(said.find("take ") + 5));
    device::limit_memory(std::numeric_limits<std::size_t>::max());

    // It is what it takes, apart from the padding of rows.
    auto const denoiser = made(settings_of());
    Given given(rendered(0), everywhere);
    for (int i = 0; i < 3; ++i, ++given.frame.number) REQUIRE(quell_run(denoiser.get(), &given.frame) == QUELL_OK);
    quell_statistics counted = QUELL_STATISTICS;
    REQUIRE(quell_get_statistics(denoiser.get(), &counted) == QUELL_OK);
    CHECK(counted.bytes >= needed);
    CHECK(counted.bytes < 2 * needed);

    // Where it runs out on the way, the denoiser can be used again.
    auto const other = made(settings_of());
    device::limit_memory(device::counts().bytes + 20000);
    CHECK(quell_run(other.get(), &given.frame) == QUELL_NO_MEMORY);
    CHECK(std::string(quell_error()).find("memory of the device: there is none for ") == 0);
    device::limit_memory(std::numeric_limits<std::size_t>::max());
    CHECK(quell_run(other.get(), &given.frame) == QUELL_OK);
    cudaStreamSynchronize(nullptr);
}

TEST_CASE("a frame that is refused leaves nothing behind, and a fault of the device is told") {
    auto const expected = device::by_serial(2);
    auto const denoiser = made(settings_of());
    Given given(rendered(0), everywhere, true); // one image is converted, before the shutter is looked at
    given.frame.shutter = -1;
    CHECK(quell_run(denoiser.get(), &given.frame) == QUELL_INVALID_ARGUMENT);
    for (std::size_t i = 0; i < 2; ++i) {
        Given const next(rendered(i), everywhere);
        REQUIRE(quell_run(denoiser.get(), &next.frame) == QUELL_OK);
        cudaStreamSynchronize(nullptr);
        CHECK(next.picture() == expected[i].picture);
    }
    device::break_device();
    Given const broken(rendered(2), everywhere);
    CHECK(quell_run(denoiser.get(), &broken.frame) == QUELL_OK); // nothing waits
    cudaStreamSynchronize(nullptr);
    CHECK(quell_run(denoiser.get(), &broken.frame) == QUELL_FAILED);
    CHECK(std::string(quell_error()).find("context is lost") != std::string::npos);
    quell_statistics counted = QUELL_STATISTICS;
    CHECK(quell_get_statistics(denoiser.get(), &counted) == QUELL_OK);
    device::restart();
}

/// A step's picture as a program gets it.
void run_step(quell_library::CompiledDenoiser& denoiser, quell_library::Way const& way, auto const& step, std::vector<float>& picture) {
    if (step.forgotten) denoiser.forget();
    Frame frame({step.width, step.height});
    device::fill(frame, step);
    auto const images = quell_library::images_of(way, frame);
    denoiser.run({&images, 1}, quell_library::image_of(picture, 3, frame.size));
}

TEST_CASE("programs get the bits of Serial from presets on a device, and its sentences as errors") {
    auto const expected = device::by_serial(2);
    auto const& presets = quell_library::cuda_presets();
    REQUIRE(presets.size() == 1);
    CHECK(presets[0].name == "svgf");
    auto const& way = presets[0].usual;
    quell_library::Parallel const parallel{.run = quell_library::run_here};
    auto const denoiser = way.make({width, height}, parallel, {});
    std::vector<float> picture;
    for (std::size_t i = 0; i < device::steps.size(); ++i) { // of two sizes
        CAPTURE(i);
        run_step(*denoiser, way, device::steps[i], picture);
        CHECK(picture == expected[i].picture);
        CHECK(denoiser->statistics().missing_samples == expected[i].missing);
    }
    CHECK(denoiser->bytes() > 0);
    CHECK(device::counts().managed_bytes == 0);
    device::limit_memory(device::counts().bytes + 1000);
    try {
        way.make({width, height}, parallel, {});
        FAIL("there is too little memory");
    } catch (quell::Error const& error) {
        CHECK(error.subject == "memory of the device");
        CHECK(error.remedy.find("give smaller frames") == 0);
    }
    device::limit_memory(std::numeric_limits<std::size_t>::max());
}

TEST_CASE("where a device has too little memory for a program's frames, images move to and from it, and the bits are the same") {
    auto const expected = device::by_serial(2);
    auto const& way = quell_library::cuda_presets()[0].usual;
    quell_library::Parallel const parallel{.run = quell_library::run_here};
    device::move_memory(true);
    std::size_t bytes = 0;
    for (bool const has_room : {true, false}) {
        if (!has_room) device::limit_memory(device::counts().bytes + bytes / 2);
        auto const denoiser = way.make({width, height}, parallel, {});
        std::vector<float> picture;
        for (std::size_t i = 0; i < device::steps.size(); ++i) {
            run_step(*denoiser, way, device::steps[i], picture);
            CAPTURE(i);
            CHECK(picture == expected[i].picture);
            CHECK((device::counts().managed_bytes == 0) == has_room);
            bytes = std::max(bytes, device::counts().bytes);
        }
    }
    CHECK(device::counts().managed_bytes == 0);
    device::limit_memory(device::counts().bytes + 1000);
    refused(settings_of(), QUELL_NO_MEMORY); // a host with a frame to show in time rather knows
    device::limit_memory(std::numeric_limits<std::size_t>::max());
    device::move_memory(false);
}

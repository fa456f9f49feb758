#include "../programs/programs.hpp"

#include <quell_exr.h>

#include <cstring>
#include <memory>

namespace quell::tests {

namespace {

constexpr Extent size{48, 32};

struct Close {
    void operator()(quell_exr* file) const { quell_exr_close(file); }
};
using File = std::unique_ptr<quell_exr, Close>;
File opened(std::filesystem::path const& path) {
    quell_exr* file = nullptr;
    auto const status = quell_exr_open(path.c_str(), &file);
    INFO(std::string(quell_exr_error()));
    REQUIRE(status == QUELL_OK);
    return File(file);
}
using Denoiser = std::unique_ptr<quell_denoiser, decltype(&quell_destroy)>;
Denoiser svgf(Extent of = size) {
    quell_settings settings = QUELL_SETTINGS;
    settings.preset = "svgf", settings.width = of.width, settings.height = of.height;
    quell_denoiser* denoiser = nullptr;
    REQUIRE(quell_create(&settings, &denoiser) == QUELL_OK);
    return {denoiser, quell_destroy};
}
/// What is said about a call.
void refused(quell_status status, quell_status wanted, std::initializer_list<std::string> words) {
    CHECK(status == wanted);
    std::string const sentence = quell_exr_error();
    INFO(sentence);
    CHECK_FALSE(contains(sentence, "\n"));
    for (auto const& word : words) CHECK(contains(sentence, word));
}
float value_of(quell_image const& image, int c, int x, int y) {
    return *reinterpret_cast<float const*>(static_cast<std::byte const*>(image.data) + c * image.component_stride + x * image.pixel_stride +
                                           y * image.row_stride);
}
/// A frame's channel; one without data where it has none of that name.
quell_image image_in(quell_frame const& frame, std::string_view name) {
    for (std::size_t i = 0; i < frame.channel_count; ++i)
        if (frame.channels[i].name == name) return frame.channels[i].image;
    return {};
}
template <class C, class Set> void check_same(quell_frame const& frame, C channel, Frame<Set> const& wanted) {
    auto const image = image_in(frame, C::name);
    REQUIRE(image.data != nullptr);
    REQUIRE((image.components == C::components && image.format == QUELL_FLOAT32));
    auto const view = wanted[channel].view();
    for (int c = 0; c < C::components; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) REQUIRE(value_of(image, c, x, y) == view.get(c, x, y));
}

io::ExrImage image_with_attributes() {
    auto image = noisy_image(size, 3);
    Camera camera;
    camera.projection[2][2] = -1.5f, camera.jitter = {0.25f, -0.125f};
    io::put_camera(image, camera);
    image.attributes["quell:shutter"] = 0.75f;
    image.attributes["owner"] = std::string("nobody");
    image.attributes["samples"] = 3;
    return image;
}

} // namespace

TEST_CASE("a header's size, channels, camera, shutter and attributes") {
    Folder const folder;
    io::write_exr(folder / "a.exr", image_with_attributes());
    auto const file = opened(folder / "a.exr");
    quell_exr_info info = QUELL_EXR_INFO;
    REQUIRE(quell_exr_get_info(file.get(), &info) == QUELL_OK);
    CHECK((info.width == size.width && info.height == size.height));
    CHECK((info.has_camera == 1 && info.camera.projection[10] == -1.5f && info.camera.view[5] == 1.f));
    CHECK((info.camera.jitter[0] == 0.25f && info.camera.jitter[1] == -0.125f));
    CHECK((info.has_shutter == 1 && info.shutter == 0.75f));

    std::vector<std::string> channels, attributes;
    for (int i = 0; auto const* const name = quell_exr_channel_name(file.get(), i); ++i) channels.push_back(name);
    for (int i = 0; auto const* const name = quell_exr_attribute_name(file.get(), i); ++i) attributes.push_back(name);
    for (auto const* const name : {"R", "albedo.G", "depth.Z", "motion.Y"}) CHECK(std::ranges::count(channels, name) == 1);
    for (auto const* const name : {"owner", "quell:view", "samples"}) CHECK(std::ranges::count(attributes, name) == 1);
    CHECK(std::string(quell_exr_attribute_text(file.get(), "owner")) == "nobody");
    CHECK(quell_exr_attribute_text(file.get(), "samples") == nullptr);
    double numbers[16] = {};
    CHECK((quell_exr_attribute_numbers(file.get(), "samples", numbers) == 1 && numbers[0] == 3));
    CHECK((quell_exr_attribute_numbers(file.get(), "quell:jitter", numbers) == 2 && numbers[1] == -0.125));
    CHECK((quell_exr_attribute_numbers(file.get(), "quell:projection", numbers) == 16 && numbers[10] == -1.5));
    CHECK(quell_exr_attribute_numbers(file.get(), "owner", numbers) == 0);
    CHECK(std::string(quell_exr_signal_name(file.get(), 0)) == "radiance");
    CHECK(quell_exr_signal_name(file.get(), 1) == nullptr);
}

TEST_CASE("a frame is what the headers read, and a denoiser takes it as it is") {
    Folder const folder;
    io::write_exr(folder / "a.exr", image_with_attributes());
    auto const file = opened(folder / "a.exr");
    auto const denoiser = svgf();
    quell_frame frame = QUELL_FRAME;
    REQUIRE(quell_exr_read_for(file.get(), denoiser.get(), &frame) == QUELL_OK);
    DenoiseFrame wanted(size);
    io::load(wanted, io::read_exr(folder / "a.exr"));
    for_each_channel(DenoiseFrame::channels{}, [&](auto channel) { check_same(frame, channel, wanted); });
    REQUIRE(frame.camera != nullptr);
    CHECK(std::memcmp(frame.camera, &wanted.camera, sizeof(quell_camera)) == 0);
    CHECK(frame.shutter == 0.75f);

    std::vector<float> out(static_cast<std::size_t>(size.pixels()) * 3, -1.f);
    frame.output = QUELL_PIXELS(out.data(), 3);
    CHECK(quell_run(denoiser.get(), &frame) == QUELL_OK);
    CHECK(std::ranges::count(out, -1.f) == 0);
}

TEST_CASE("channels by other names, and those that a file lacks") {
    Folder const folder;
    auto const at = [](float factor) { return [factor](int x, int y) { return factor * static_cast<float>(x + 100 * y); }; };
    io::write_exr(folder / "a.exr", {.size = size,
                                     .planes = {plane("beauty.r", size, at(1)), plane("beauty.g", size, at(2)),
                                                plane("beauty.b", size, at(3)), plane("Z", size, at(4))}});
    auto const file = opened(folder / "a.exr");
    CHECK(quell_exr_signal_name(file.get(), 0) == nullptr);
    quell_frame frame = QUELL_FRAME;
    REQUIRE(quell_exr_want(file.get(), "depth", 0, nullptr) == QUELL_OK);
    refused(quell_exr_read(file.get(), 0, 0, &frame), QUELL_INVALID_ARGUMENT, {"a.exr", "beauty.r"}); // whose names are these?
    char const* const light[] = {"beauty.r", "beauty.g", "beauty.b"};
    char const* const depth[] = {"Z"};
    REQUIRE(quell_exr_want(file.get(), "radiance", 0, light) == QUELL_OK);
    refused(quell_exr_read(file.get(), 0, 0, &frame), QUELL_INVALID_ARGUMENT, {"a.exr", "'depth.Z'", "beauty.r"});
    CHECK(frame.channel_count == 0);
    REQUIRE(quell_exr_want(file.get(), "depth", 0, depth) == QUELL_OK);
    REQUIRE(quell_exr_want(file.get(), "motion_next", 1, nullptr) == QUELL_OK);
    quell_camera const of_last_file{};
    frame.camera = &of_last_file;
    REQUIRE(quell_exr_read(file.get(), size.width, size.height, &frame) == QUELL_OK);
    CHECK(frame.channel_count == 2); // it lacks motion_next
    CHECK(frame.camera == nullptr);
    CHECK(value_of(image_in(frame, "radiance"), 2, 5, 7) == 3 * 705.f);
    CHECK(value_of(image_in(frame, "depth"), 0, 5, 7) == 4 * 705.f);
}

TEST_CASE("what is written is read again, whatever the layout, the format and the compression") {
    Folder const folder;
    io::write_exr(folder / "like.exr", image_with_attributes());
    auto const like = opened(folder / "like.exr");
    auto const path = (folder / "out.exr").string();
    std::vector<float> rgba(static_cast<std::size_t>(size.pixels()) * 4), z(static_cast<std::size_t>(size.pixels()));
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<float>(i % 1000) / 8;
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = static_cast<float>(i) / 16;
    // Rows from the bottom up.
    auto const* const last = rgba.data() + 4 * (size.height - 1) * size.width;
    quell_channel const channels[] = {
        {"radiance", {const_cast<float*>(last), QUELL_FLOAT32, 4, 0, 0, -static_cast<std::ptrdiff_t>(sizeof(float)) * 4 * size.width}},
        {"weight", QUELL_PIXELS(z.data(), 1)},
        {"extra", QUELL_PIXELS(rgba.data(), 4)}};
    quell_exr_output output = QUELL_EXR_OUTPUT;
    output.channels = channels, output.channel_count = 3, output.like = like.get();
    for (int compression = QUELL_EXR_ZIP; compression <= QUELL_EXR_PIZ; ++compression)
        for (int const format : {QUELL_FLOAT16, QUELL_FLOAT32}) {
            output.compression = compression, output.format = format;
            REQUIRE(quell_exr_write(path.c_str(), &output) == QUELL_OK);
            auto const image = io::read_exr(path);
            CHECK(image["R"].type == (format == QUELL_FLOAT16 ? io::SampleType::half : io::SampleType::float32));
            CHECK(image.planes.size() == 8);
            for (std::size_t i = 0; i < image.pixels(); ++i) {
                auto const x = i % 48, y = i / 48;
                REQUIRE(image["G"].values[i] == rgba[((31 - y) * 48 + x) * 4 + 1]);
                REQUIRE(image["weight"].values[i] == z[i]);
                REQUIRE(image["extra.A"].values[i] == rgba[i * 4 + 3]);
            }
            CHECK(io::camera_of(image)->jitter == glm::vec2(0.25f, -0.125f));
            CHECK(*image.attribute<std::string>("owner") == "nobody");
        }
    output.compression = QUELL_EXR_DWAA;
    CHECK(quell_exr_write(path.c_str(), &output) == QUELL_OK);
    CHECK(io::read_exr(path)["R"].values[5] == doctest::Approx(rgba[(31 * 48 + 5) * 4]).epsilon(0.05));

    std::uint16_t const halves[] = {0x3800, 0x3c00, 0x4000}; // 0.5, 1, 2
    quell_channel const pixel = {"radiance", {const_cast<std::uint16_t*>(halves), QUELL_FLOAT16, 3, 0, 0, 0}};
    output = QUELL_EXR_OUTPUT, output.channels = &pixel, output.channel_count = 1, output.width = output.height = 1;
    REQUIRE(quell_exr_write(path.c_str(), &output) == QUELL_OK);
    auto const image = io::read_exr(path);
    CHECK((image["R"].values[0] == 0.5f && image["G"].values[0] == 1.f && image["B"].values[0] == 2.f));
}

TEST_CASE("files that can't be read are refused with a sentence") {
    Folder const folder;
    quell_exr* file = nullptr;
    auto const open_refused = [&](std::string const& name, std::initializer_list<std::string> words) {
        refused(quell_exr_open((folder / name).c_str(), &file), QUELL_INVALID_ARGUMENT, words);
        CHECK(file == nullptr);
    };
    open_refused("none.exr", {"none.exr", "no such file"});
    open_refused("", {"folder"});
    write_bytes(folder / "text.exr", "this is a text");
    open_refused("text.exr", {"text.exr", "isn't an EXR"});
    write_bytes(folder / "empty.exr", "");
    open_refused("empty.exr", {"empty.exr", "empty"});
    io::write_exr(folder / "a.exr", noisy_image(size, 0));
    auto const bytes = bytes_of(folder / "a.exr");
    write_bytes(folder / "header.exr", bytes.substr(0, 100));
    open_refused("header.exr", {"header.exr", "truncated"});
    write_bytes(folder / "pixels.exr", bytes.substr(0, bytes.size() * 3 / 4));
    quell_frame frame = QUELL_FRAME;
    auto const denoiser = svgf();
    if (quell_exr_open((folder / "pixels.exr").c_str(), &file) == QUELL_OK) {
        File const cut(file);
        refused(quell_exr_read_for(file, denoiser.get(), &frame), QUELL_INVALID_ARGUMENT, {"pixels.exr", "truncated"});
    } else
        refused(QUELL_INVALID_ARGUMENT, QUELL_INVALID_ARGUMENT, {"pixels.exr", "truncated"});
    CHECK(frame.channels == nullptr);

    auto image = noisy_image(size, 0);
    std::erase_if(image.planes, [](auto const& each) { return each.name == "normal.Y"; });
    io::write_exr(folder / "lacks.exr", image);
    auto const lacks = opened(folder / "lacks.exr");
    refused(quell_exr_read_for(lacks.get(), denoiser.get(), &frame), QUELL_INVALID_ARGUMENT, {"lacks.exr", "'normal.Y'", "normal.X"});
    auto const good = opened(folder / "a.exr");
    refused(quell_exr_read_for(good.get(), svgf({48, 31}).get(), &frame), QUELL_INVALID_ARGUMENT, {"a.exr", "48x32", "48x31"});
    CHECK(quell_exr_read_for(good.get(), denoiser.get(), &frame) == QUELL_OK); // it works as before
}

TEST_CASE("wrong arguments are refused with a sentence") {
    Folder const folder;
    io::write_exr(folder / "a.exr", noisy_image(size, 0));
    auto const file = opened(folder / "a.exr");
    quell_frame frame = QUELL_FRAME;
    auto const invalid = [](quell_status status, std::initializer_list<std::string> words) {
        refused(status, QUELL_INVALID_ARGUMENT, words);
    };
    quell_exr* other = nullptr;
    invalid(quell_exr_open(nullptr, &other), {"path", "null"});
    invalid(quell_exr_open("a.exr", nullptr), {"file", "null"});
    invalid(quell_exr_want(file.get(), "beauty", 0, nullptr), {"'beauty'", "radiance", "depth"});
    char const* const two[] = {"R", nullptr};
    invalid(quell_exr_want(file.get(), "radiance", 0, two), {"'radiance'", "planes[1]", "3"});
    invalid(quell_exr_want(nullptr, "radiance", 0, nullptr), {"file"});
    invalid(quell_exr_read(file.get(), 0, 0, &frame), {"quell_exr_want"});
    invalid(quell_exr_choose_signal(file.get(), "glossy"), {"'glossy'", "radiance"});
    REQUIRE(quell_exr_choose_signal(file.get(), "radiance") == QUELL_OK);
    frame.struct_size = 3;
    invalid(quell_exr_read(file.get(), 0, 0, &frame), {"struct_size", "QUELL_FRAME"});
    quell_exr_info info = QUELL_EXR_INFO;
    info.struct_size = 3;
    invalid(quell_exr_get_info(file.get(), &info), {"struct_size", "QUELL_EXR_INFO", "quell_exr.h"});
    CHECK(quell_exr_channel_name(file.get(), -1) == nullptr);
    CHECK(quell_exr_channel_name(nullptr, 0) == nullptr);
    quell_exr_close(nullptr);

    float pixels[12] = {};
    quell_channel channels[] = {{"radiance", QUELL_PIXELS(pixels, 3)}, {"weight", QUELL_PIXELS(pixels, 1)}};
    auto const path = (folder / "out.exr").string();
    quell_exr_output output = QUELL_EXR_OUTPUT;
    output.channels = channels, output.channel_count = 2, output.width = output.height = 2;
    auto const write_refused = [&](std::initializer_list<std::string> words) { invalid(quell_exr_write(path.c_str(), &output), words); };
    output.width = 0, write_refused({"0x2"}), output.width = -4, write_refused({"-4x2"}), output.width = 2;
    output.format = 9, write_refused({"format", "9"}), output.format = QUELL_FLOAT16;
    output.compression = 7, write_refused({"compression", "7"}), output.compression = QUELL_EXR_ZIP;
    output.channel_count = 0, write_refused({"channels"}), output.channel_count = 2;
    channels[0].image.components = 2, write_refused({"'radiance'", "2 components", "3"}), channels[0].image.components = 3;
    channels[1].image.data = nullptr, write_refused({"'weight'", "null"}), channels[1].image.data = pixels;
    channels[1].name = nullptr, write_refused({"channels[1]", "name"});
    channels[1].name = "R", write_refused({"'R'", "twice"}), channels[1].name = "weight";
    output.struct_size += 8, write_refused({"struct_size"}), output.struct_size -= 8;
    CHECK(folder.files() == 1); // nothing was written
    refused(quell_exr_write((folder / "no folder" / "out.exr").c_str(), &output), QUELL_FAILED, {"out.exr", "written"});
    CHECK(quell_exr_write(path.c_str(), &output) == QUELL_OK);
}

TEST_CASE("the example writes what quell-denoise does") {
    Folder const folder;
    write_sequence(folder, 0, 3);
    auto const files = "'" + (folder / "frame.%04d.exr").string() + "' '" + (folder / "out.%04d.exr").string() + "' ";
    auto const ran = run_program(QUELL_DENOISE_EXR, "svgf " + files + "0 3");
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    CHECK(run_program(QUELL_DENOISE_EXR, "best " + files + "0 3").err.find("'best'") != std::string::npos);
    CHECK(run_program(QUELL_DENOISE_EXR, "svgf " + files + "0 4").err.find("frame.0004.exr") != std::string::npos);
    if (std::string(QUELL_DENOISE).empty()) return; // it was not built
    REQUIRE(denoise(input(folder) + "--preset svgf --out '" + (folder / "program.%04d.exr").string() + "'").code == 0);
    for (int i = 0; i <= 3; ++i) {
        auto const ours = io::read_exr(folder / numbered("out.", i)), its = io::read_exr(folder / numbered("program.", i));
        for (auto const* const name : {"R", "G", "B"}) CHECK((ours[name].values == its[name].values && ours[name].type == its[name].type));
    }
}

} // namespace quell::tests

#include "../frames.hpp"
#include "../views.hpp"
#include "files.hpp"

using namespace quell;
using namespace quell::tests;

TEST_CASE("a frame of all channels comes back from a file under quell's own names") {
    Folder const folder;
    Frame<AllChannels> frame({23, 11});
    fill_randomly(frame, 5);
    frame.camera.view[3] = {1.f, 2.f, 3.f, 1.f};
    frame.camera.jitter = {0.25f, -0.125f};
    io::write_exr(folder / "all.exr", io::image_of(frame));
    auto const image = io::read_exr(folder / "all.exr");
    for (auto const* const name : {"R",
                                   "G",
                                   "B",
                                   "albedo.G",
                                   "normal.Z",
                                   "depth.Z",
                                   "position.X",
                                   "instance.ID",
                                   "roughness.R",
                                   "motion.Y",
                                   "motion_next.X",
                                   "sample_count.V",
                                   "radiance_gradient.Y",
                                   "sweep_visibility.X",
                                   "sweep_bend.Y",
                                   "direct.B",
                                   "visibility.V",
                                   "light_previous.X",
                                   "glossy.R",
                                   "glossy_hit.Y",
                                   "indirect.G",
                                   "indirect_direction.Z",
                                   "sweep.X",
                                   "time.T",
                                   "receiver_previous.Y",
                                   "blocker.Z"})
        CHECK(image.find(name) != nullptr);
    CHECK(image["R"].type == io::SampleType::half);
    CHECK(image["depth.Z"].type == io::SampleType::float32);
    CHECK(image["instance.ID"].type == io::SampleType::uint32);

    Frame<AllChannels> back(image.size);
    io::load(back, image);
    CHECK(back.camera == frame.camera);
    for_each_channel(AllChannels{}, [&](auto channel) {
        INFO(channel.name);
        // Half keeps 11 bits.
        double const bound = channel.full_precision ? 0. : 1. / 2048.;
        CHECK(difference(copy_of(frame[channel].view()), copy_of(back[channel].view())) <= bound);
    });
}

TEST_CASE("storage of any kind can be filled") {
    io::ExrImage image{.size = {5, 4}};
    for (auto const* const name : {"R", "G", "B"})
        image.planes.push_back(plane(name, image.size, [](int x, int y) { return static_cast<float>(x + 10 * y); }));
    Frame<Channels<Radiance>, Interleaved<Float16>> frame(image.size);
    io::load(frame, image);
    CHECK(frame[radiance].get(3, 2) == glm::vec3(23.f));
}

TEST_CASE("a frame keeps its camera where the file has none") {
    io::ExrImage image{.size = {1, 1}};
    image.planes = {plane("depth.Z", {1, 1}, [](int, int) { return 1.f; })};
    Frame<Channels<Depth>> frame(image.size);
    frame.camera.view[3][0] = 9.f;
    io::load(frame, image);
    CHECK(frame.camera.view[3][0] == 9.f);
    CHECK_FALSE(io::camera_of(image).has_value());
    io::put_camera(image, frame.camera, "_previous");
    CHECK(io::camera_of(image, "_previous") == frame.camera);
    CHECK_FALSE(io::camera_of(image).has_value());
}

TEST_CASE("how long the shutter is open comes back from a file, unless the names say it") {
    Frame<Channels<Sweep>> frame({2, 2});
    fill_randomly(frame, 5);
    frame.shutter = 0.25f;
    auto const image = io::image_of(frame);
    Frame<Channels<Sweep>> back(image.size);
    io::load(back, image);
    CHECK(back.shutter == 0.25f);
    io::load(back, image, io::ChannelNames{.shutter = 0.75f});
    CHECK(back.shutter == 0.75f);
    // What doesn't sweep has none.
    Frame<Channels<Depth>> const still({2, 2});
    CHECK_FALSE(io::shutter_of(io::image_of(still)).has_value());
    io::ExrImage by_hand{.name = "by_hand.exr", .size = {2, 2}};
    by_hand.attributes["quell:shutter"] = 1;
    CHECK(io::shutter_of(by_hand) == 1.f);
    by_hand.attributes["quell:shutter"] = std::string("1");
    CHECK_THROWS_WITH(static_cast<void>(io::shutter_of(by_hand)),
                      doctest::Contains("by_hand.exr: its attribute quell:shutter is no number"));
}

TEST_CASE("other names, sums, scales and constants") {
    io::ExrImage image{.size = {3, 2}};
    for (auto const* const name : {"a", "b", "c"})
        image.planes.push_back(plane(name, image.size, [&](int x, int) { return static_cast<float>(x + name[0] - 'a'); }));
    io::ChannelNames names;
    names.sources["radiance"] = {{{"a"}, 2.f}, {{"b", "c"}, -1.f}, {{}, 0.5f}};
    Frame<Channels<Radiance>> frame(image.size);
    io::load(frame, image, names);
    CHECK(frame[radiance].get(1, 1) == glm::vec3(2.f, -(2.f + 3.f), 0.5f));
    CHECK(io::planes_of(Channels<Radiance>{}, names) == std::vector<std::string>{"a", "b", "c"});
    names.sources["radiance"].pop_back();
    check_error([&] { io::load(frame, image, names); }, {"channel map: 'radiance'", "2 components", "name 3"});
}

TEST_CASE("motion of every convention becomes quell's own") {
    using C = MotionConvention;
    io::ExrImage image{.size = {200, 100}};
    // In quell's terms: 4 pixels to the left, 3 down.
    auto const loaded = [&](glm::vec2 stored, C convention) {
        image.planes = {plane("motion.X", image.size, [&](int, int) { return stored.x; }),
                        plane("motion.Y", image.size, [&](int, int) { return stored.y; })};
        auto const next = image.planes;
        for (auto const& each : next) image.planes.push_back(each), image.planes.back().name.insert(6, "_next");
        Frame<Channels<Motion, MotionNext>> frame(image.size);
        io::load(frame, image, io::ChannelNames{.motion = convention});
        // To the next frame it always points from this one, without jitter.
        bool const is_turned = convention.points == C::Points::from_previous, has_jitter = convention.jitter == C::Jitter::left_in;
        if (!has_jitter) CHECK(frame[motion_next].get(7, 8) == (is_turned ? -1.f : 1.f) * frame[motion].get(7, 8));
        return frame[motion].get(7, 8);
    };
    auto const near = [](glm::vec2 a, glm::vec2 b) { return std::abs(a.x - b.x) < 1e-5f && std::abs(a.y - b.y) < 1e-5f; };
    CHECK(near(loaded({-4.f, 3.f}, {}), {-4.f, 3.f}));
    CHECK(near(loaded({-4.f, -3.f}, {.y = C::Y::up}), {-4.f, 3.f}));
    CHECK(near(loaded({4.f, -3.f}, {.points = C::Points::from_previous}), {-4.f, 3.f}));
    CHECK(near(loaded({-0.02f, 0.03f}, {.unit = C::Unit::uv}), {-4.f, 3.f}));
    CHECK(near(loaded({0.04f, 0.06f}, {C::Points::from_previous, C::Unit::ndc, C::Y::up}), {-4.f, 3.f}));
    io::put_camera(image, {glm::mat4(1.f), glm::mat4(1.f), {0.25f, 0.f}});
    io::put_camera(image, {glm::mat4(1.f), glm::mat4(1.f), {-0.25f, 0.5f}}, "_previous");
    CHECK(near(loaded({-3.5f, 2.5f}, {.jitter = C::Jitter::left_in}), {-4.f, 3.f}));
}

TEST_CASE("depth along rays becomes depth along the view axis") {
    tests::View const view({1, 2, 9}, {0, 1, -3}, {40, 24});
    glm::vec2 const jitter(0.25f, -0.5f);
    // Things at 3 to 5 along the view axis.
    auto const wanted = [](int x, int y) { return 3.f + 0.1f * static_cast<float>(x % 7 + 2 * (y % 7)); };
    io::ExrImage image{.name = "f.exr", .size = view.size};
    image.planes = {plane("depth.Z", view.size, [&](int x, int y) {
        auto const direction = view.direction(tests::centre(x, y) + glm::dvec2(jitter));
        return static_cast<float>(wanted(x, y) / view.depth(view.eye + direction));
    })};
    Frame<Channels<Depth>> frame(view.size);
    auto const check = [&](io::DepthConvention convention) {
        io::load(frame, image, io::ChannelNames{.depth = convention});
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x) CHECK(frame[depth].get(x, y) == doctest::Approx(wanted(x, y)).epsilon(1e-5));
    };
    io::DepthConvention const along_rays{.along = io::DepthConvention::Along::ray};
    check_error([&] { check(along_rays); }, {"f.exr", "no camera", "vertical_field_of_view"});
    auto camera = view.camera();
    camera.jitter = jitter;
    io::put_camera(image, camera);
    check(along_rays);
    auto without = image;
    io::put_camera(without, {camera.view, glm::mat4(0.f), jitter});
    check_error([&] { io::load(frame, without, io::ChannelNames{.depth = along_rays}); }, {"f.exr", "no ray can be made"});
    // A lens that is shifted to the side sees the right half: its picture is the right half of this one.
    auto half = image;
    half.size.width /= 2;
    half.planes = {plane("depth.Z", half.size, [&](int x, int y) {
        return image.planes[0].values[static_cast<std::size_t>(y * view.size.width + x + half.size.width)];
    })};
    glm::mat4 to_half(1.f);
    to_half[0][0] = 2.f, to_half[3][0] = -1.f;
    camera.projection = to_half * camera.projection;
    io::put_camera(half, camera);
    Frame<Channels<Depth>> right(half.size);
    io::load(right, half, io::ChannelNames{.depth = along_rays});
    CHECK(right[depth].get(3, 5) == doctest::Approx(wanted(3 + half.size.width, 5)).epsilon(1e-5));
}

TEST_CASE("depth along rays needs no camera where the field of view is said") {
    io::ExrImage image{.size = {4, 2}};
    // 90 degrees: the middle of the upper row's last pixel lies 1.5 to the right and 0.5 up of a point at 1.
    image.planes = {plane("depth.Z", image.size, [&](int, int) { return 7.f; })};
    Frame<Channels<Depth>> frame(image.size);
    io::ChannelNames names{.depth = {io::DepthConvention::Along::ray, 90.f}, .miss_from = 8.f};
    io::load(frame, image, names);
    CHECK(frame[depth].get(3, 0) == doctest::Approx(7. / std::sqrt(1 + 1.5 * 1.5 + 0.5 * 0.5)));
    names.miss_from = 7.f;
    io::load(frame, image, names);
    CHECK(frame[depth].get(3, 0) == std::numeric_limits<float>::infinity());
    io::put_camera(image, {glm::mat4(1.f), glm::ortho(-1.f, 1.f, -1.f, 1.f, 0.1f, 9.f), {}});
    names.miss_from = 8.f;
    io::load(frame, image, names);
    CHECK(frame[depth].get(3, 0) == 7.f);
}

TEST_CASE("jitter that is left in motion is refused where a file doesn't say how much it is") {
    io::ExrImage image{.name = "f.exr", .size = {4, 4}};
    for (auto const* const name : {"motion.X", "motion.Y"}) image.planes.push_back(plane(name, image.size, [](int, int) { return 1.f; }));
    Frame<Channels<Motion>> frame(image.size);
    auto const load = [&] { io::load(frame, image, io::ChannelNames{.motion = {.jitter = MotionConvention::Jitter::left_in}}); };
    check_error(load, {"f.exr", "no attribute quell:jitter", "left_out"});
    image.attributes["quell:jitter"] = glm::vec2(0.25f, 0.f);
    check_error(load, {"f.exr", "no attribute quell:jitter_previous", "left_out"});
    image.attributes["quell:jitter_previous"] = glm::vec2(0.5f, 0.f);
    load();
    CHECK(frame[motion].get(2, 1) == glm::vec2(1.25f, 1.f));
}

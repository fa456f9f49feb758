#include "programs.hpp"

#include <denoise/map_file.hpp>
#include <denoise/renderer_maps.hpp>

#include <nlohmann/json.hpp>

// Files as other renderers write them, of a scene whose light, colour, normals and depth are known.
using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{40, 24};
constexpr float field_of_view = 50.f; // vertical degrees
constexpr float no_surface = std::numeric_limits<float>::infinity();

bool is_sky(int x) { return x >= 32; }
float true_depth(int x, int y) { return is_sky(x) ? no_surface : 3.f + 0.05f * static_cast<float>(x) + 0.02f * static_cast<float>(y); }
float true_albedo(int x, int y, int c) {
    return is_sky(x) ? 0.f : (x / 4 + y / 4) % 2 == 0 ? 0.75f : 0.25f + 0.125f * static_cast<float>(c);
}
float true_light(int x, int y, int c) { return is_sky(x) ? 0.5f : 2.f * true_albedo(x, y, c); }
glm::vec3 true_normal(int x) { return is_sky(x) ? glm::vec3(0.f) : glm::normalize(glm::vec3(0.2f, x < 16 ? 0.5f : -0.5f, 1.f)); }

/// How long the ray through a pixel is to depth 1.
float length_to_depth_1(int x, int y) {
    float const half = std::tan(glm::radians(field_of_view) / 2.f), width = static_cast<float>(size.width),
                height = static_cast<float>(size.height);
    float const right = (2.f * (static_cast<float>(x) + 0.5f) - width) / height * half;
    float const down = (2.f * (static_cast<float>(y) + 0.5f) - height) / height * half;
    return std::sqrt(1.f + right * right + down * down);
}
float true_ray(int x, int y) { return true_depth(x, y) * length_to_depth_1(x, y); }

using Names = std::vector<std::string>;

/// A file of the scene, layer by layer.
struct File {
    io::ExrImage image{.size = size};

    void put(std::string const& name, std::function<float(int, int)> const& f) { image.planes.push_back(plane(name, size, f)); }
    void put(Names const& names, std::function<float(int, int, int)> const& f) {
        for (int c = 0; c < static_cast<int>(names.size()); ++c)
            put(names[static_cast<std::size_t>(c)], [&](int x, int y) { return f(x, y, c); });
    }
    void light(Names const& names) { put(names, true_light); }
    void colour(Names const& names) { put(names, true_albedo); }
    void normal(Names const& names) {
        put(names, [](int x, int, int c) { return true_normal(x)[c]; });
    }
    /// Depth, and what stands for none.
    void distance(std::string const& name, std::function<float(int, int)> const& f, float miss) {
        put(name, [&](int x, int y) { return is_sky(x) ? miss : f(x, y); });
    }
};

Names rgb(std::string const& layer) { return {layer + "R", layer + "G", layer + "B"}; }
Names xyz(std::string const& layer) { return {layer + "X", layer + "Y", layer + "Z"}; }
Names small_rgb(std::string const& layer) { return {layer + "r", layer + "g", layer + "b"}; }

/// What a renderer writes, by its vendor's documentation (docs/renderers.md).
struct Renderer {
    std::string map, name;
    std::function<void(File&)> write;
    bool has_albedo = true, has_normal = true;
    std::string picture = "R"; ///< the channel that the denoised red goes to
    std::string alone = "R";   ///< its name in a file that holds the picture alone
};
std::vector<Renderer> const& renderers() {
    auto const zero = [](int, int, int) { return 0.f; };
    static std::vector<Renderer> const all{
        {"arnold", "Arnold",
         [=](File& f) {
             f.light(rgb("")), f.colour(rgb("albedo.")), f.normal(xyz("N.")), f.distance("Z", true_depth, 1e30f);
             f.put({"motionvector.X", "motionvector.Y"}, zero);
         }},
        {"karma", "Karma", [](File& f) { f.light(rgb("C.")), f.normal(small_rgb("hitN.")), f.distance("hitdist", true_ray, 0.f); }, false,
         true, "C.R", "C.R"},
        {"luxcore", "LuxCore",
         [=](File& f) {
             f.light(rgb("View Layer.RGB.")), f.colour(rgb("View Layer.ALBEDO.")), f.normal(xyz("View Layer.AVG_SHADING_NORMAL."));
             f.distance("View Layer.Depth.Z", true_ray, no_surface), f.put(rgb("View Layer.Combined."), zero);
         },
         true, true, "View Layer.RGB.R", "View Layer.Combined.R"},
        {"mitsuba", "Mitsuba",
         [](File& f) {
             f.light(rgb("")), f.light(rgb("my_image.")), f.colour(rgb("albedo.")), f.normal(xyz("nn.")),
                 f.distance("dd.y.T", true_ray, 0.f);
         }},
        {"pbrt", "pbrt",
         [=](File& f) {
             f.light(rgb("")), f.colour(rgb("Albedo.")), f.normal(xyz("Ns.")), f.normal(xyz("N.")),
                 f.put({"P.X", "P.Y", "dzdx", "u", "v"}, zero);
             f.distance("P.Z", true_depth, 0.f), f.put(rgb("Variance."), zero), f.put(rgb("RelativeVariance."), zero);
         }},
        {"renderman", "RenderMan",
         [=](File& f) {
             f.light(small_rgb("Ci.")), f.put(small_rgb("mse."), zero), f.colour(small_rgb("albedo.")), f.normal(small_rgb("__Nworld."));
             f.distance("z", true_depth, no_surface), f.put({"forward.x", "forward.y", "backward.x", "backward.y"}, zero);
         },
         true, true, "Ci.r", "Ci.r"},
        {"vray", "V-Ray",
         [=](File& f) {
             f.light(rgb("")), f.colour(rgb("VRayDiffuseFilter.")), f.distance("Z", true_depth, 1e30f), f.put(rgb("VRayVelocity."), zero);
         },
         true, false}};
    return all;
}

io::ExrFile written(Folder const& folder, Renderer const& renderer, std::string const& name = "f.exr") {
    File file;
    renderer.write(file);
    io::write_exr(folder / name, file.image);
    return io::ExrFile(folder / name);
}

using Guided = Frame<Channels<Radiance, Albedo, Normal, Depth, Motion>>;

/// What quell sees of a file.
Guided seen(io::ExrFile const& file, io::SequenceNames const& names) {
    auto channels = names.of_signals.at(0).channels;
    channels.depth.vertical_field_of_view = field_of_view;
    Guided frame(size);
    auto const planes = io::planes_of(Guided::channels{}, channels);
    io::load(frame, file.read(planes), channels);
    return frame;
}

bool close(float a, float b) { return a == b || std::abs(a - b) <= 1e-5f * std::abs(b); }

/// How many numbers of a frame differ from what the scene is.
int wrong_numbers(Guided const& frame, Renderer const& renderer) {
    int wrong = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            wrong += !close(frame[depth].get(x, y), true_depth(x, y));
            for (int c = 0; c < 2; ++c) wrong += frame[motion].get(x, y)[c] != 0.f; // none of them says it
            for (int c = 0; c < 3; ++c) {
                wrong += !close(frame[radiance].get(x, y)[c], true_light(x, y, c));
                wrong += !close(frame[albedo].get(x, y)[c], renderer.has_albedo ? true_albedo(x, y, c) : 1.f);
                wrong += !close(frame[normal].get(x, y)[c], renderer.has_normal ? true_normal(x)[c] : c == 2 ? 1.f : 0.f);
            }
        }
    return wrong;
}

} // namespace

TEST_CASE("what other renderers write is read as what it is, by the map's name and by the channels'") {
    Names maps;
    for (auto const& [name, text] : examples::renderer_maps()) maps.emplace_back(name);
    Names tried;
    for (auto const& renderer : renderers()) {
        CAPTURE(renderer.map);
        tried.push_back(renderer.map);
        Folder const folder;
        auto const file = written(folder, renderer);
        for (auto const& names : {examples::read_map(renderer.map, &file), examples::recognised(file)}) {
            CHECK(names.renderer == renderer.name);
            CHECK(wrong_numbers(seen(file, names), renderer) == 0);
            REQUIRE(names.remarks.size() == 1);
            CHECK(contains(names.remarks[0], "without motion vectors"));
            CHECK(contains(names.remarks[0], "without albedo") == !renderer.has_albedo);
            CHECK(contains(names.remarks[0], "without normal") == !renderer.has_normal);
            CHECK(!contains(names.remarks[0], "without depth"));
        }
    }
    CHECK(tried == maps);
}

TEST_CASE("a file with the picture alone can be read by each map, and a remark says what is lacking") {
    for (auto const& renderer : renderers()) {
        CAPTURE(renderer.map);
        if (renderer.map == "pbrt") continue; // its film writes all or nothing
        Folder const folder;
        File picture;
        auto const layer = renderer.alone.substr(0, renderer.alone.size() - 1);
        picture.light(renderer.alone.ends_with("r") ? small_rgb(layer) : rgb(layer));
        io::write_exr(folder / "f.exr", picture.image);
        io::ExrFile const file(folder / "f.exr");
        auto const names = examples::read_map(renderer.map, &file);
        auto const frame = seen(file, names);
        CHECK(frame[radiance].get(5, 5).x == true_light(5, 5, 0));
        CHECK(frame[depth].get(5, 5) > 0.f);
        CHECK(frame[normal].get(5, 5) == glm::vec3(0, 0, 1));
        for (auto const* const guide : {"without motion", "without albedo", "without normal", "without depth"})
            CHECK(contains(names.remarks.at(0), guide));
    }
}

TEST_CASE("files of quell's own and of Blender's are not taken for another renderer's") {
    Folder const folder;
    io::write_exr(folder / "own.exr", noisy_image({16, 12}, 1));
    CHECK(examples::recognised(io::ExrFile(folder / "own.exr")).renderer == "quell");
    File cycles;
    cycles.light(rgb("ViewLayer.Combined.")), cycles.distance("ViewLayer.Depth.Z", true_depth, 1e10f);
    io::write_exr(folder / "cycles.exr", cycles.image);
    CHECK(examples::recognised(io::ExrFile(folder / "cycles.exr")).renderer == "Blender Cycles");
}

TEST_CASE("a file that is called what a map is comes first") {
    Folder const folder;
    auto const here = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    CHECK(examples::read_map("arnold").renderer == "Arnold");
    write_bytes("arnold", R"({"renderer": "mine"})");
    CHECK(examples::read_map("arnold").renderer == "mine");
    std::filesystem::current_path(here);
}

TEST_CASE("each map says where its statements stand, and the page has its row") {
    auto const page = bytes_of(QUELL_ROOT "/docs/renderers.md");
    for (auto const& [called, text] : examples::renderer_maps()) {
        std::string const name(called); // Clang's lambdas do not capture the binding
        CAPTURE(name);
        auto const map = nlohmann::json::parse(text);
        CHECK(map["source"].size() >= 2);
        CHECK(contains(page, "| `" + name + "` |"));
        CHECK(contains(page, map["renderer"].get<std::string>()));
        CHECK(contains(denoise("--help").out, name));
    }
}

TEST_CASE("quell-denoise denoises other renderers' files, and says what they lack in a line") {
    for (auto const& renderer : renderers()) {
        CAPTURE(renderer.map);
        Folder const folder;
        for (int i = 1; i <= 3; ++i) static_cast<void>(written(folder, renderer, numbered("frame.", i)));
        for (std::string const how : {"", "--map "}) {
            auto const ran =
                denoise(input(folder) + output(folder) + "--quiet --json --field-of-view 50 " + (how.empty() ? how : how + renderer.map));
            INFO(ran.err);
            REQUIRE(ran.code == 0);
            auto const said = nlohmann::json::parse(ran.out);
            CHECK(said["renderer"] == renderer.name);
            CHECK(contains(said["remarks"].dump(), renderer.name + ": without motion vectors"));
            CHECK(said["preset"] == "final-frame");
            auto const out = io::read_exr(folder / "out.0002.exr");
            auto const& red = out[renderer.picture].values;
            for (int x = 2; x < 30; ++x) // there is no noise: what a filter does to the edges is all that may change
                CHECK(red[static_cast<std::size_t>(10 * size.width + x)] ==
                      doctest::Approx(true_light(x, 10, 0)).epsilon(renderer.has_albedo ? 0.1 : 0.2));
        }
    }
}

TEST_CASE("depths along rays want a camera or --field-of-view") {
    Folder const folder;
    static_cast<void>(written(folder, renderers()[3], "frame.0001.exr"));
    auto const at = input(folder) + output(folder) + "--quiet ";
    check_refused(denoise(at), {"frame.0001.exr", "its depth is said to be the length of rays", "--field-of-view"});
    check_refused(denoise(at + "--field-of-view 180"), {"--field-of-view", "between 0 and 180"});
    CHECK(denoise(at + "--field-of-view 50").code == 0);
}

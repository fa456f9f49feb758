// Ray-traced shadows and indirect light in a host with images and conventions of its own: RGBA, the bottom row first, motion vectors in
// [0, 1] with y up. quell reads them where they are. The picture is direct * visibility + albedo * indirect.
#include <quell/quell.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string_view>
#include <vector>

using quell::MotionConvention;
constexpr auto vectors = quell::Supplied<MotionConvention{.unit = MotionConvention::Unit::uv, .y = MotionConvention::Y::up}>{};
constexpr auto denoise = quell::Composite{quell::presets::shadow(quell::visibility, vectors), // one shadow ray per pixel
                                          quell::presets::surface_clamp(quell::indirect, vectors)};

/// Stands in for the host: a floor seen from above, and between it and a lamp a plate that moves to the right, as the camera does.
struct Host {
    static constexpr int width = 96, height = 64;
    std::map<std::string_view, std::vector<glm::vec4>> images; // by the names of quell's channels
    glm::mat4 view{1.f}, projection = glm::perspective(0.9f, 1.5f, 0.1f, 100.f);
    std::mt19937 random{1};

    float uniform() { return std::uniform_real_distribution<float>(0.f, 1.f)(random); }
    void render(int n) {
        glm::vec3 const step(0.05f, 0, 0), eye(0.05f * static_cast<float>(n), 0, 4);
        view = glm::translate(glm::mat4(1.f), -eye);
        for (int i = 0; i < width * height; ++i) {
            glm::vec2 const at((static_cast<float>(i % width) + 0.5f) / width, (static_cast<float>(i / width) + 0.5f) / height);
            glm::vec3 const floor(eye.x + (at.x * 2 - 1) * 4 / projection[0][0], (at.y * 2 - 1) * 4 / projection[1][1], 0);
            glm::vec3 const light(uniform() * 0.3f, uniform() * 0.3f, 3);
            auto const plate = floor + (light - floor) * (1 / light.z); // where the shadow ray passes its height, 1
            bool const blocked = std::abs(plate.x - eye.x) < 0.5f && std::abs(plate.y) < 0.5f;
            auto const nowhere = glm::vec3(std::nanf(""));
            auto const put = [&](std::string_view image, glm::vec3 v) { images[image][static_cast<std::size_t>(i)] = glm::vec4(v, 1); };
            put("visibility", glm::vec3(blocked ? 0.f : 1.f)), put("direct", glm::vec3(1));
            put("indirect", glm::vec3(0.4f * uniform())), put("albedo", glm::vec3(0.5f)); // 0.2 in the mean, times 0.5
            put("normal", {0, 0, 1}), put("depth", glm::vec3(4)), put("motion", {step.x * projection[0][0] / 8, 0, 0});
            put("position", floor), put("receiver_previous", floor), put("light", light), put("light_previous", light);
            put("blocker", blocked ? plate : nowhere), put("blocker_previous", blocked ? plate - step : nowhere);
        }
    }
};

int main() {
    Host host;
    quell::Extent const size{Host::width, Host::height};
    quell::Frame frame{size, denoise, quell::Borrowed<>{}};
    quell::History history{size, denoise};
    for_each_channel(decltype(frame)::channels{}, [&](auto channel) {
        auto& image = host.images[channel.name];
        image.resize(static_cast<std::size_t>(size.pixels()));
        frame[channel] = {&image[0].x + (size.height - 1) * 4 * size.width, size, 4, -4 * size.width};
    });
    for (int n = 0; n < 16; ++n) {
        host.render(n);
        frame.camera = {.view = host.view, .projection = host.projection};
        auto const picture = run(denoise, frame, history);
        if (n == 15) std::printf("in the light %.1f, in the shadow %.1f\n", picture.get(0, 8, 8), picture.get(0, 48, 32));
    }
}

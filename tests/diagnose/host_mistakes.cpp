#include "host_mistakes.hpp"

namespace quell::tests {

namespace {

using M = Mistake;
using Made = std::function<void(GoodFrame&, Take const&, std::size_t)>;

/// A mistake in one channel, pixel by pixel.
template <ChannelTag C, class F> Made in(C channel, F change) {
    return [=](GoodFrame& frame, Take const&, std::size_t) { each(frame, channel, change); };
}
template <class F> Made in_motion(F change) { return in(motion, change); }
/// A mistake in the camera alone.
template <class F> Made in_camera(F change) {
    return [=](GoodFrame& frame, Take const&, std::size_t) { change(frame.camera); };
}
/// The view, after a change of its axes.
Made in_axes(glm::vec3 signs) {
    return in_camera([=](Camera& camera) { camera.view = glm::scale(glm::mat4(1.f), signs) * camera.view; });
}
Made in_projection(float x, float y) {
    return in_camera([=](Camera& camera) { camera.projection = glm::scale(glm::mat4(1.f), {x, y, 1}) * camera.projection; });
}

float to_srgb(float a) { return a <= 0.0031308f ? 12.92f * a : 1.055f * std::pow(a, 1.f / 2.4f) - 0.055f; }
glm::vec3 to_srgb(glm::vec3 a) { return {to_srgb(a.x), to_srgb(a.y), to_srgb(a.z)}; }

void make_ray_length(GoodFrame& frame, Take const& take, std::size_t i) {
    PixelRays const rays(frame.camera, frame.size);
    fill(frame[depth], [&](int x, int y) { return frame[depth].get(x, y) * glm::length(rays.direction(take.place(i, x, y))); });
}
/// What the camera's movement alone makes of motion.
void forget_objects(GoodFrame& frame, Take const& take, std::size_t i) {
    PixelRays const rays(frame.camera, frame.size);
    fill(frame[motion], [&](int x, int y) {
        auto const z = frame[depth].get(x, y);
        auto const place = take.place(i, x, y);
        return is_finite(z) ? projected(take.good[i - 1].camera, rays.position(place, z), frame.size) - place : frame[motion].get(x, y);
    });
}
void turn_all_rows(GoodFrame& frame, Take const&, std::size_t) {
    for_each_channel(GoodFrame::channels{}, [&](auto c) { turn_rows(frame, c); });
    each(frame, motion, [](glm::vec2 m) { return glm::vec2(m.x, -m.y); });
}
template <class... Cs> Made from_the_frame_before(Cs... channels) {
    return [=](GoodFrame& frame, Take const& take, std::size_t i) { (copy_channel(take.good[i - 1], frame, channels), ...); };
}

std::vector<HostMistake> mistakes_of_motion() {
    return {
        {"motion points to the next frame", {M::motion_sign}, in_motion([](glm::vec2 m) { return -m; })},
        {"motion with y up", {M::motion_y}, in_motion([](glm::vec2 m) { return glm::vec2(m.x, -m.y); })},
        {"motion in parts of the image",
         {M::motion_unit},
         [](GoodFrame& frame, Take const&, std::size_t) {
             each(frame, motion, [&](glm::vec2 m) { return m / glm::vec2(frame.size.width, frame.size.height); });
         }},
        {"motion is zero", {M::motion_zero, M::motion_forgotten}, in_motion([](glm::vec2) { return glm::vec2(0.f); })},
        {"motion half a pixel beside", {M::motion_offset}, in_motion([](glm::vec2 m) { return m + 0.5f; })},
        {"motion one pixel beside", {M::motion_offset}, in_motion([](glm::vec2 m) { return m + glm::vec2(1.f, 0.f); })},
        {"motion half as long", {M::motion_scale}, in_motion([](glm::vec2 m) { return 0.5f * m; })},
        {"motion twice as long", {M::motion_scale}, in_motion([](glm::vec2 m) { return 2.f * m; })},
        {"motion of objects forgotten", {M::motion_forgotten}, forget_objects},
        {"motion with the jitter in it",
         {M::motion_jitter},
         [](GoodFrame& frame, Take const& take, std::size_t i) {
             auto const left_in = take.good[i - 1].camera.jitter - frame.camera.jitter;
             each(frame, motion, [&](glm::vec2 m) { return m + left_in; });
         }},
        {"motion from samples to where their points were, with the centre as the start",
         {M::motion_jitter},
         [](GoodFrame& frame, Take const& take, std::size_t i) {
             fill(frame[motion], [&](int x, int y) { return frame[motion].get(x, y) + take.jitter(i, x, y); });
         }},
    };
}

std::vector<HostMistake> mistakes_of_cameras() {
    return {
        {"two cameras, one after the other",
         {M::cut},
         [](GoodFrame& frame, Take const& take, std::size_t i) {
             if (i >= 4 && i < take.elsewhere.size()) copy_frame(take.elsewhere[i], frame);
         }},
        {"view transposed", {M::view_transposed}, in_camera([](Camera& c) { c.view = glm::transpose(c.view); })},
        {"projection transposed", {M::projection_transposed}, in_camera([](Camera& c) { c.projection = glm::transpose(c.projection); })},
        {"the camera's pose as the view", {M::view_inverted}, in_camera([](Camera& c) { c.view = glm::inverse(c.view); })},
        {"only the view's rotation transposed", {M::view_rotation_transposed}, in_camera([](Camera& c) {
             auto const at = c.view[3];
             c.view = glm::mat4(glm::transpose(glm::mat3(c.view)));
             c.view[3] = at;
         })},
        {"view looks down +z", {M::view_looks_backwards}, in_axes({1, 1, -1})},
        {"view mirrored", {M::view_mirrored}, in_axes({-1, 1, 1})},
        {"view with y down and z forward", {M::view_looks_backwards}, in_axes({1, -1, -1})},
        {"projection with y down", {M::camera_upside_down}, in_projection(1, -1)},
        {"field of view too wide", {M::field_of_view}, in_projection(0.7f, 0.7f)},
        {"field of view too narrow", {M::field_of_view}, in_projection(1.3f, 1.3f)},
        {"aspect ratio forgotten",
         {M::field_of_view},
         [](GoodFrame& frame, Take const&, std::size_t) { frame.camera.projection[0][0] = frame.camera.projection[1][1]; }},
        {"projection[1][1] too small", {M::field_of_view}, in_projection(1, 0.8f)},
        {"projection[1][1] too large", {M::field_of_view}, in_projection(1, 1.25f)},
        {"the camera of the first frame",
         {M::camera_never_moves},
         [](GoodFrame& frame, Take const& take, std::size_t) { frame.camera = take.good[0].camera; }},
        {"jitter in the projection",
         {M::projection_jitter},
         [](GoodFrame& frame, Take const&, std::size_t) {
             frame.camera.projection[2][0] += 2.f * frame.camera.jitter.x / static_cast<float>(frame.size.width);
             frame.camera.projection[2][1] -= 2.f * frame.camera.jitter.y / static_cast<float>(frame.size.height);
             frame.camera.jitter = {};
         }},
        {"all rows bottom-up", {M::camera_upside_down}, turn_all_rows},
    };
}

std::vector<HostMistake> mistakes_of_guides() {
    constexpr float close = 0.1f, far = 100.f;
    return {
        {"depth along -z", {M::depth_not_positive}, in(depth, [](float z) { return is_finite(z) ? -z : z; })},
        {"depth of a z-buffer",
         {M::depth_not_linear},
         in(depth, [=](float z) { return is_finite(z) ? far * (1.f - close / z) / (far - close) : 1.f; })},
        {"depth of a reversed z-buffer", {M::depth_not_linear}, in(depth, [=](float z) { return is_finite(z) ? close / z : 0.f; })},
        {"depth is the ray's length", {M::depth_is_ray_length}, make_ray_length},
        {"depth in centimetres, the camera in metres", {M::depth_unit}, in(depth, [](float z) { return 100.f * z; })},
        {"depth of the sky is the far plane's", {M::depth_of_misses}, in(depth, [=](float z) { return is_finite(z) ? z : far; })},
        {"normals packed into [0, 1]", {M::normal_packed}, in(normal, [](glm::vec3 n) { return 0.5f * n + 0.5f; })},
        {"normals in view space",
         {M::normal_in_view_space},
         [](GoodFrame& frame, Take const&, std::size_t) {
             each(frame, normal, [&](glm::vec3 n) { return glm::mat3(frame.camera.view) * n; });
         }},
        {"albedo times 255", {M::albedo_above_one}, in(albedo, [](glm::vec3 a) { return 255.f * a; })},
        {"albedo black", {M::albedo_black}, in(albedo, [](glm::vec3) { return glm::vec3(0.f); })},
        {"albedo in sRGB", {M::albedo_encoded}, in(albedo, [](glm::vec3 a) { return to_srgb(a); })},
        {"albedo squared", {M::albedo_squared}, in(albedo, [](glm::vec3 a) { return a * a; })},
        {"camera and motion one frame late",
         {M::motion_behind},
         [](GoodFrame& frame, Take const& take, std::size_t i) {
             copy_channel(take.good[i - 1], frame, motion), frame.camera = take.good[i - 1].camera;
         }},
        {"guides one frame behind", {M::guides_behind}, from_the_frame_before(depth, normal, albedo, motion)},
    };
}

std::vector<HostMistake> mistakes_of_samples() {
    return {
        {"signal divided by albedo", {M::signal_demodulated}, [](GoodFrame& frame, Take const&, std::size_t) { divide_by_albedo(frame); }},
        {"signal not divided by albedo, output multiplied by it",
         {M::signal_has_albedo},
         [](GoodFrame& frame, Take const& take, std::size_t i) { copy_channel(take.good[i], frame, radiance); },
         true},
        {"signal in sRGB", {M::signal_encoded}, in(radiance, [](glm::vec3 r) { return glm::min(to_srgb(r), glm::vec3(1.f)); })},
        {"signal bottom-up, guides top-down",
         {M::signal_upside_down},
         [](GoodFrame& frame, Take const&, std::size_t) { turn_rows(frame, radiance); }},
        {"signal one frame behind", {M::signal_behind}, from_the_frame_before(radiance)},
        {"the same random numbers in every frame",
         {M::seed_repeats, M::identical_frames},
         [](GoodFrame& frame, Take const& take, std::size_t i) {
             for_each_channel(GoodFrame::channels{}, [&](auto c) { copy_channel(take.one_seed[i], frame, c); });
         }},
        {"NaN in the signal",
         {M::bad_samples},
         [](GoodFrame& frame, Take const&, std::size_t) { frame[radiance].set(3, 4, glm::vec3(std::nanf(""))); }},
        {"frame.number constant", {M::resets_every_frame}, [](GoodFrame& frame, Take const&, std::size_t) { frame.number = 7; }},
    };
}

} // namespace

void divide_by_albedo(GoodFrame& frame) {
    fill(frame[radiance], [&](int x, int y) {
        auto const a = frame[albedo].get(x, y), r = frame[radiance].get(x, y);
        return glm::vec3(a.x > 0 ? r.x / a.x : 0.f, a.y > 0 ? r.y / a.y : 0.f, a.z > 0 ? r.z / a.z : 0.f);
    });
}

std::vector<HostMistake> host_mistakes() {
    std::vector<HostMistake> all;
    for (auto const& some : {mistakes_of_motion(), mistakes_of_cameras(), mistakes_of_guides(), mistakes_of_samples()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace quell::tests

#include "worlds.hpp"

#include <tracer/ggx.hpp>

using namespace quell;
using namespace quell::tracer;

namespace {

/// Share of light that comes back from a surface for one direction of view, under constant light.
glm::vec3 albedo_of(Ggx const& metal, float cosine, int count) {
    glm::vec3 const out{std::sqrt(1 - cosine * cosine), 0, cosine};
    glm::vec3 sum{0.f};
    for (int i = 0; i < count; ++i) {
        auto const microfacet = metal.sample_normal(out, sample_pair({{1, 1}, static_cast<std::uint32_t>(i), 5}, SampleUse::glossy));
        auto const in = glm::reflect(-out, microfacet);
        if (in.z > 0) sum += metal.weight(out, in, microfacet);
    }
    return sum / static_cast<float>(count);
}

/// The GGX distribution of normals.
double density(double alpha, double cosine) {
    double const d = cosine * cosine * (alpha * alpha - 1) + 1;
    return alpha * alpha / (3.14159265358979 * d * d);
}

/// The same share by integrating distribution, masking and Fresnel over all directions.
double albedo_by_integration(Ggx const& metal, float cosine, int steps) {
    glm::vec3 const out{std::sqrt(1 - cosine * cosine), 0, cosine};
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            float const z = (static_cast<float>(i) + 0.5f) / static_cast<float>(steps),
                        turn = 6.2831853f * (static_cast<float>(j) + 0.5f) / static_cast<float>(steps);
            glm::vec3 const in{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
            auto const half = glm::normalize(out + in);
            double const masking = 1 / (1 + metal.lambda(out) + metal.lambda(in));
            sum += metal.fresnel(glm::dot(out, half)).x * density(metal.alpha, half.z) * masking / (4 * cosine);
        }
    return sum * 6.283185307 / (steps * steps);
}

} // namespace

TEST_CASE("a metal returns no more light than it receives, and nearly all when it is white and smooth") {
    for (float roughness : {0.f, 0.1f, 0.3f, 0.6f, 1.f})
        for (float cosine : {0.05f, 0.4f, 0.9f, 1.f}) {
            auto const found = albedo_of({glm::vec3{1.f}, 1, roughness * roughness}, cosine, 4096);
            CHECK(found.x <= 1.0001f);
            if (roughness <= 0.1f && cosine >= 0.4f) CHECK(found.x > 0.99f);
        }
}

TEST_CASE("sampling visible normals agrees with integrating the distribution") {
    for (float roughness : {0.4f, 0.7f, 1.f})
        for (float cosine : {0.2f, 0.6f, 0.95f}) {
            Ggx const metal{{0.7f, 0.3f, 0.1f}, 0.8f, roughness * roughness};
            CHECK(albedo_of(metal, cosine, 1 << 15).x == doctest::Approx(albedo_by_integration(metal, cosine, 1500)).epsilon(0.005));
        }
}

TEST_CASE("reflectance goes from base * metallic to metallic") {
    Ggx const metal{{0.8f, 0.5f, 0.2f}, 0.5f, 0.1f};
    CHECK(glm::distance(metal.fresnel(1), glm::vec3{0.4f, 0.25f, 0.1f}) < 1e-6f);
    CHECK(glm::distance(metal.fresnel(0), glm::vec3{0.5f}) < 1e-6f);
}

TEST_CASE("a mirror shows what is behind the viewer, where it is and where it was") {
    auto scene = world({0, 0, 2}, {0, 0, 0}, 20);
    auto const facing_viewer = glm::angleAxis(glm::radians(90.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(4, 4)), scene.add(Material{.base = {1, 0.5f, 0.25f}, .metallic = 1, .roughness = 0}),
                {.rotation = facing_viewer});
    auto const away = glm::angleAxis(glm::radians(-90.f), glm::vec3{1, 0, 0});
    scene.place(scene.add(rectangle(40, 40)), scene.add(Material{.emission = {1, 2, 3}}), [away](float frame) {
        return Transform{{0, 0.5f * frame, 5}, away}.matrix();
    });
    auto const pictures =
        pictures_of<Channels<Glossy, GlossyHit, GlossyHitPrevious, Direct, Position>>(std::move(scene), {.size = {9, 9}, .frame = 1});
    CHECK(glm::distance(pixel(pictures[glossy], 4, 4), glm::vec3{1, 1, 0.75f}) < 1e-4f);
    CHECK(pixel(pictures[direct], 4, 4) == glm::vec3{0.f});
    for (int x : {0, 4, 8}) {
        auto const at = pixel(pictures[position], x, 4), hit = pixel(pictures[glossy_hit], x, 4);
        CHECK(hit.z == doctest::Approx(5));
        CHECK(hit.x == doctest::Approx(at.x + at.x / 2 * 5).epsilon(1e-4));
        CHECK(glm::distance(pixel(pictures[glossy_hit_previous], x, 4), hit - glm::vec3{0, 0.5f, 0}) < 1e-5f);
    }
}

TEST_CASE("under a constant sky every metal sphere stays at or below its reflectance") {
    auto scene = world({0, 0, 4}, {0, 0, 0}, 40);
    scene.background = {glm::vec3{1.f}, glm::vec3{1.f}};
    scene.place(scene.add_sphere(), scene.add(Material{.base = glm::vec3{1.f}, .metallic = 1, .roughness = 0.4f}));
    auto const pictures = pictures_of<Channels<Glossy, Instance>>(std::move(scene), {.size = {20, 20}, .samples_per_pixel = 64});
    CHECK(pixel(pictures[glossy], 10, 10).x > 0.95f);
    for (auto const& value : pictures[glossy].pixels) CHECK(value.x <= 1.0001f);
}

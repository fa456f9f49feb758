#include "ggx.hpp"

namespace quell::tracer {

glm::vec3 Ggx::fresnel(float cosine) const {
    float const x = glm::clamp(1 - cosine, 0.f, 1.f), x2 = x * x;
    return metallic * (base + (glm::vec3{1.f} - base) * (x2 * x2 * x));
}

float Ggx::lambda(glm::vec3 direction) const {
    float const z2 = direction.z * direction.z, tangent2 = (1 - z2) / glm::max(z2, 1e-12f);
    return 0.5f * (std::sqrt(1 + alpha * alpha * glm::max(tangent2, 0.f)) - 1);
}

glm::vec3 Ggx::sample_normal(glm::vec3 out, glm::vec2 random) const {
    auto const stretched = glm::normalize(glm::vec3{out.x * alpha, out.y * alpha, out.z});
    float const turn = 2 * pi * random.x;
    float const z = (1 - random.y) * (1 + stretched.z) - stretched.z, sine = std::sqrt(glm::max(0.f, 1 - z * z));
    auto const normal = glm::vec3{sine * std::cos(turn), sine * std::sin(turn), z} + stretched;
    return glm::normalize(glm::vec3{normal.x * alpha, normal.y * alpha, glm::max(normal.z, 1e-7f)});
}

glm::vec3 Ggx::weight(glm::vec3 out, glm::vec3 in, glm::vec3 microfacet) const {
    if (in.z <= 0) return glm::vec3{0.f};
    float const lambda_out = lambda(out), lambda_in = lambda(in);
    return fresnel(glm::dot(out, microfacet)) * ((1 + lambda_out) / (1 + lambda_out + lambda_in));
}

} // namespace quell::tracer

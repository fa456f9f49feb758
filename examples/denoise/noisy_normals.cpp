#include <denoise/noisy_normals.hpp>

#include <quell/core/light.hpp>
#include <quell/core/real.hpp>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace quell::examples {

namespace {

constexpr int block = 16;               ///< pixels along rows and columns
constexpr double fewest = 64.;          ///< pairs of a block that counts
constexpr double rough = .02;           ///< the square of a difference of normals that is rough: 8 degrees
constexpr double least_planes = .75;    ///< part of all pairs that has to be on planes; two thirds are by chance
constexpr double least_rough = .75;     ///< part of these that has to be rough
constexpr double least_explained = .03; ///< part of light's differences that right normals explain, beyond chance

/// Sums over the pairs of a block.
struct Sums {
    double pairs = 0., squares = 0.;
    glm::dmat3 normals{0.};
    glm::dvec3 products{0.};

    void add(glm::dvec3 const& n, double l) { ++pairs, squares += l * l, normals += glm::outerProduct(n, n), products += l * n; }
    /// Of the squares of light's differences.
    [[nodiscard]] double explained() const {
        auto of_normals = normals;
        double const trace = normals[0][0] + normals[1][1] + normals[2][2];
        for (int c = 0; c < 3; ++c) of_normals[c][c] += 1e-6 * trace;
        return trace > 0. ? glm::dot(products, glm::inverse(of_normals) * products) : 0.;
    }
};

/// Calls f(block, here, there) with each two neighbours that both show a surface.
void for_each_pair(Extent size, SurfaceGuides const& guides, auto&& f) {
    int const blocks = (size.width + block - 1) / block;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (auto const& [dx, dy] : {std::array{1, 0}, std::array{0, 1}}) {
                if (x + dx >= size.width || y + dy >= size.height) continue;
                auto const here = index_of(size, x, y);
                auto const there = here + static_cast<std::size_t>(dy * size.width + dx);
                if (!is_finite(guides.depth[here]) || !is_finite(guides.depth[there])) continue;
                f(static_cast<std::size_t>(y / block * blocks + x / block), here, there, guides.are_on_one_plane(here, there, dx, dy));
            }
}
glm::dvec3 turn(SurfaceGuides const& guides, std::size_t here, std::size_t there) {
    glm::dvec3 off{};
    for (int c = 0; c < 3; ++c) {
        auto const& component = guides.normals[static_cast<std::size_t>(c)];
        off[c] = static_cast<double>(component[there] - component[here]);
    }
    return off;
}
} // namespace

bool are_normals_rough(Extent size, SurfaceGuides const& guides) {
    if (guides.depth.empty() || guides.normals[0].empty()) return false;
    double all = 0., on_planes = 0., rough_ones = 0.;
    for_each_pair(size, guides, [&](std::size_t, std::size_t here, std::size_t there, bool is_plane) {
        auto const off = turn(guides, here, there);
        ++all, on_planes += is_plane ? 1. : 0., rough_ones += is_plane && glm::dot(off, off) > rough ? 1. : 0.;
    });
    return on_planes >= least_planes * all && rough_ones >= least_rough * on_planes && on_planes > 0.;
}

bool do_normals_explain(Extent size, SurfaceGuides const& guides, LinearView const& light) {
    std::vector<Sums> sums(static_cast<std::size_t>(((size.width + block - 1) / block) * ((size.height + block - 1) / block)));
    for_each_pair(size, guides, [&](std::size_t b, std::size_t here, std::size_t there, bool is_plane) {
        double const from = static_cast<double>(luminance(light[here])), to = static_cast<double>(luminance(light[there]));
        auto const off = turn(guides, here, there);
        if (is_plane && from >= 0. && to >= 0. && from + to > 0. && std::isfinite(from + to + glm::dot(off, off)))
            sums[b].add(off, (to - from) / (from + to));
    });
    double squares = 0., explained = 0.;
    for (auto const& each : sums)
        if (each.pairs >= fewest) squares += each.squares, explained += each.explained() - each.squares * 3. / each.pairs;
    return explained >= least_explained * squares;
}

} // namespace quell::examples

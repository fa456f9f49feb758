#pragma once

#include <quell/frame/channels.hpp>
#include <quell/image/planar.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace quell::tests {

inline constexpr Extent size{96, 80};

/// A picture that a filter made of a flat surface, light 1 everywhere, its samples, and what is true.
struct FlatSurface {
    std::vector<glm::vec3> truth, samples, picture;
    ImageOf<Planar<>, Normal> normals{size};
    ImageOf<Planar<>, Depth> depths{size};

    /// @param at    the truth at a column and row
    /// @param noise standard deviation of the samples
    template <class Truth> FlatSurface(Truth&& at, float noise, unsigned seed = 5) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal_distribution(0.f, noise);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                truth.emplace_back(at(x, y));
                samples.push_back(truth.back() + glm::vec3(normal_distribution(random)));
                picture.emplace_back(1.f);
                normals.view().set(2, x, y, 1.f), depths.view().set(0, x, y, 3.f);
            }
    }
    [[nodiscard]] double error() const {
        double sum = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) sum += std::pow(static_cast<double>(picture[i].x - truth[i].x), 2.);
        return std::sqrt(sum / static_cast<double>(truth.size()));
    }
};

} // namespace quell::tests

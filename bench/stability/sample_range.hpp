#pragma once

#include <denoise/denoiser.hpp>

#include <array>
#include <string>
#include <vector>

namespace quell::stability {

/// The least and the greatest of some numbers; 0 without any.
struct Range {
    double low = 0, high = 0;
    bool empty = true;

    void add(double a);
    [[nodiscard]] double magnitude() const;
    friend Range operator*(Range const& a, Range const& b);
    friend Range operator+(Range const& a, Range const& b);
};

/// The samples that a preset has been shown since its history started, after the division by the albedo where it divides. What comes out
/// must lie between the least and the greatest.
class SampleRange {
    using Colours = std::vector<glm::vec3>;
    /// A signal, what it is divided by, and what it is multiplied by in the picture.
    struct Term {
        std::string signal, factor;
        std::array<Range, 3> seen{};
        Colours divisors{}, factors{};
        Term const* of_factor = nullptr; ///< where that is a signal too
    };
    std::vector<Term> terms;
    bool divides; ///< by the albedo

public:
    explicit SampleRange(examples::Preset const& preset);
    void start_over();
    void see(io::ExrImage const& frame);
    /// How far the picture of the frame that was seen last is outside, at most, as a part of what may come out there.
    [[nodiscard]] double beyond(metrics::Picture const& picture) const;

private:
    [[nodiscard]] Range possible(std::size_t pixel, std::size_t component) const;
};

} // namespace quell::stability

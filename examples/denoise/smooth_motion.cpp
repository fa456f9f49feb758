#include <denoise/linear_picture.hpp>
#include <denoise/smooth_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quell::examples {

namespace {

constexpr int unknowns = 2 * SmoothMotion::terms;
constexpr std::size_t fewest = 64;         ///< pixels in common
constexpr double most = 5000;              ///< pixels of a level that are looked at
constexpr double most_of_search = 600;     ///< for each of many shifts
constexpr int steps = 5;                   ///< of Gauss-Newton at each level
constexpr double most_left_at_first = .97; ///< of squared differences, in the coarsest pictures: else finer ones are not looked at
constexpr double most_left = .75;          ///< see found_motion()
constexpr double least_difference = .01;   ///< without the motion, of the variance
constexpr double least_motion = .05;       ///< in pixels, in the mean of the part
constexpr double farthest_shift = 1 / 3.;  ///< of the coarsest picture's sides

/// The mean luminance of what takes part, in which the sun's disc does not count whole.
double mean_of(Pyramid::Level const& level) {
    auto const mean_up_to = [&](double limit) {
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < level.light.size(); ++i)
            if (level.known[i]) sum += std::min(static_cast<double>(level.light[i]), limit), ++count;
        return count > 0 ? sum / count : 0.;
    };
    return mean_up_to(4 * mean_up_to(std::numeric_limits<double>::max()));
}

/// A level with luminance as l / (l + mean), and that as means over 3x3 pixels that take part, weighted 1, 2, 1 along rows and columns.
Pyramid::Level compared(Pyramid::Level level, double mean) {
    for (auto& l : level.light) l = static_cast<float>(static_cast<double>(l) / (static_cast<double>(l) + mean));
    auto const [width, height] = level.size;
    auto const light = level.light;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0, whole = 0;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                    auto const i = index_of(level.size, u, v);
                    float const weight = level.known[i] ? static_cast<float>((2 - std::abs(u - x)) * (2 - std::abs(v - y))) : 0.f;
                    sum += weight * light[i], whole += weight;
                }
            if (whole > 0) level.light[index_of(level.size, x, y)] = sum / whole;
        }
    return level;
}

/// Means of 2x2 pixels, of which all have to take part.
Pyramid::Level halved(Pyramid::Level const& finer) {
    Pyramid::Level level{{finer.size.width / 2, finer.size.height / 2}, {}, {}};
    for (int y = 0; y < level.size.height; ++y)
        for (int x = 0; x < level.size.width; ++x) {
            float sum = 0;
            bool are_known = true;
            for (int const v : {2 * y, 2 * y + 1})
                for (int const u : {2 * x, 2 * x + 1}) {
                    auto const i = index_of(finer.size, u, v);
                    sum += finer.light[i], are_known = are_known && finer.known[i];
                }
            level.light.push_back(sum / 4), level.known.push_back(are_known);
        }
    return level;
}

/// The light of a level between its pixels, and how it changes there.
struct Sample {
    double light, along_x, along_y;
};
std::optional<Sample> sample_of(Pyramid::Level const& level, double x, double y) {
    if (!(x >= 0 && y >= 0 && x <= level.size.width - 1 && y <= level.size.height - 1)) return std::nullopt;
    int const left = std::min(static_cast<int>(x), level.size.width - 2), top = std::min(static_cast<int>(y), level.size.height - 2);
    double const u = x - left, v = y - top;
    std::array<double, 4> corners{};
    for (int k = 0; k < 4; ++k) {
        auto const i = index_of(level.size, left + k % 2, top + k / 2);
        if (!level.known[i]) return std::nullopt;
        corners[static_cast<std::size_t>(k)] = static_cast<double>(level.light[i]);
    }
    auto const [a, b, c, d] = corners;
    return Sample{(1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d), (1 - v) * (b - a) + v * (d - c),
                  (1 - u) * (c - a) + u * (d - b)};
}

/// A part of one level of two pictures, so many pixels of the picture wide as `pixel` says.
struct Pair {
    Pyramid::Level const& now;
    Pyramid::Level const& before;
    std::vector<glm::vec2> const& told;
    Extent size;
    double pixel;
    double most_pixels = most;

    /// What the picture before shows of a place, by what is told of its motion and more.
    [[nodiscard]] std::optional<Sample> sample_before(double column, double row, glm::vec2 more) const {
        more += told[index_of(size, std::min(static_cast<int>(column), size.width - 1), std::min(static_cast<int>(row), size.height - 1))];
        return sample_of(before, (column + static_cast<double>(more.x) + .5) / pixel - .5,
                         (row + static_cast<double>(more.y) + .5) / pixel - .5);
    }
    /// Calls f(x, y, difference, sample of the picture before) for pixels of the part that both show; x and y are those of the picture.
    /// @return how many pixels the part has
    template <class F> std::size_t for_each_common(SmoothMotion const& motion, F const& f) const {
        int const stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(now.size.pixels()) / most_pixels))));
        std::size_t all = 0;
        for (int y = stride / 2; y < now.size.height; y += stride)
            for (int x = stride / 2; x < now.size.width; x += stride) {
                auto const i = index_of(now.size, x, y);
                if (!now.known[i]) continue;
                ++all;
                double const column = (x + .5) * pixel - .5, row = (y + .5) * pixel - .5;
                if (auto const there = sample_before(column, row, motion.at(column, row)))
                    f(column, row, static_cast<double>(now.light[i]) - there->light, *there);
            }
        return all;
    }
    /// The mean squared difference, infinite where fewer pixels than `fewest` or than half of the part are common.
    [[nodiscard]] double error(SmoothMotion const& motion) const {
        double sum = 0;
        std::size_t count = 0;
        auto const all = for_each_common(motion, [&](double, double, double d, Sample const&) { sum += d * d, ++count; });
        return count >= fewest && 2 * count >= all ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
    }
};

/// Solves for unknowns by elimination; false where they are not told.
bool solve(std::array<std::array<double, unknowns + 1>, unknowns>& rows) {
    for (std::size_t k = 0; k < unknowns; ++k) {
        auto const best = std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                           [k](auto const& a, auto const& b) { return std::abs(a[k]) < std::abs(b[k]); });
        if (!(std::abs((*best)[k]) > 0)) return false;
        std::swap(*best, rows[k]);
        for (std::size_t i = 0; i < unknowns; ++i) {
            if (i == k) continue;
            double const part = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j <= unknowns; ++j) rows[i][j] -= part * rows[k][j];
        }
    }
    return true;
}

/// One step of Gauss-Newton. Differences count by the Geman-McClure function of the mean squared one.
bool improve(Pair const& pair, SmoothMotion& motion) {
    double const square = pair.error(motion);
    if (!(square > 0) || !std::isfinite(square)) return false;
    std::array<std::array<double, unknowns + 1>, unknowns> rows{};
    pair.for_each_common(motion, [&](double x, double y, double difference, Sample const& there) {
        double const ratio = 1 + difference * difference / (2 * square), weight = 1 / (ratio * ratio);
        auto const terms = motion.terms_at(x, y);
        std::array<double, unknowns> slopes{};
        for (std::size_t k = 0; k < SmoothMotion::terms; ++k)
            slopes[k] = there.along_x / pair.pixel * terms[k], slopes[k + SmoothMotion::terms] = there.along_y / pair.pixel * terms[k];
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t j = 0; j < unknowns; ++j) rows[i][j] += weight * slopes[i] * slopes[j];
            rows[i][unknowns] += weight * slopes[i] * difference;
        }
    });
    double trace = 0;
    for (std::size_t i = 0; i < unknowns; ++i) trace += rows[i][i];
    for (std::size_t i = 0; i < unknowns; ++i) rows[i][i] += 1e-6 * trace; // what nothing tells of stays
    if (!solve(rows)) return false;
    for (std::size_t i = 0; i < unknowns; ++i)
        motion.factors[i / SmoothMotion::terms][i % SmoothMotion::terms] += rows[i][unknowns] / rows[i][i];
    return true;
}

/// The best shift by whole pixels of a level, up to a third of its sides: every second one, and then those beside the best.
SmoothMotion best_shift(Pair pair) {
    pair.most_pixels = most_of_search;
    SmoothMotion best{pair.size, {}};
    double least = pair.error(best);
    auto const try_shift = [&](int x, int y) {
        SmoothMotion shift{pair.size, {}};
        shift.factors[0][0] = x * pair.pixel, shift.factors[1][0] = y * pair.pixel;
        if (double const error = pair.error(shift); error < least) least = error, best = shift;
    };
    int const across = static_cast<int>(pair.now.size.width * farthest_shift) / 2,
              down = static_cast<int>(pair.now.size.height * farthest_shift) / 2;
    for (int y = -down; y <= down; ++y)
        for (int x = -across; x <= across; ++x) try_shift(2 * x, 2 * y);
    int const x = static_cast<int>(best.factors[0][0] / pair.pixel), y = static_cast<int>(best.factors[1][0] / pair.pixel);
    for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u) try_shift(u, v);
    return best;
}

/// Whether a motion explains differences, by pixels in which it makes any: in .6 of them, and in half of those of each quarter of the part.
/// Noise alone would be in favour in half. A quarter with less than a twentieth of the part has no say, and one without differences is
/// against.
bool is_borne_out(Pair const& pair, SmoothMotion const& motion) {
    struct Pixel {
        double x, y, light, with, without;
    };
    std::vector<Pixel> pixels;
    Pixel mean{};
    double moved = 0, square = 0;
    pair.for_each_common(motion, [&](double x, double y, double difference, Sample const& there) {
        auto const here = motion.at(x, y);
        auto const still = pair.sample_before(x, y, glm::vec2(0.f));
        if (!still) return;
        double const light = there.light + difference;
        pixels.push_back({x, y, light, difference * difference, (light - still->light) * (light - still->light)});
        mean.x += x, mean.y += y, mean.light += light, mean.with += pixels.back().with, mean.without += pixels.back().without;
        moved += std::hypot(static_cast<double>(here.x), static_cast<double>(here.y)), square += light * light;
    });
    if (pixels.size() < fewest) return false;
    auto const count = static_cast<double>(pixels.size());
    for (auto* const value : {&mean.x, &mean.y, &mean.light, &mean.with, &mean.without, &moved, &square}) *value /= count;
    double const variance = square - mean.light * mean.light;
    bool const matters = moved >= least_motion && mean.without > least_difference * variance;
    if (!matters || !(mean.with < most_left * std::min(mean.without, variance))) return false;
    struct Votes {
        double pixels = 0, all = 0, in_favour = 0;
    };
    std::array<Votes, 4> quarters{};
    Votes whole;
    for (auto const& pixel : pixels) {
        bool const counts = pixel.with + pixel.without > 1e-3 * variance, agrees = pixel.with < pixel.without;
        for (auto* const votes : {&quarters[(pixel.x > mean.x ? 1 : 0) + (pixel.y > mean.y ? 2 : 0)], &whole})
            votes->pixels += 1, votes->all += counts ? 1 : 0, votes->in_favour += counts && agrees ? 1 : 0;
    }
    return whole.in_favour > .6 * whole.all && std::ranges::all_of(quarters, [&](Votes const& votes) {
               return votes.pixels < .05 * count || (votes.all > .02 * votes.pixels && votes.in_favour > .5 * votes.all);
           });
}

} // namespace

SmoothMotion::Terms SmoothMotion::terms_at(double x, double y) const {
    double const per_width = 1. / std::max(size.width, 1);
    double const u = (x + .5 - size.width * .5) * per_width, v = (y + .5 - size.height * .5) * per_width;
    return {1, u, v, u * u, u * v, v * v};
}

glm::vec2 SmoothMotion::at(double x, double y) const {
    auto const terms_there = terms_at(x, y);
    std::array<double, 2> sum{};
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < terms; ++k) sum[c] += factors[c][k] * terms_there[k];
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1])};
}

glm::vec2 SmoothMotion::back_from(double x, double y) const {
    glm::vec2 back(0.f);
    for (int k = 0; k < 4; ++k) back = -at(x + static_cast<double>(back.x), y + static_cast<double>(back.y));
    return back;
}

Pyramid::Pyramid(Extent s, std::vector<float> light, std::vector<char> known) : size(s) {
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (!std::isfinite(light[i])) known[i] = 0;
        light[i] = known[i] ? std::max(light[i], 0.f) : 0.f;
    }
    Level level{size, std::move(light), std::move(known)};
    for (; level.size.width >= 8 && level.size.height >= 8; level = halved(level)) {
        if (level.size.width <= widest) levels.push_back(level);
        if (level.size.width <= narrowest) break;
    }
}

std::optional<SmoothMotion> found_motion(Pyramid const& now, Pyramid const& before, std::vector<glm::vec2> const& told) {
    auto const levels = std::min(now.levels.size(), before.levels.size());
    if (levels == 0) return std::nullopt;
    double const mean = .5 * (mean_of(now.levels[0]) + mean_of(before.levels[0]));
    if (!(mean > 0)) return std::nullopt;
    std::vector<Pyramid::Level> of_now, of_before;
    for (std::size_t level = 0; level < levels; ++level)
        of_now.push_back(compared(now.levels[level], mean)), of_before.push_back(compared(before.levels[level], mean));
    auto const pair = [&](std::size_t level) {
        return Pair{of_now[level], of_before[level], told, now.size, static_cast<double>(now.size.width / of_now[level].size.width)};
    };
    auto motion = best_shift(pair(levels - 1));
    for (auto level = levels; level-- > 0;) {
        for (int step = 0; step < steps && improve(pair(level), motion);) ++step;
        bool const is_first = level == levels - 1;
        if (is_first && !(pair(level).error(motion) < most_left_at_first * pair(level).error({now.size, {}}))) return std::nullopt;
    }
    if (!is_borne_out(pair(0), motion)) return std::nullopt;
    return motion;
}

} // namespace quell::examples

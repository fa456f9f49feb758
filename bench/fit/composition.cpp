#include "composition.hpp"

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace quell::bench {
namespace {

/// How much more than the least error is as good.
constexpr double slack = 1.02;

double mean_error(Composition const& composition, std::span<Converged const> wanted, auto const& error) {
    double sum = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) sum += error(wanted[i].displayed, metrics::displayed(picture_of(composition, i)));
    return sum / static_cast<double>(wanted.size());
}

/// The cheapest that keeps to a condition.
Composition* cheapest(std::vector<Composition>& compositions, auto const& condition) {
    Composition* found = nullptr;
    for (auto& one : compositions)
        if (condition(one) && (!found || one.figures.ms < found->figures.ms)) found = &one;
    return found;
}

} // namespace

std::string to_string(Composition const& composition) {
    std::vector<std::string> parts;
    for (auto const* trial : composition.parts)
        parts.push_back(fmt::format("{} by {}", name_of(trial->contender->part), trial->contender->name));
    return fmt::format("{}", fmt::join(parts, ", "));
}

metrics::Picture picture_of(Composition const& composition, std::size_t scored) {
    auto picture = composition.parts.front()->shares[scored];
    for (std::size_t p = 1; p < composition.parts.size(); ++p)
        std::ranges::transform(picture.pixels, composition.parts[p]->shares[scored].pixels, picture.pixels.begin(), std::plus{});
    return picture;
}

void measure(Composition& composition, std::span<Converged const> wanted) {
    composition.figures = {};
    for (auto const* trial : composition.parts) {
        composition.figures.ms += trial->ms;
        composition.figures.bytes_per_pixel += trial->bytes_per_pixel;
    }
    composition.figures.rmse = mean_error(composition, wanted, [](auto const& a, auto const& b) { return metrics::rmse(a, b); });
}

void measure_flip(Composition& composition, std::span<Converged const> wanted) {
    composition.figures.flip = mean_error(composition, wanted, [](auto const& a, auto const& b) { return metrics::flip(a, b).mean(); });
}

bool stands_in_for(Composition const& smaller, Composition const& other, Bounds const& bounds) {
    return smaller.figures.bytes_per_pixel < other.figures.bytes_per_pixel && bounds.met_by(smaller.figures) &&
           (bounds.asks_for_error() || smaller.figures.rmse <= slack * other.figures.rmse);
}

std::vector<Composition*> front_of(std::vector<Composition>& compositions) {
    std::vector<Composition*> all, front;
    for (auto& one : compositions) all.push_back(&one);
    std::ranges::stable_sort(all, {}, [](auto const* one) { return one->figures.ms; });
    for (auto* one : all)
        if (front.empty() || one->figures.rmse < front.back()->figures.rmse) front.push_back(one);
    return front;
}

Composition* smallest_within(std::vector<Composition>& compositions, Bounds const& bounds, std::span<Converged const> wanted) {
    if (!bounds.flip) return cheapest(compositions, [&](auto const& one) { return bounds.met_by(one.figures); });
    for (auto* one : front_of(compositions)) {
        measure_flip(*one, wanted);
        if (bounds.met_by(one->figures)) return one;
    }
    return nullptr;
}

Composition* most_accurate_in_time(std::span<std::vector<Composition>> levels, Bounds const& bounds) {
    double least = std::numeric_limits<double>::infinity();
    for (auto const& level : levels)
        for (auto const& one : level)
            if (bounds.in_time(one.figures)) least = std::min(least, one.figures.rmse);
    for (auto& level : levels)
        if (auto* const found =
                cheapest(level, [&](auto const& one) { return bounds.in_time(one.figures) && one.figures.rmse <= slack * least; }))
            return found;
    return nullptr;
}

} // namespace quell::bench

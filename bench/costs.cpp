#include "costs.hpp"

#include <algorithm>

namespace quell::bench {
namespace {

// Counted from the kernels' source. Trajectories that few pixels take (missing samples, rescue, spatial variance of short histories) are
// left out: the bound must not be above what is possible.

constexpr Cost luminance_cost{5.};      // fma, fma, *
constexpr Cost divisor{18.};            // Demodulate::divisor: 3 x (finite 2, clamp 2), luminance 5, < 1
constexpr double edge_weight_cost = 4.; // fma, max, to int
constexpr Cost pack_normal{20.};        // 2 +, max, 2 /, <, 2 x fold 2, 2 x quantise 5

/// Demodulate at the end and the output: reads the albedo, writes the output.
constexpr Cost output = divisor + Cost{3., 3., 3.};
/// Depth and normal copied for the next frame; the pass has read both.
constexpr Cost remember = pack_normal + Cost{0., 2., 0.};

constexpr Cost ingest = divisor + Cost{15., 6., 3.}; // 3 x (finite 2, >=, <=), 3 /; reads radiance and albedo, writes the signal

constexpr Cost undivided_ingest{12., 3., 3.}; // 3 x (finite 2, >=, <=)

constexpr double around_depth = 18. + 2. + 2.; // two slopes, times sigma; floor: *, max
constexpr double toward_depth = 0.5 * 7.;      // once for two taps: fma, *, +, approximate_reciprocal: fma, *
constexpr double depth_distance = 3.;          // -, fma
constexpr double normal_distance = 7.;         // +, 3 fma
constexpr double tap_weight = 2.;              // across * down, * edge weight
constexpr double accumulate_colour = 7.;       // 3 fma, +
constexpr double geometry_tap = toward_depth + depth_distance + normal_distance + edge_weight_cost + tap_weight + accumulate_colour;

constexpr double guided_tap = geometry_tap + 5. + 3. + 3.; // luminance, -, fma; w * w, fma for the variance
constexpr double variance_around = 8. * 4. + 12.;          // 8 taps: weight *, +, fma; /, max, sqrt, fma, /, luminance

/// Reads signal, depth and normal; a pass that is not the last writes the signal, the last one only the output.
constexpr Cost atrous_level(bool last) {
    return Cost{24. * geometry_tap + around_depth + 3. + 4., 4., 3.} + (last ? output : Cost{0., 0., 3.});
}
/// Variance is read and written beside that.
constexpr Cost guided_level(bool last) {
    return Cost{24. * guided_tap + around_depth + variance_around + 3. + 6., 4., 3. + 2.} + (last ? output + remember : Cost{0., 0., 3.});
}

constexpr double around_surface = 2. * 9. + 3. + 2. + 30.;   // slopes, allowed distance, place; sane() and the fractions of the position
constexpr double unpack = 24.;                               // 2 x restore 3, 2 -, <, 2 x fold 2, 5, sqrt, /, 3 *
constexpr double past_tap = 4. + 4. + 2. + 6. + 10. + 6.;    // inside, clamp, to int, place; the plane's test 10; dot and <
constexpr double fetch = 4. * (unpack + past_tap + 9.) + 6.; // 4 taps: bilinear weight 2, colour and weight 7; the mean

/// Reads motion, depth, normal, what was remembered of the last two, the signal now and then; writes the signal.
constexpr Cost temporal{around_surface + fetch + 10., 6. + 2., 9.};
/// 9 neighbours: 3 -, 3 x (2 + 3), +, sign; then the box: 3 x 10, the clamp 6 and how far it moved 15.
constexpr Cost clamp_cost{9. * 20. + 30. + 6. + 15.};
/// History length, mean and variance of the luminance: fetched, updated, written.
constexpr Cost moments = luminance_cost + Cost{4. * 6. + 3. + 16., 0., 6.};
/// Where every history is long: reads its length and its variance, writes the variance.
constexpr Cost variance_estimate{1., 0., 3.};
constexpr Cost pass_through{0., 0., 3.};

Cost temporal_of(std::string_view preset, bool last) {
    auto cost = temporal;
    if (preset == "surface-clamp") cost = cost + clamp_cost;
    if (preset == "svgf") cost = cost + moments;
    return last ? cost + output + remember : cost;
}

constexpr std::string_view counted[] = {"none", "surface", "surface-clamp", "atrous", "svgf"};

} // namespace

Cost cost_of(std::string_view preset, std::string_view pass, bool last) {
    if (std::ranges::find(counted, preset) == std::end(counted)) return {};
    if (preset == "none") return pass == "ingest" ? undivided_ingest : pass_through + Cost{0., 3., 0.};
    if (pass == "ingest") return ingest;
    if (pass == "temporal") return temporal_of(preset, last);
    if (pass == "variance-estimate") return variance_estimate;
    if (pass.starts_with("a-trous")) return atrous_level(last);
    if (pass.starts_with("variance-guided-a-trous")) return guided_level(last);
    return {};
}

double Cost::bound(Machine const& m, int stored_size) const {
    return std::max(operations / m.operations_per_second, bytes(stored_size) / m.bytes_per_second);
}

} // namespace quell::bench

#include <denoise/scores.hpp>

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>

#include <cstdio>

namespace quell::examples {

Scores::Scores(std::ostream& out_) : out(out_) { out << "frame,rmse,ssim,flip\n" << std::flush; }

void Scores::add(long long frame, metrics::Picture const& reference, metrics::Picture const& output) {
    auto const expected = metrics::displayed(reference), shown = metrics::displayed(output);
    auto const r = metrics::rmse(expected, shown), s = metrics::ssim(expected, shown), f = metrics::flip(expected, shown).mean();
    row(std::to_string(frame), r, s, f);
    rmse += r, ssim += s, flip += f;
    ++frames;
}

void Scores::finish() const { row("mean", rmse / frames, ssim / frames, flip / frames); }

void Scores::row(std::string const& name, double r, double s, double f) const {
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.6f,%.6f,%.6f", r, s, f);
    out << name << ',' << numbers << '\n' << std::flush;
}

} // namespace quell::examples

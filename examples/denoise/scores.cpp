#include <denoise/scores.hpp>

#include <fmt/format.h>

namespace quell::examples {

Scores::Scores(std::ostream& out_) : out(out_) { out << "frame,rmse,ssim,flip\n" << std::flush; }

ImageErrors Scores::add(long long frame, metrics::Picture const& reference, metrics::Picture const& output) {
    auto const expected = metrics::displayed(reference), shown = metrics::displayed(output);
    auto const errors = image_errors(expected, shown);
    row(std::to_string(frame), errors);
    sum += errors;
    ++frames;
    return errors;
}

void Scores::finish() const { row("mean", sum / frames); }

void Scores::row(std::string const& name, ImageErrors const& errors) const {
    out << fmt::format("{},{:.6f},{:.6f},{:.6f}\n", name, errors.rmse, errors.ssim, errors.flip) << std::flush;
}

} // namespace quell::examples

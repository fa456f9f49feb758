#include <denoise/scores.hpp>

#include <fmt/format.h>

namespace quell::examples {

std::string Scores::header() {
    std::string line = "frame";
    for (auto const& metric : metrics::all_metrics) line.append(",").append(metric.name);
    return line;
}

Scores::Scores(std::ostream& out_) : out(out_) { out << header() << '\n' << std::flush; }

metrics::Errors Scores::compare(metrics::Picture const& reference, metrics::Picture const& output) {
    auto const expected = metrics::displayed(reference), shown = metrics::displayed(output);
    return metrics::errors_of({expected, shown});
}

void Scores::add(long long frame, metrics::Errors const& errors) {
    row(std::to_string(frame), errors);
    mean.add(errors);
}

void Scores::finish() const { row("mean", mean.mean()); }

void Scores::row(std::string line, metrics::Errors const& errors) const {
    errors.for_each([&](auto const&, double value) { line += fmt::format(",{:.6f}", value); });
    out << line << '\n' << std::flush;
}

} // namespace quell::examples

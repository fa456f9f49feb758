#include <gauntlet/limits.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace quell::gauntlet {

namespace {

/// Ratios of one frame.
class Judge {
    Row const& row;
    Limits const& limits;
    Verdict& verdict;

    void hold(FrameFigures const& frame, char const* what, double ratio, double limit, double& worst) const {
        worst = std::max(worst, ratio);
        if (ratio > limit) verdict.broken.push_back(fmt::format("frame {}: {} {:.3f} > {}", frame.frame, what, ratio, limit));
    }
    void count_windows(FrameFigures const& frame, std::vector<double> const& others) const {
        auto const& windows = frame.windows[by_default];
        for (std::size_t i = 0; i < windows.size(); ++i) {
            if (windows[i] < limits.least) continue;
            ++verdict.windows;
            if (windows[i] <= limits.window_over_quick * others[i]) ++verdict.good;
        }
    }

public:
    Judge(Row const& r, Limits const& l, Verdict& v) : row(r), limits(l), verdict(v) {}

    void add(FrameFigures const& frame, Stored const* before) const {
        count_windows(frame, before ? before->windows : frame.windows[by_quick]);
        double const error = frame.error[by_default], input = frame.error[by_none];
        if (error < limits.least) return;
        double const quick = before ? before->quick : frame.error[by_quick];
        hold(frame, "over --quick", error / quick, limits.over_quick, verdict.over_quick);
        if (row.samples < limits.spared_from || quick <= input)
            hold(frame, "over the input", error / input, limits.over_input, verdict.over_input);
        if (before && frame.has_right && before->right >= limits.least)
            hold(frame, "right part over before", frame.right[by_default] / before->right, limits.right_over_before,
                 verdict.right_over_before);
    }
};

void check_silence(Row const& row, Limits const& limits, Verdict& verdict) {
    for (auto const& line : row.findings) verdict.broken.push_back("it finds: " + line);
    for (auto const& line : row.remarks)
        if (std::ranges::none_of(limits.known_remarks, [&](auto const& part) { return line.find(part) != std::string::npos; }))
            verdict.broken.push_back("it remarks: " + line);
}

double percent(long long part, long long all) { return all > 0 ? 100. * static_cast<double>(part) / static_cast<double>(all) : 100.; }

} // namespace

Verdict verdict_on(Row const& row, StoredFigures const& before, Limits const& limits) {
    Verdict verdict;
    Judge const judge(row, limits, verdict);
    for (auto const& frame : row.frames) judge.add(frame, before.find(row.situation->name, row.samples, frame.frame));
    verdict.good_windows = percent(verdict.good, verdict.windows);
    if (row.situation->twin.empty()) check_silence(row, limits, verdict);
    if (verdict.good_windows < limits.good_windows_of_row)
        verdict.broken.push_back(fmt::format("good windows {:.1f} % < {}", verdict.good_windows, limits.good_windows_of_row));
    return verdict;
}

std::vector<std::string> broken_together(std::vector<Row> const& rows, std::vector<Verdict> const& verdicts, Limits const& limits) {
    std::map<int, std::pair<long long, long long>> by_samples;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto& [good, all] = by_samples[rows[i].samples];
        good += verdicts[i].good, all += verdicts[i].windows;
    }
    std::vector<std::string> broken;
    for (auto const& [samples, counts] : by_samples)
        if (double const good = percent(counts.first, counts.second); good < limits.good_windows)
            broken.push_back(fmt::format("{} samples: good windows {:.1f} % < {}", samples, good, limits.good_windows));
    return broken;
}

} // namespace quell::gauntlet

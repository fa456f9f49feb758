#include "cases.hpp"
#include "known_limits.hpp"

#include <report/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace quell::stability {
namespace {

std::string number(double a) { return fmt::format("{:.4g}", a); }

std::string verdict(Promise const& promise) {
    if (promise.held()) return "held";
    return known_limit(promise) == nullptr ? "broken" : "known limit";
}

/// Why promises of a case are known not to hold, each reason once.
void explain(examples::Report& report, Results const& results, std::string const& subject) {
    std::set<std::string> reasons;
    for (auto const& p : results.promises)
        if (auto const* const known = known_limit(p); p.subject == subject && !p.held() && known != nullptr)
            if (reasons.insert(known->reason).second) report.notes.push_back({.label = "known limit of " + subject, .text = known->reason});
}

} // namespace

void write_page(Results const& results, std::filesystem::path const& folder) {
    examples::Report report{.title = "quell: where methods fail"};
    auto const held = std::ranges::count_if(results.promises, &Promise::held);
    report.subtitle = std::to_string(held) + " of " + std::to_string(results.promises.size()) + " promises hold";
    for (auto const& f : results.frames) report.add_value(f.subject + ": RMSE", f.method, f.frame, f.errors["rmse"]);
    for (auto const& each : cases()) {
        examples::ReportTable table{
            .caption = each.name + ": " + each.about, .columns = {"method", "what", "value", "limit", ""}, .rows = {}};
        for (auto const& p : results.promises)
            if (p.subject == each.name)
                table.rows.push_back({p.method, p.metric, number(p.value), (p.at_least ? ">= " : "<= ") + number(p.limit), verdict(p)});
        if (!table.rows.empty()) report.tables.push_back(std::move(table));
        explain(report, results, each.name);
    }
    examples::write_report(report, folder / "index.html");
}

} // namespace quell::stability

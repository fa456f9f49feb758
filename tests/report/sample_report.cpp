#include "sample_report.hpp"

#include "sample_picture.hpp"

#include <cmath>
#include <string>

namespace quell::examples::sample {

namespace {

std::vector<unsigned> stops_of(ColorScale const& scale) {
    std::vector<unsigned> stops;
    for (std::string const& color : scale.colors) stops.push_back(static_cast<unsigned>(std::stoul(color.substr(1), nullptr, 16)));
    return stops;
}

void add_frame(Report& report, int width, int height, int number) {
    Picture const reference = draw_scene(width, height, number);
    Picture const noisy = add_noise(reference, 0.8, number);
    Picture const denoised = add_noise(reference, 0.05 + 0.25 * std::exp(-0.5 * number), number + 1000);
    ReportFrame& frame = report.frames.emplace_back(ReportFrame{.number = number});
    frame.pictures["noisy"] = encode_png(noisy);
    frame.pictures["denoised"] = encode_png(denoised);
    for (char const* metric : {"FLIP", "RMSE"}) {
        double const factor = *metric == 'F' ? 1 : 1.4;
        report.add_value(metric, "noisy", number, factor * mean_difference(noisy, reference));
        report.add_value(metric, "denoised", number, factor * mean_difference(denoised, reference));
    }
    if (number % 2 != 0) return;
    frame.pictures["reference"] = encode_png(reference);
    frame.pictures["FLIP of denoised"] = encode_png(draw_difference(denoised, reference, stops_of(flip_color_scale())));
}

void add_words(Report& report) {
    report.tables.push_back({"Summary over all frames",
                             {"method", "FLIP", "RMSE", "time per frame"},
                             {{"noisy (1 sample per pixel)", "0.266", "0.373", "–"}, {"denoised", "0.026", "0.037", "4.81 ms"}}});
    report.notes = {{"scene", "ball over a chequered floor, light turning"},
                    {"machine", "2 cores, no graphics card"},
                    {"command", "quell_demo --scene \"ball\" --frames 6 --samples 1 --output out/report/index.html", true}};
}

} // namespace

Report make_report(int width, int height, int frame_count) {
    Report report{.title = "Ball over a chequered floor: quell's \"<default>\" settings",
                  .subtitle = std::to_string(width) + " × " + std::to_string(height) + " pixels, 1 sample per pixel"};
    report.kinds = {{"noisy", "one sample per pixel"},
                    {"denoised", "what quell makes of it"},
                    {"reference", "converged"},
                    {"FLIP of denoised", "where the denoised picture differs from the reference", flip_color_scale()}};
    for (int i = 0; i < frame_count; ++i) add_frame(report, width, height, i);
    for (ReportMetric& metric : report.metrics) metric.hint = "lower is better";
    if (!report.metrics.empty()) report.metrics.front().unit = "0 to 1";
    add_words(report);
    return report;
}

Report make_bare_report() {
    Report report{.title = "One picture", .kinds = {{"noisy"}}};
    report.frames.push_back({7, {{"noisy", encode_png(draw_scene(64, 48, 0))}}});
    return report;
}

Report make_report_of_figures() {
    Report report{.title = "Figures"};
    char const* const methods[] = {"surface", "surface-clamp", "svgf", "general", "final-frame", "dual-color", "glossy", "dual-cone"};
    ReportTable table{.caption = "cut-unnoticed: the camera jumps to another room and nobody says so",
                      .columns = {"method", "what", "value", "limit", ""},
                      .rows = {}};
    for (int i = 0; i < 8; ++i) {
        std::string const fresh = std::string(methods[i]) + "-fresh";
        for (int frame = 0; frame < 40; ++frame) {
            report.add_value("pan: RMSE", methods[i], frame, 1 + i + std::sin(0.3 * frame));
            report.add_value("cut: RMSE", methods[i], frame, 1 + i + std::sin(0.3 * frame));
            report.add_value("cut: RMSE", fresh, frame, 1.5 + i + std::sin(0.3 * frame));
            report.add_value("cut: RMSE", fresh + "-half", frame, 1.75 + i + std::sin(0.3 * frame));
        }
        table.rows.push_back({methods[i], "worst_frame_over_fresh_start", "1.2345", "<= 1.05", "known limit"});
    }
    report.tables = {table, table};
    return report;
}

} // namespace quell::examples::sample

#include "sample_report.hpp"

#include <quell/metrics/error_map.hpp>
#include <quell/metrics/rmse.hpp>
#include <support/png.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace quell::examples::sample {

namespace {

/// A ball before a chequered floor, which moves with the frame.
metrics::Picture draw_scene(Extent size, int frame) {
    metrics::Picture picture{size, {}};
    auto const height = static_cast<float>(size.height), ball = 0.2f * std::sin(0.5f * static_cast<float>(frame));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const u = (static_cast<float>(x) + 0.5f - static_cast<float>(size.width) / 2) / height;
            float const v = (static_cast<float>(y) + 0.5f) / height - 0.5f, from_ball = std::hypot(u - ball, v);
            bool const is_dark = static_cast<int>(std::floor(8 * u) + std::floor(8 * v)) % 2 != 0;
            glm::vec3 const behind = v > 0.1f ? glm::vec3(is_dark ? 0.28f : 0.72f) : glm::vec3(0.35f, 0.5f, 0.7f) + 0.3f * v;
            picture.pixels.push_back(from_ball < 0.3f ? glm::vec3(1, 0.55f, 0.32f) * (1 - 2 * from_ball) : behind);
        }
    return picture;
}

metrics::Picture with_noise(metrics::Picture picture, float strength, unsigned seed) {
    std::mt19937 random(seed);
    for (auto& colour : picture.pixels)
        for (int c = 0; c < 3; ++c) {
            auto const noise = static_cast<float>(random() >> 8) * 0x1p-23f - 1;
            colour[c] = std::clamp(colour[c] + strength * noise, 0.f, 1.f);
        }
    return picture;
}

void add_frame(Report& report, Extent size, int number) {
    auto const seed = static_cast<unsigned>(number);
    auto const reference = draw_scene(size, number), noisy = with_noise(reference, 0.8f, seed);
    auto const denoised = with_noise(reference, 0.05f + 0.25f * std::exp(-0.5f * static_cast<float>(number)), seed + 1000);
    ReportFrame& frame = report.frames.emplace_back(ReportFrame{.number = number});
    frame.pictures["noisy"] = encode_png(noisy);
    frame.pictures["denoised"] = encode_png(denoised);
    auto const error = metrics::flip(reference, denoised);
    report.add_value("FLIP", "noisy", number, metrics::flip(reference, noisy).mean());
    report.add_value("FLIP", "denoised", number, error.mean());
    report.add_value("RMSE", "noisy", number, metrics::rmse(reference, noisy));
    report.add_value("RMSE", "denoised", number, metrics::rmse(reference, denoised));
    if (number % 2 != 0) return;
    frame.pictures["reference"] = encode_png(reference);
    frame.pictures["FLIP of denoised"] = encode_png(metrics::error_map(error));
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
    for (int i = 0; i < frame_count; ++i) add_frame(report, {width, height}, i);
    for (ReportMetric& metric : report.metrics) metric.hint = "lower is better";
    if (!report.metrics.empty()) report.metrics.front().unit = "0 to 1";
    add_words(report);
    return report;
}

Report make_bare_report() {
    Report report{.title = "One picture", .kinds = {{"noisy"}}};
    report.frames.push_back({7, {{"noisy", encode_png(draw_scene({64, 48}, 0))}}});
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

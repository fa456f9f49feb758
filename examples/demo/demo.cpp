#include "demo.hpp"

#include "method.hpp"

#include <quell/image/planar.hpp>
#include <quell/io/exr.hpp>
#include <quell/metrics/error_map.hpp>
#include <quell/metrics/metric.hpp>
#include <report/report.hpp>
#include <support/frame_pattern.hpp>
#include <support/median.hpp>
#include <support/output_folder.hpp>
#include <support/png.hpp>
#include <support/progress.hpp>
#include <tracer/gltf/gltf.hpp>
#include <tracer/reference.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace quell::examples {

namespace {

std::string number(double a, int digits) { return fmt::format("{:.{}f}", a, digits); }

class Demo {
public:
    Demo(DemoOptions const& options_, std::string const& scene_, std::filesystem::path const& folder_)
        : options(options_), folder(folder_), scene_name(scene_), scene(tracer::open_scene(scene_)),
          // What has no noise but that of time was made to be blurred.
          blurs(!scene.description().secondary_rays),
          method(blurs ? motion_blur(options_.size, options_.threads) : all_effects(options_.size, options_.threads)),
          kinds(method->kinds()), means(kinds.size()) {
        make_output_folder(folder);
        report.title = "quell: " + std::filesystem::path(scene_).stem().string();
        report.subtitle = to_string(options.size) + ", 1 sample per pixel, " + std::to_string(options.frames) + " frames";
        for (auto const& kind : kinds) report.kinds.push_back({kind.name, kind.description});
        report.kinds.push_back({"reference", "converged"});
        report.kinds.push_back({"error (FLIP)", "of the denoised image", flip_color_scale()});
    }

    std::filesystem::path all() {
        Progress progress(scene_name, options.frames, !options.quiet);
        for (int i = 0; i < options.frames; ++i) {
            progress.show(i, "frame " + std::to_string(i));
            one(i);
        }
        summarise();
        auto const page = folder / "index.html";
        write_report(report, page);
        return page;
    }

private:
    DemoOptions const& options;
    std::filesystem::path folder;
    std::string scene_name;
    tracer::PreparedScene scene;
    bool blurs;
    std::unique_ptr<DemoMethod> method;
    std::vector<DemoMethod::Kind> kinds;
    Report report;
    std::vector<metrics::MeanErrors> means; ///< of each kind, over the frames that have a reference
    std::vector<double> milliseconds;

    [[nodiscard]] tracer::RenderSettings settings_of(int i) const {
        return {.size = options.size, .frame = i, .seed = options.seed, .threads = options.threads, .shutter = blurs ? 0.5f : 0.f};
    }

    void one(int i) {
        auto const pictures = method->frame(scene, settings_of(i));
        milliseconds.push_back(method->milliseconds());
        auto& entry = report.frames.emplace_back(ReportFrame{.number = i});
        for (std::size_t k = 0; k < kinds.size(); ++k) write(entry, kinds[k].name, i, pictures[k]);
        bool const scored = options.reference_every > 0 && (i + 1 == options.frames || (i > 0 && i % options.reference_every == 0));
        if (scored) compare(entry, i, pictures);
    }

    void write(ReportFrame& entry, std::string const& kind, int i, metrics::Picture const& linear) {
        auto const shown = metrics::displayed(linear);
        auto png = encode_png(shown);
        write_png(folder / frame_file_name(kind, i, "png"), shown);
        io::ExrImage image{.size = linear.size};
        Planar<>::Image<3> copy(linear.size);
        for (int y = 0; y < linear.size.height; ++y)
            for (int x = 0; x < linear.size.width; ++x)
                copy.set(
                    x, y,
                    linear.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(linear.size.width) + static_cast<std::size_t>(x)]);
        io::put(image, radiance, copy.view());
        io::put_camera(image, scene.description().camera_at(static_cast<float>(i), options.size));
        io::write_exr(folder / frame_file_name(kind, i, "exr"), image);
        entry.pictures[kind] = std::move(png);
    }

    void compare(ReportFrame& entry, int i, std::vector<metrics::Picture> const& pictures) {
        tracer::ReferenceSettings reference_settings{.tolerance = options.reference_tolerance};
        Progress progress("reference of frame " + std::to_string(i), reference_settings.max_samples, !options.quiet);
        reference_settings.progress = [&](tracer::ReferenceProgress const& p) {
            progress.show(p.samples, "halves differ by " + number(p.difference, 4) + ", wanted " + number(p.tolerance, 4));
        };
        auto const converged = tracer::reference<Channels<Radiance>>(scene, settings_of(i), reference_settings);
        auto const reference = metrics::displayed(converged[radiance]);
        write(entry, "reference", i, converged[radiance]);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            auto const shown = metrics::displayed(pictures[k]);
            metrics::Comparison const compared{reference, shown};
            auto const errors = metrics::errors_of(compared);
            means[k].add(errors);
            errors.for_each(
                [&](auto const& metric, double value) { report.add_value(std::string(metric.title), kinds[k].name, i, value); });
            if (kinds[k].name == "denoised") entry.pictures["error (FLIP)"] = encode_png(metrics::error_map(compared.difference));
        }
    }

    void summarise() {
        if (int const referenced = means.front().count; referenced > 0) {
            auto& table = report.tables.emplace_back(
                ReportTable{"Mean over the " + std::to_string(referenced) + " frames that have a reference", {"image"}, {}});
            for (auto const& metric : metrics::all_metrics) table.columns.emplace_back(metric.title);
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                auto& row = table.rows.emplace_back(std::vector{kinds[k].name});
                means[k].mean().for_each([&](auto const&, double value) { row.push_back(number(value, 4)); });
            }
        }
        report.notes = {
            {"denoising", number(median(milliseconds), 1) + " ms per frame (median), " + number(method->bytes_per_pixel(), 1) +
                              " bytes per pixel of history and scratch"},
            {"machine", std::to_string(std::thread::hardware_concurrency()) + " hardware threads, packs of " +
                            std::to_string(width_of<Pack>) + " floats"},
            {"command",
             "quell-demo --scene " + scene_name + " --size " + to_string(options.size) + " --frames " + std::to_string(options.frames),
             true}};
        for (auto const& metric : metrics::all_metrics)
            for (auto& plotted : report.metrics)
                if (plotted.name == metric.title) plotted.hint = metric.higher_is_better ? "higher is better" : "lower is better";
        // What a viewer sees comes first.
        std::stable_partition(report.metrics.begin(), report.metrics.end(), [](auto const& plotted) { return plotted.name == "FLIP"; });
    }
};

} // namespace

std::filesystem::path run_demo(DemoOptions const& options, std::string const& scene, std::filesystem::path const& folder) {
    return Demo(options, scene, folder).all();
}

} // namespace quell::examples

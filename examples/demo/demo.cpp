#include "demo.hpp"

#include "denoised.hpp"

#include <algorithm>
#include <cstdio>
#include <quell/io/exr.hpp>
#include <quell/metrics/error_map.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>
#include <report/report.hpp>
#include <support/png.hpp>
#include <support/progress.hpp>
#include <thread>
#include <tracer/frame_sink.hpp>
#include <tracer/gltf/gltf.hpp>
#include <tracer/reference.hpp>

namespace quell::examples {

namespace {

metrics::Picture picture_of(ImageView auto const& view) {
    metrics::Picture picture{view.size, {}};
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x) picture.pixels.emplace_back(view.get(0, x, y), view.get(1, x, y), view.get(2, x, y));
    return picture;
}

std::string file_name(char const* kind, int frame, char const* ending) {
    char text[64];
    std::snprintf(text, sizeof text, "%s.%04d.%s", kind, frame, ending);
    return text;
}

std::string number(double a, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, a);
    return text;
}

/// Errors of the noisy and the denoised image, summed over the frames that have a reference.
struct Score {
    double rmse = 0, ssim = 0, flip = 0;
    int frames = 0;

    metrics::Flip add(metrics::Picture const& reference, metrics::Picture const& picture) {
        auto const flip_map = metrics::flip(reference, picture);
        rmse += metrics::rmse(reference, picture), ssim += metrics::ssim(reference, picture), flip += flip_map.mean(), ++frames;
        return flip_map;
    }
    [[nodiscard]] std::vector<std::string> row(std::string name) const {
        double const n = std::max(frames, 1);
        return {std::move(name), number(rmse / n, 4), number(ssim / n, 4), number(flip / n, 4)};
    }
};

class Demo {
public:
    Demo(DemoOptions const& options_, std::string const& scene_, std::filesystem::path const& folder_)
        : options(options_), folder(folder_), scene_name(scene_), scene(tracer::open_scene(scene_)), frame(options_.size),
          denoiser(options_.size, options_.threads) {
        std::filesystem::create_directories(folder);
        report.title = "quell: " + std::filesystem::path(scene_).stem().string();
        report.subtitle = to_string(options.size) + ", 1 sample per pixel, " + std::to_string(options.frames) + " frames";
        report.kinds = {{"noisy", "one path per pixel"},
                        {"denoised", "preset trmv"},
                        {"reference", "converged"},
                        {"error (FLIP)", "of the denoised image", flip_color_scale()}};
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
    DemoFrame frame;
    DemoDenoiser denoiser;
    Report report;
    Score noisy_score, denoised_score;
    std::vector<double> milliseconds;

    void one(int i) {
        trace(i);
        milliseconds.push_back(denoiser.run(frame));
        auto const noisy = picture_of(frame[radiance].view()), clean = picture_of(denoiser.result);
        auto& entry = report.frames.emplace_back(ReportFrame{.number = i});
        write(entry, "noisy", i, noisy);
        write(entry, "denoised", i, clean);
        bool const scored = options.reference_every > 0 && (i + 1 == options.frames || (i > 0 && i % options.reference_every == 0));
        if (scored) compare(entry, i, metrics::displayed(noisy), metrics::displayed(clean));
    }

    void trace(int i) {
        tracer::RenderSettings settings{.size = options.size, .frame = i, .seed = options.seed, .threads = options.threads};
        tracer::FrameSink<DemoFrame> sink{frame};
        tracer::render<DemoFrame::channels>(scene, settings, sink);
        frame.camera = scene.description().camera_at(static_cast<float>(i), options.size);
        frame.number = i;
    }

    void write(ReportFrame& entry, char const* kind, int i, metrics::Picture const& linear) {
        auto const shown = metrics::displayed(linear);
        auto png = encode_png(shown);
        write_png(folder / file_name(kind, i, "png"), shown);
        io::ExrImage image{.size = linear.size};
        Planar<>::Image<3> copy(linear.size);
        for (int y = 0; y < linear.size.height; ++y)
            for (int x = 0; x < linear.size.width; ++x)
                copy.set(
                    x, y,
                    linear.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(linear.size.width) + static_cast<std::size_t>(x)]);
        io::put(image, radiance, copy.view());
        io::put_camera(image, frame.camera);
        io::write_exr(folder / file_name(kind, i, "exr"), image);
        entry.pictures[kind] = std::move(png);
    }

    void compare(ReportFrame& entry, int i, metrics::Picture const& noisy, metrics::Picture const& clean) {
        tracer::RenderSettings const settings{.size = options.size, .frame = i, .seed = options.seed, .threads = options.threads};
        tracer::ReferenceSettings reference_settings{.tolerance = options.reference_tolerance};
        Progress progress("reference of frame " + std::to_string(i), reference_settings.most_samples, !options.quiet);
        reference_settings.progress = [&](tracer::ReferenceProgress const& p) {
            progress.show(p.samples, "halves differ by " + number(p.difference, 4) + ", wanted " + number(p.tolerance, 4));
        };
        auto const converged = tracer::reference<Channels<Radiance>>(scene, settings, reference_settings);
        auto const reference = metrics::displayed(converged[radiance]);
        write(entry, "reference", i, converged[radiance]);
        auto const before = noisy_score, after = denoised_score;
        noisy_score.add(reference, noisy);
        auto const errors = denoised_score.add(reference, clean);
        entry.pictures["error (FLIP)"] = encode_png(metrics::error_map(errors));
        auto const plot = [&](char const* series, Score const& now, Score const& then) {
            report.add_value("FLIP", series, i, now.flip - then.flip);
            report.add_value("RMSE", series, i, now.rmse - then.rmse);
            report.add_value("SSIM", series, i, now.ssim - then.ssim);
        };
        plot("noisy", noisy_score, before);
        plot("denoised", denoised_score, after);
    }

    void summarise() {
        std::nth_element(milliseconds.begin(), milliseconds.begin() + static_cast<std::ptrdiff_t>(milliseconds.size() / 2),
                         milliseconds.end());
        if (noisy_score.frames > 0)
            report.tables = {{"Mean over the " + std::to_string(noisy_score.frames) + " frames that have a reference",
                              {"image", "RMSE", "SSIM", "FLIP"},
                              {noisy_score.row("noisy"), denoised_score.row("denoised")}}};
        report.notes = {
            {"denoising", number(milliseconds[milliseconds.size() / 2], 1) + " ms per frame (median), " +
                              number(denoiser.history.bytes_per_pixel(), 1) + " bytes per pixel of history and scratch"},
            {"machine", std::to_string(std::thread::hardware_concurrency()) + " hardware threads, packs of " +
                            std::to_string(width_of<Pack>) + " floats"},
            {"command",
             "quell-demo --scene " + scene_name + " --size " + to_string(options.size) + " --frames " + std::to_string(options.frames),
             true}};
        for (auto& metric : report.metrics) metric.hint = metric.name == "SSIM" ? "higher is better" : "lower is better";
    }
};

} // namespace

std::filesystem::path run_demo(DemoOptions const& options, std::string const& scene, std::filesystem::path const& folder) {
    return Demo(options, scene, folder).all();
}

} // namespace quell::examples

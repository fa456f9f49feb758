#include <files.hpp>
#include <gauntlet/frame_file.hpp>
#include <gauntlet/measures.hpp>
#include <gauntlet/row.hpp>

#include <quell/io/exr.hpp>
#include <support/frame_pattern.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace quell::gauntlet {

namespace {
namespace fs = std::filesystem;
using bench::picture_in, bench::quoted;
constexpr auto frames = "frame.%04d.exr";

/// Runs quell-denoise. Returns its summary.
nlohmann::json denoise(fs::path const& program, std::string const& in, fs::path const& out, std::string const& options) {
    fs::create_directories(out);
    auto const said = out / "summary.json", complaint = out / "errors.txt";
    auto const command = quoted(program.string()) + " --json --quiet --threads 1 --layers picture --in " + quoted(in) + " --out " +
                         quoted((out / frames).string()) + ' ' + options + " > " + quoted(said.string()) + " 2> " +
                         quoted(complaint.string());
    if (std::system(command.c_str()) != 0) {
        std::ifstream text(complaint);
        std::string line;
        std::getline(text, line);
        throw Failure(program.string(), "it ended with: " + line, "run it by hand: " + command);
    }
    std::ifstream file(said);
    return nlohmann::json::parse(file);
}

FrameFigures figures_of(int frame, std::array<metrics::Picture, 4> const& pictures, Reference const& reference) {
    FrameFigures figures{.frame = frame};
    figures.has_right = std::ranges::count(reference.right, 1) > 100;
    for (std::size_t m = 0; m < 3; ++m) {
        figures.error[m] = colour_error(pictures[m], reference.picture);
        if (figures.has_right) figures.right[m] = colour_error(pictures[m], reference.picture, reference.right);
        figures.windows[m] = window_errors(pictures[m], reference.picture);
    }
    return figures;
}

/// How much worse the default is than the better of the others.
double badness(FrameFigures const& figures) {
    return figures.error[by_default] / std::max(1e-9, std::min(figures.error[by_quick], figures.error[by_none]));
}

/// What files there are of a row, and what they are without noise.
struct Files {
    examples::FramePattern in;
    std::vector<long long> scored;
    std::string layer;
    std::function<Reference(int frame)> reference;
};

void run_files(Row& row, Files const& files, fs::path const& program, fs::path const& folder) {
    auto const& situation = *row.situation;
    auto const quick = folder / "quick", full = folder / "default";
    auto const summary = denoise(program, files.in.text(), full, situation.options + (situation.twin.empty() ? " --diagnose" : ""));
    summary.at("remarks").get_to(row.remarks), summary.at("findings").get_to(row.findings);
    static_cast<void>(denoise(program, files.in.text(), quick, situation.options + " --quick"));
    examples::FramePattern const of_quick((quick / frames).string()), of_full((full / frames).string());
    double worst = 0;
    for (auto const number : files.scored) {
        auto const frame = static_cast<int>(number);
        auto const reference = files.reference(frame);
        std::array<metrics::Picture, 4> pictures;
        for (std::size_t m = 0; auto const* const of : {&files.in, &of_quick, &of_full})
            pictures[m++] = picture_in(io::read_exr(of->path(frame)), files.layer);
        pictures[3] = reference.picture;
        row.frames.push_back(figures_of(frame, pictures, reference));
        if (double const bad = badness(row.frames.back()); bad > worst) worst = bad, row.shown = frame, row.pictures = std::move(pictures);
    }
}

} // namespace

Row run_row(Situation const& situation, Making const& making, References& references, fs::path const& program, fs::path const& folder) {
    Row row{.situation = &situation, .samples = making.samples};
    auto const in = folder / "in";
    fs::create_directories(in);
    Files files{examples::FramePattern((in / frames).string()), {}, picture_layer(situation.shot), [&](int frame) -> Reference {
                    return references.of(situation.shot, making, frame);
                }};
    for (int frame = 1; frame <= making.frames; ++frame)
        io::write_exr(files.in.path(frame), file_of(situation.shot, making, frame)), files.scored.push_back(frame);
    run_files(row, files, program, folder);
    return row;
}

Row run_sequence(Situation const& situation, fs::path const& sequence, fs::path const& program, fs::path const& folder) {
    constexpr auto name = "frame_%04d.exr";
    auto const scene = sequence.parent_path();
    Row row{.situation = &situation, .samples = situation.samples.front()};
    examples::FramePattern const references((scene / "reference" / name).string()), masks((scene / "broken" / name).string());
    Files files{examples::FramePattern((sequence / name).string()), {}, "", {}};
    for (auto const number : files.in.on_disk())
        if (fs::exists(references.path(number))) files.scored.push_back(number);
    if (files.scored.empty())
        throw Error(sequence.string(), "no frame of it has a reference", "put references into " + (scene / "reference").string());
    auto const layer_of = [](io::ExrImage const& image) { return image.find("ViewLayer.Combined.R") ? "ViewLayer.Combined." : ""; };
    files.layer = layer_of(io::read_exr(files.in.path(files.scored.front())));
    files.reference = [&](int frame) {
        auto const image = io::read_exr(references.path(frame));
        Reference reference{picture_in(image, layer_of(image)), {}};
        if (fs::exists(masks.path(frame))) {
            metrics::Mask broken;
            for (float const part : io::read_exr(masks.path(frame))["R"].values) broken.push_back(part > 0 ? 1 : 0);
            reference.right = away_from(broken, image.size, around_broken);
        }
        return reference;
    };
    run_files(row, files, program, folder);
    return row;
}

} // namespace quell::gauntlet

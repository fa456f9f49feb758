#include <gauntlet/frame_file.hpp>
#include <gauntlet/measures.hpp>
#include <gauntlet/row.hpp>

#include <quell/io/exr.hpp>
#include <support/frame_pattern.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace quell::gauntlet {

namespace {
namespace fs = std::filesystem;

std::string quoted(fs::path const& path) {
    std::string result = "'";
    for (char const c : path.string()) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}
fs::path file_in(fs::path const& folder, int frame) { return folder / examples::frame_file_name("frame", frame, "exr"); }

/// Runs quell-denoise. Returns its summary.
nlohmann::json denoise(fs::path const& program, fs::path const& in, fs::path const& out, std::string const& options) {
    fs::create_directories(out);
    auto const said = out / "summary.json", complaint = out / "errors.txt";
    auto const command = quoted(program) + " --json --quiet --threads 1 --layers picture --in " + quoted(in / "frame.%04d.exr") +
                         " --out " + quoted(out / "frame.%04d.exr") + ' ' + options + " > " + quoted(said) + " 2> " + quoted(complaint);
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

} // namespace

Row run_row(Situation const& situation, Making const& making, References& references, fs::path const& program, fs::path const& folder) {
    Row row{.situation = &situation, .samples = making.samples};
    auto const in = folder / "in", quick = folder / "quick", full = folder / "default";
    fs::create_directories(in);
    for (int frame = 1; frame <= making.frames; ++frame) io::write_exr(file_in(in, frame), file_of(situation.shot, making, frame));
    auto const summary = denoise(program, in, full, situation.options + (situation.twin.empty() ? " --diagnose" : ""));
    summary.at("remarks").get_to(row.remarks), summary.at("findings").get_to(row.findings);
    static_cast<void>(denoise(program, in, quick, situation.options + " --quick"));
    auto const layer = picture_layer(situation.shot);
    double worst = 0;
    for (int frame = 1; frame <= making.frames; ++frame) {
        auto const& reference = references.of(situation.shot, making, frame);
        std::array<metrics::Picture, 4> pictures;
        for (std::size_t m = 0; auto const* const of : {&in, &quick, &full})
            pictures[m++] = picture_in(io::read_exr(file_in(*of, frame)), layer);
        pictures[3] = reference.picture;
        row.frames.push_back(figures_of(frame, pictures, reference));
        if (double const bad = badness(row.frames.back()); bad > worst) worst = bad, row.shown = frame, row.pictures = std::move(pictures);
    }
    return row;
}

} // namespace quell::gauntlet

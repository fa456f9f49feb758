#include "external.hpp"

#include "../files.hpp"

#include <quell/io/exr.hpp>
#include <support/frame_pattern.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sys/wait.h>
#include <system_error>

namespace quell::bench {
namespace {

namespace fs = std::filesystem;
using examples::FramePattern;

fs::path fresh_folder() {
    // mkdtemp makes six letters X at the end into a name that nobody has.
    std::string name = (fs::temp_directory_path() / ("quell_chart_" + std::string(6, 'X'))).string();
    if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    return name;
}

FramePattern pattern_in(fs::path const& folder) { return FramePattern((folder / "frame.%04d.exr").string()); }

void replace_all(std::string& text, std::string const& what, std::string const& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}

std::string last_line_of(fs::path const& file) {
    std::ifstream in(file);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) last = line;
    return last;
}

std::string how_it_ended(int status) {
    if (WIFEXITED(status)) return "it ended with " + std::to_string(WEXITSTATUS(status));
    return "it ended by signal " + std::to_string(WTERMSIG(status));
}

/// What the program says of its own time, in the last line "milliseconds per frame: N" that it prints.
std::optional<double> said_milliseconds(fs::path const& file) {
    static std::string const words = "milliseconds per frame: ";
    std::ifstream in(file);
    std::optional<double> said;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(words)) continue;
        char* end = nullptr;
        double const number = std::strtod(line.c_str() + words.size(), &end);
        if (end != line.c_str() + words.size() && number > 0.) said = number;
    }
    return said;
}

std::string subject_of(External const& external) { return "--external '" + external.name + "'"; }

io::ExrImage image_in(fs::path const& file, External const& external) {
    static std::array<std::string, 3> const names{"R", "G", "B"};
    if (!fs::exists(file))
        throw Failure(subject_of(external), "it wrote no " + file.filename().string(), "let it write a file for each frame, to {out}");
    try {
        return io::ExrFile(file).read(names);
    } catch (Error const& error) {
        throw Failure(subject_of(external), "its " + file.filename().string() + " can't be read: " + error.found,
                      "let it write R, G and B");
    }
}

metrics::Picture picture_of(fs::path const& file, External const& external, Extent size) {
    auto const image = image_in(file, external);
    if (!(image.size == size))
        throw Failure(subject_of(external), "it wrote " + to_string(image.size) + " for frames of " + to_string(size),
                      "let it keep their size");
    return picture_in(image, "");
}

} // namespace

std::string filled_in(std::string command, std::string const& in, std::string const& out) {
    replace_all(command, "{in}", quoted(in));
    replace_all(command, "{out}", quoted(out));
    return command;
}

void check_differ(std::vector<External> const& externals, std::string const& method) {
    for (auto const& external : externals)
        if (file_name(external.name) == file_name(method))
            throw Error(subject_of(external), "it has the name of a method", "choose another");
}

ExternalRuns::~ExternalRuns() {
    std::error_code ignored; // a destructor has nobody to tell
    if (!folder.empty()) fs::remove_all(folder, ignored);
}

void ExternalRuns::write(int frame, io::ExrImage const& image) {
    if (folder.empty()) folder = fresh_folder();
    io::write_exr(pattern_in(folder).path(frame), image);
    ++frames;
}

double ExternalRuns::milliseconds_of(External const& external, fs::path const& out) const {
    auto const command = filled_in(external.command, pattern_in(folder).text(), pattern_in(out).text());
    auto const log = out / "log";
    auto const begin = std::chrono::steady_clock::now();
    int const status = std::system(("(" + command + "\n) > " + quoted(log.string()) + " 2>&1 < /dev/null").c_str());
    std::chrono::duration<double> const taken = std::chrono::steady_clock::now() - begin;
    if (status == 0) return said_milliseconds(log).value_or(1e3 * taken.count() / frames);
    auto const said = last_line_of(log);
    throw Failure(subject_of(external), how_it_ended(status) + (said.empty() ? "" : " and said '" + said + "'"),
                  "try it on frames of quell-trace first: " + external.command);
}

Row ExternalRuns::run(External const& external, Judge const& judge) {
    auto const out = folder / std::to_string(++runs); // not by its name: that is what somebody typed, and the folder is removed
    fs::create_directory(out);
    double const milliseconds = milliseconds_of(external, out);
    Entry entry{external.name};
    for (int const frame : judge.frames()) {
        auto const picture = picture_of(pattern_in(out).path(frame), external, judge.size());
        judge.measure(frame, std::span(&entry, 1), std::span(&picture, 1));
    }
    fs::remove_all(out);
    return judge.row_of(entry, milliseconds, Row::unknown);
}

} // namespace quell::bench

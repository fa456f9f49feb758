#pragma once

#include "../io/files.hpp"

#include <quell/frame/frame.hpp>
#include <quell/metrics/metric.hpp>

#include <random>
#include <sstream>
#include <sys/wait.h>

// Runs the programs as a user does.
namespace quell::tests {

/// What a program did.
struct Ran {
    int code = -1;
    std::string out, err;

    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> result;
        std::istringstream text(out);
        for (std::string line; std::getline(text, line);) result.push_back(line);
        return result;
    }
};

/// Runs a program with a line of arguments for the shell.
inline Ran run_program(std::string const& program, std::string const& arguments) {
    Folder const folder;
    auto const out = folder / "out", err = folder / "err";
    // What it caches goes with the folder, not into the user's home.
    int const status = std::system(("QUELL_CACHE='" + folder.path.string() + "' '" + program + "' " + arguments + " > '" + out.string() +
                                    "' 2> '" + err.string() + "'")
                                       .c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}
inline Ran denoise(std::string const& arguments) { return run_program(QUELL_DENOISE, arguments); }
inline Ran trace(std::string const& arguments) { return run_program(QUELL_TRACE, arguments); }

/// A metric in a line of the table that --reference prints.
inline double score_in(std::string const& line, metrics::MetricName metric) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; i < metric.place + 2; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
}

/// Checks that a program refused its arguments or its input in one line that says all of these.
inline void check_refused(Ran const& ran, std::initializer_list<std::string> parts) {
    INFO("stderr: ", ran.err);
    CHECK(ran.code == 2);
    CHECK(std::ranges::count(ran.err, '\n') == 1);
    for (auto const& part : parts) {
        INFO("part: ", part);
        CHECK(contains(ran.err, part));
    }
}

/// The channels that the presets of quell-denoise read.
using DenoiseFrame = Frame<Channels<Radiance, Albedo, Normal, Depth, Motion>>;

/// A noisy frame of a textured plane that moves to the right by a pixel a frame.
inline io::ExrImage noisy_image(Extent size, int number) {
    Frame<Channels<Radiance, Albedo, Normal, Depth, Motion, MotionNext>> frame(size);
    std::mt19937 random(static_cast<unsigned>(number));
    std::exponential_distribution<float> light(1.f);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const texture = ((x - number + 1000) / 4 + y / 4) % 2 == 0 ? 0.8f : 0.3f;
            frame[albedo].set(x, y, glm::vec3(texture));
            frame[radiance].set(x, y, glm::vec3(texture * light(random)));
            frame[normal].set(x, y, {0.f, 0.f, 1.f});
            frame[depth].set(x, y, 5.f);
            frame[motion].set(x, y, {-1.f, 0.f});
            frame[motion_next].set(x, y, {1.f, 0.f});
        }
    return io::image_of(frame);
}

inline std::string numbered(std::string const& before, int number) {
    auto const digits = std::to_string(number);
    return before + std::string(4 - std::min<std::size_t>(digits.size(), 4), '0') + digits + ".exr";
}

/// Writes frames first..last of such a sequence as frame.0000.exr and so on.
inline void write_sequence(Folder const& folder, int first, int last, Extent size = {48, 32}) {
    for (int i = first; i <= last; ++i) io::write_exr(folder / numbered("frame.", i), noisy_image(size, i));
}
inline std::string input(Folder const& folder) { return "--in '" + (folder / "frame.%04d.exr").string() + "' "; }
inline std::string output(Folder const& folder, std::string const& name = "out.") {
    return "--out '" + (folder / (name + "%04d.exr")).string() + "' ";
}

} // namespace quell::tests

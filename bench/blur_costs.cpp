// What motion blur costs, by what moves: processor time of one thread on made-up frames, against `svgf` on the same ones, and against the
// same preset on the first case, in which everything moves. A table in Markdown.
//
//   quell-blur-costs --size 1280x720 --rounds 5
//
// Cases are measured in turn, round by round, and the least of each counts: what else runs on the machine only ever adds.

#include "timed.hpp"

#include <quell/presets/blur.hpp>
#include <quell/quell.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace quell;
using bench::Seconds;

using Input = Frame<Channels<Radiance, Depth, Normal, Motion, Sweep, Time>>;
constexpr float shutter = 0.5f;
constexpr int frames = 4;

/// How what is there moves: by a sweep in pixels that is the same everywhere, or turning about the middle.
struct Case {
    std::string name;
    float length = 16, degrees = 30;
    float part = 1;         ///< of the image's width, what moves
    float turn = 0;         ///< radians while the shutter is open
    float of_behind = 0.4f; ///< the part of that motion that what is behind has
    glm::vec2 sweep() const { return glm::vec2(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees))) * length; }
};

/// What a sample shows: discs before a checkered wall, both of which move.
class World {
public:
    World(Case const& what_, Extent size_) : what(what_), size(size_), middle(0.5f * glm::vec2(size_.width, size_.height)) {}

    /// What the sample of a pixel at time t of a frame's open shutter shows.
    void put(Input& frame, int x, int y, int number, float t) const {
        glm::vec2 const p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        float const now = (static_cast<float>(number) + shutter * t) / shutter; // in sweeps
        bool const moves = p.x < what.part * static_cast<float>(size.width);
        bool const front = moves && on_disc(back_then(p, 1, now));
        float const speed = !moves ? 0.f : front ? 1.f : what.of_behind;
        bool const light = checkered(back_then(p, speed, now), front ? 5.f : 23.f);
        glm::vec2 const way = speed > 0 ? displaced(p, speed, 1 - t) - displaced(p, speed, -t) : glm::vec2(0.f);
        frame[radiance].set(x, y, front ? glm::vec3(light ? 0.9f : 0.5f, 0.3f, 0.2f) : glm::vec3(0.2f, light ? 0.6f : 0.3f, 0.4f));
        frame[depth].set(x, y, front ? 4.f : 10.f);
        frame[normal].set(x, y, {0.f, 0.f, -1.f});
        frame[quell::sweep].set(x, y, way);
        frame[quell::time].set(x, y, t);
        frame[motion].set(x, y, -way / shutter);
    }

private:
    Case what;
    Extent size;
    glm::vec2 middle;

    /// Where what is at p is after a time in sweeps.
    [[nodiscard]] glm::vec2 displaced(glm::vec2 p, float speed, float by) const {
        if (what.turn == 0) return p + what.sweep() * (speed * by);
        float const angle = what.turn * speed * by, c = std::cos(angle), s = std::sin(angle);
        auto const q = p - middle;
        return middle + glm::vec2(q.x * c - q.y * s, q.x * s + q.y * c);
    }
    [[nodiscard]] glm::vec2 back_then(glm::vec2 p, float speed, float now) const { return displaced(p, speed, -now); }
    static bool on_disc(glm::vec2 p) {
        constexpr float apart = 96, radius = 28;
        return glm::length(p - (glm::floor(p / apart) + 0.5f) * apart) < radius;
    }
    static bool checkered(glm::vec2 p, float field) {
        return (static_cast<int>(std::floor(p.x / field)) + static_cast<int>(std::floor(p.y / field))) % 2 == 0;
    }
};

std::vector<Input> frames_of(Case const& what, Extent size) {
    std::vector<Input> made;
    World const world(what, size);
    for (int number = 0; number < frames; ++number) {
        Input& frame = made.emplace_back(size);
        std::minstd_rand random(static_cast<unsigned>(number) + 1);
        std::uniform_real_distribution<float> uniform(0.f, 1.f);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) world.put(frame, x, y, number, uniform(random));
    }
    return made;
}

/// A preset at work on one case after the other.
struct Preset {
    std::string name;
    /// Milliseconds of the last of some frames that follow each other.
    std::function<double(std::vector<Input> const&)> run;
};

template <class Make> Preset preset(std::string name, Make) {
    return {std::move(name), [](std::vector<Input> const& input) {
                constexpr auto pipeline = Make{}();
                History history{input.front().size, pipeline};
                Seconds taken;
                for (auto const& frame : input) {
                    auto const before = Seconds::now();
                    quell::run(pipeline, frame, history, Simd{});
                    taken = Seconds::now() - before;
                }
                return 1e3 * taken.processor;
            }};
}

std::vector<Case> cases() {
    std::vector<Case> all{{.name = "16 px, 30 degrees, all of it"},
                          {.name = "nothing moves", .part = 0},
                          {.name = "a quarter of the image", .part = 0.25f},
                          {.name = "only what is in front", .of_behind = 0}};
    for (int const degrees : {0, 15, 45, 60, 90, 150})
        all.push_back({.name = std::to_string(degrees) + " degrees", .degrees = static_cast<float>(degrees)});
    for (int const length : {2, 4, 8, 32, 64, 128})
        all.push_back({.name = std::to_string(length) + " px", .length = static_cast<float>(length)});
    all.push_back({.name = "turns by 3 degrees", .turn = glm::radians(3.f)});
    return all;
}

void print_costs(Extent size, int rounds) {
    std::vector<Preset> const presets{
        preset("svgf", [] { return quell::presets::svgf(radiance); }),
        preset("blur-straight", [] { return quell::presets::blur<StraightTrajectories>(radiance); }),
        preset("blur", [] { return quell::presets::blur(radiance); }),
    };
    auto const all = cases();
    std::vector<std::vector<double>> least(all.size(), std::vector<double>(presets.size(), std::numeric_limits<double>::infinity()));
    for (int round = 0; round < rounds; ++round)
        for (std::size_t c = 0; c < all.size(); ++c) {
            auto const input = frames_of(all[c], size);
            for (std::size_t p = 0; p < presets.size(); ++p) least[c][p] = std::min(least[c][p], presets[p].run(input));
        }
    std::printf("| %s | svgf ms | blur-straight ms | over svgf | of the first | blur ms | over svgf | of the first |\n"
                "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
                to_string(size).c_str());
    for (std::size_t c = 0; c < all.size(); ++c) {
        std::printf("| %s | %.1f |", all[c].name.c_str(), least[c][0]);
        for (std::size_t p = 1; p < presets.size(); ++p)
            std::printf(" %.1f | %.2f | %.2f |", least[c][p], least[c][p] / least[c][0], least[c][p] / least[0][p]);
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    return examples::exit_code_of("quell-blur-costs", [&] {
        std::string size = "1280x720";
        int rounds = 5;
        CLI::App app("What motion blur costs, by what moves.", "quell-blur-costs");
        app.add_option("--size", size, "width x height in pixels")->capture_default_str();
        app.add_option("--rounds", rounds, "how often each case is measured; the least counts")
            ->check(CLI::Range(1, 1000))
            ->capture_default_str();
        if (examples::parse(app, argc, argv)) print_costs(examples::size_in(size), rounds);
    });
}

#include "host_mistakes.hpp"

#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>

#include <iostream>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr int count = 7; ///< frames of a take

void shoot(Take& take, Shot shot) {
    for (int i = 0; i < count; ++i) {
        shot.seed.reset();
        fill_well(take.good.emplace_back(shot.size, denoise), shot, i);
        shot.seed = 1;
        fill_well(take.one_seed.emplace_back(shot.size, denoise), shot, i);
    }
}
Take shot(std::string name, Shot const& how) {
    Take take{std::move(name), {}, {}};
    shoot(take, how);
    return take;
}
Take traced(std::string const& scene, tracer::Jitter jitter = tracer::Jitter::none) {
    Take take{scene, {}, {}};
    tracer::PreparedScene prepared(tracer::built_in_scene(scene));
    constexpr Extent size{96, 54};
    for (int number = 20; number < 20 + count; ++number) {
        tracer::RenderSettings settings{.frame = number, .threads = 1, .jitter = jitter};
        tracer::trace_frame(prepared, settings, take.good.emplace_back(size, denoise));
        settings.first_sample = -number;
        tracer::trace_frame(prepared, settings, take.one_seed.emplace_back(size, denoise));
    }
    return take;
}

std::vector<Take> takes() {
    constexpr Extent size{128, 72};
    std::vector<Take> all;
    all.push_back(shot("hall", {.jitters = false, .size = size}));
    all.push_back(shot("hall, jittered", {.size = size}));
    all.push_back(shot("hall, still", {.moves = false, .jitters = false, .size = size}));
    all.push_back(shot("yard", {.jitters = false, .size = size, .place = Place::yard, .pitch = 0.4f}));
    for (auto const* const name : {"room", "temple", "fence"}) all.push_back(traced(name));
    return all;
}

std::vector<Finding> said_of(HostMistake const* mistake, Take const& take) {
    GoodFrame frame(take.size(), denoise);
    History history{take.size(), denoise};
    std::vector<Finding> all;
    for (std::size_t i = 1; i < take.good.size(); ++i) {
        copy_frame(take.good[i], frame);
        if (mistake) mistake->make(frame, take, i);
        for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
        run(denoise, frame, history, Serial{});
    }
    return all;
}

} // namespace

TEST_CASE("the table") {
    auto const scenes = takes();
    auto const all = host_mistakes();
    for (auto const& take : scenes) {
        std::cout << take.scene << std::endl;
        for (auto const& finding : said_of(nullptr, take)) std::cout << "FALSE " << take.scene << ": " << to_string(finding) << "\n";
    }
    if (std::getenv("EDGES")) return;
    int named = 0;
    for (auto const& mistake : all) {
        std::cout << mistake.name << ":\n";
        bool anywhere = false, wrong = false;
        for (auto const& take : scenes) {
            auto const found = said_of(&mistake, take);
            auto const said = mistakes(found);
            bool right = !said.empty(), bad = false;
            for (auto const& finding : found)
                for (auto const other : finding.or_else)
                    if (mistake.right.contains(other)) right = false, bad = false;
            for (auto const one : said) right = right && mistake.right.contains(one), bad = bad || !mistake.right.contains(one);
            std::cout << "    " << take.scene << ": " << (right ? "ok" : bad ? "WRONG" : "-");
            if (bad || std::getenv("ALL"))
                for (auto const one : said) std::cout << " [" << name_of(one) << "]";
            if (bad && std::getenv("ALL") && !found.empty()) std::cout << "   " << to_string(found[0]);
            std::cout << "\n";
            anywhere = anywhere || right, wrong = wrong || bad;
        }
        named += anywhere && !wrong;
    }
    std::cout << named << " of " << all.size() << std::endl;
}

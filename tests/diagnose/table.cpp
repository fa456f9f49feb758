#include "foreign_host.hpp"

#include <quell/presets/effects.hpp>

#include <tracer/scenes/scenes.hpp>
#include <tracer/trace_frame.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr int count = 7; ///< frames of a take

constexpr Extent size{192, 108};

/// Frames of the foreign host, which has its own mistakes made in them. After the first four the other camera comes in.
Take hosted(std::string name, ForeignShot shot, Path other) {
    Take take{std::move(name), {}, {}};
    for (int i = 0; i < count; ++i) {
        shot.one_seed = false;
        take.places.push_back(render(take.good.emplace_back(size, denoise), shot, i));
        auto elsewhere = shot;
        elsewhere.path = other;
        take.elsewhere.emplace_back(size, denoise);
        if (i >= 4) render(take.elsewhere.back(), elsewhere, 40 + i);
        take.elsewhere.back().number = i;
        shot.one_seed = true;
        render(take.one_seed.emplace_back(size, denoise), shot, i);
    }
    return take;
}
Take traced(std::string const& scene) {
    Take take{scene, {}, {}};
    tracer::PreparedScene prepared(tracer::built_in_scene(scene));
    for (int number = 20; number < 20 + count; ++number) {
        tracer::RenderSettings settings{.frame = number, .threads = 1};
        tracer::trace_frame(prepared, settings, take.good.emplace_back(Extent{96, 54}, denoise));
        settings.first_sample = -number;
        tracer::trace_frame(prepared, settings, take.one_seed.emplace_back(Extent{96, 54}, denoise));
    }
    return take;
}

std::vector<Take> takes() {
    std::vector<Take> all;
    for (auto const guides : {GuidesOf::centre, GuidesOf::materials, GuidesOf::sample}) {
        all.push_back(hosted(std::string(name_of(guides)) + ", dolly", {Set::studio, Path::jittered, guides, size}, Path::orbit));
        all.push_back(hosted(std::string(name_of(guides)) + ", orbit", {Set::plaza, Path::orbit, guides, size}, Path::pan));
    }
    all.push_back(traced("fence"));
    return all;
}

/// What is said of a take, all frames, with a mistake or none.
/// @param divides whether the host divides the signal by albedo itself, and multiplies the output by it
std::vector<Finding> said_of(HostMistake const* mistake, Take const& take, bool divides) {
    GoodFrame frame(take.size(), denoise);
    History history{take.size(), denoise};
    std::vector<Finding> all;
    for (std::size_t i = 1; i < take.good.size(); ++i) {
        copy_frame(take.good[i], frame);
        if (divides) divide_by_albedo(frame), each(frame, albedo, [](glm::vec3) { return glm::vec3(1.f); });
        if (mistake) mistake->make(frame, take, i);
        auto const factor = [&](int c, int x, int y) { return take.good[i][albedo].get(x, y)[c]; };
        for (auto& finding : divides ? diagnose(frame, history, {}, factor) : diagnose(frame, history)) all.push_back(std::move(finding));
        run(denoise, frame, history, Serial{});
    }
    return all;
}

/// Whether the mistake is the first that each finding names, or one of those between which it leaves the choice.
enum class Verdict { silent, named, either, misnamed };
Verdict verdict_on(std::vector<Finding> const& found, std::set<Mistake> const& right) {
    auto verdict = Verdict::silent;
    for (auto const& finding : found) {
        bool const among = std::ranges::any_of(finding.or_else, [&](Mistake other) { return right.contains(other); });
        auto const one = right.contains(finding.mistake) ? Verdict::named : among ? Verdict::either : Verdict::misnamed;
        verdict = std::max(verdict, one);
    }
    return verdict;
}
std::string cell_of(Verdict verdict) { return verdict == Verdict::named ? "named" : verdict == Verdict::either ? "either" : "-"; }

/// What a mistake is called in a take. No finding of it may have a wrong name.
std::string cell_of(HostMistake const& mistake, Take const& take, std::set<std::string>& said) {
    auto const found = said_of(&mistake, take, mistake.divides);
    auto const verdict = verdict_on(found, mistake.right);
    std::string text;
    for (auto const& finding : found) text += to_string(finding) + "\n";
    INFO(mistake.name, " in ", take.scene, ": ", text);
    CHECK(verdict != Verdict::misnamed);
    for (auto const& finding : found)
        if (mistake.right.contains(finding.mistake)) said.insert(std::string(name_of(finding.mistake)));
    return cell_of(verdict);
}
std::string row_of(HostMistake const& mistake, std::vector<Take> const& takes) {
    std::set<std::string> said;
    std::string cells, names;
    for (auto const& take : takes) cells += " " + cell_of(mistake, take, said) + " |";
    for (auto const& name : said) names += (names.empty() ? "" : "; ") + name;
    return "| " + mistake.name + " | " + names + " |" + cells + "\n";
}
std::string table_of(std::vector<HostMistake> const& all, std::vector<Take> const& takes) {
    std::string table = "| mistake | what is said |", rule = "| --- | --- |";
    for (auto const& take : takes) table += " " + take.scene + " |", rule += " --- |";
    table += "\n" + rule + "\n";
    for (auto const& mistake : all) table += row_of(mistake, takes);
    return table;
}
std::string page() {
    std::ifstream file(QUELL_DOCS "/host_mistakes.md");
    return {std::istreambuf_iterator<char>(file), {}};
}
/// A cell of the page's table.
std::string written_cell(std::string const& text, std::string const& mistake, std::size_t column) {
    auto at = text.find("| " + mistake + " |");
    for (std::size_t i = 0; i < column + 2 && at != std::string::npos; ++i) at = text.find('|', at + 1);
    if (at == std::string::npos) return "no such row";
    return text.substr(at + 2, text.find(" |", at + 1) - at - 2);
}

} // namespace

// QUELL_DIAGNOSE_TABLE=1 tries each mistake in each column, and writes the table where it is another.
TEST_CASE("mistakes are named and none is misnamed, as the table in docs/host_mistakes.md says") {
    auto const scenes = takes();
    auto const all = host_mistakes();
    for (auto const& take : scenes)
        for (bool const divides : {false, true}) {
            auto const found = said_of(nullptr, take, divides);
            INFO(take.scene, ": ", found.empty() ? std::string() : to_string(found[0]));
            CHECK(found.empty());
        }
    if (std::getenv("QUELL_DIAGNOSE_TABLE")) {
        auto const table = table_of(all, scenes);
        bool const is_written = page().find(table) != std::string::npos;
        if (!is_written) std::ofstream("host_mistakes_table.md") << table;
        INFO("docs/host_mistakes.md has another table; the right one is now in host_mistakes_table.md, where the test ran");
        CHECK(is_written);
        return;
    }
    std::set<std::string> said;
    for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(all[i].name, " in ", scenes[i % scenes.size()].scene);
        CHECK(cell_of(all[i], scenes[i % scenes.size()], said) == written_cell(page(), all[i].name, i % scenes.size()));
    }
}

// QUELL_DIAGNOSE_FRAMES=67 makes it more than 1,000 frames of each kind of guides.
TEST_CASE("nothing is said of correct frames of a foreign host, whatever its guides are of") {
    auto const* const asked = std::getenv("QUELL_DIAGNOSE_FRAMES");
    int const frames = asked ? std::atoi(asked) : 3;
    for (auto const guides : {GuidesOf::centre, GuidesOf::materials, GuidesOf::sample})
        for (auto const set : {Set::studio, Set::plaza, Set::terrace})
            for (auto const path : {Path::dolly, Path::orbit, Path::pan, Path::still, Path::jittered}) {
                // A third of them is enough for every build.
                if (!asked && (static_cast<int>(guides) + static_cast<int>(set) + static_cast<int>(path)) % 3 != 0) continue;
                ForeignShot const shot{set, path, guides, {160, 90}};
                GoodFrame frame(shot.size, denoise);
                History history{shot.size, denoise};
                std::vector<Finding> all;
                for (int i = 0; i < frames; ++i) {
                    render(frame, shot, i);
                    for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
                    run(denoise, frame, history, Serial{});
                }
                INFO(name_of(guides), " set ", static_cast<int>(set), " path ", static_cast<int>(path));
                check_found(all, {});
            }
}

TEST_CASE("zeros in place of a shadow's positions are named") {
    constexpr auto shadows = presets::shadow(visibility);
    for (auto const* const scene : {"fence", "pinkroom"})
        for (int wrong = 0; wrong < 3; ++wrong) {
            tracer::PreparedScene prepared(tracer::built_in_scene(scene));
            Frame frame{{64, 36}, shadows};
            History history{frame.size, shadows};
            std::vector<Finding> all;
            for (int number = 20; number < 23; ++number) {
                tracer::trace_frame(prepared, {.frame = number, .threads = 1}, frame);
                if (wrong == 1) each(frame, light_previous, [](glm::vec3) { return glm::vec3(0.f); });
                if (wrong == 2) each(frame, blocker, [](glm::vec3 p) { return all_finite(p) ? p : glm::vec3(0.f); });
                for (auto& finding : diagnose(frame, history)) all.push_back(std::move(finding));
                run(shadows, frame, history, Serial{});
            }
            INFO(scene);
            check_found(all, wrong == 0 ? std::set<Mistake>{} : std::set{wrong == 1 ? Mistake::positions_zero : Mistake::hits_zero});
        }
}

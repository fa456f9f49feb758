#include <doctest/doctest.h>

#include <gauntlet/limits.hpp>
#include <gauntlet/measures.hpp>

using namespace quell;
using namespace quell::gauntlet;

namespace {

metrics::Picture flat(Extent size, float value) {
    return {size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()), glm::vec3(value))};
}

/// A row of one frame with these errors everywhere.
Row row_of(Situation const& situation, int samples, double input, double quick, double full) {
    Row row{.situation = &situation, .samples = samples};
    FrameFigures frame{.frame = 3, .error = {input, quick, full}, .right = {input, quick, full}, .has_right = true};
    for (std::size_t m = 0; m < 3; ++m) frame.windows[m] = std::vector<double>(20, frame.error[m]);
    row.frames.push_back(frame);
    return row;
}

} // namespace

TEST_CASE("the error is the root of the mean square over pixels and components") {
    auto const zero = flat({4, 2}, 0.f);
    auto picture = zero;
    picture.pixels[1] = {0.6f, 0.f, 0.f};
    CHECK(colour_error(picture, zero) == doctest::Approx(std::sqrt(0.36 / 24)));
    metrics::Mask mask(8, 0);
    mask[1] = mask[2] = 1;
    CHECK(colour_error(picture, zero, mask) == doctest::Approx(std::sqrt(0.36 / 6)));
    CHECK(colour_error(picture, zero, metrics::Mask(8, 0)) == 0);
}

TEST_CASE("windows are of 25x25 pixels, every fifth one") {
    Extent const size{36, 31};
    auto const zero = flat(size, 0.f);
    auto picture = zero;
    picture.pixels[static_cast<std::size_t>(3 * size.width + 2)] = glm::vec3(1.f); // in the first window alone
    auto const windows = window_errors(picture, zero);
    REQUIRE(windows.size() == 3 * 2);
    CHECK(windows[0] == doctest::Approx(1. / 25));
    for (std::size_t i = 1; i < windows.size(); ++i) CHECK(windows[i] == 0);
}

TEST_CASE("what lies away from a mask") {
    metrics::Mask mask(7 * 7, 0);
    mask[3 * 7 + 3] = 1;
    auto const away = away_from(mask, {7, 7}, 2);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 7; ++x)
            CHECK(away[static_cast<std::size_t>(y * 7 + x)] == (std::max(std::abs(x - 3), std::abs(y - 3)) > 2 ? 1 : 0));
}

TEST_CASE("packed numbers come back within a thousandth or two") {
    std::vector<double> const numbers{1e-4, 0.0019, 0.0021, 0.05, 0.3, 1.};
    auto const back = unpacked(packed(numbers));
    REQUIRE(back.size() == numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(back[i] == doctest::Approx(numbers[i]).epsilon(0.002));
}

TEST_CASE("limits: over --quick, over the input, windows and the right part") {
    Situation const situation{.name = "s", .about = "nothing", .shot = {}};
    StoredFigures before;
    before.add("s", 4, 3, {.input = 0.1, .quick = 0.05, .full = 0.04, .right = 0.04, .windows = std::vector<double>(20, 0.05)});
    auto const broken = [&](double full) { return verdict_on(row_of(situation, 4, 0.1, 0.3, full), before).broken; };
    CHECK(broken(0.041).empty());      // --quick is the earlier program's
    CHECK(broken(0.0415).size() == 1); // the right part
    CHECK(broken(0.0515).size() == 2); // and --quick
    CHECK(broken(0.11).size() == 4);   // the input, and windows
    CHECK(broken(0.0019).empty());
    // Of 64 samples, where --quick is above the input, that alone is the limit.
    StoredFigures const none;
    CHECK(verdict_on(row_of(situation, 16, 0.02, 0.03, 0.025), none).broken.size() == 1);
    CHECK(verdict_on(row_of(situation, 64, 0.02, 0.03, 0.025), none).broken.empty());
    CHECK(verdict_on(row_of(situation, 64, 0.02, 0.03, 0.031), none).broken.size() == 1);
}

TEST_CASE("97 of 100 windows of all rows of a number of samples") {
    Situation const situation{.name = "s", .about = "nothing", .shot = {}};
    StoredFigures const none;
    std::vector<Row> rows{row_of(situation, 4, 0.1, 0.05, 0.05), row_of(situation, 4, 0.1, 0.05, 0.05)};
    auto const judged = [&] {
        std::vector<Verdict> verdicts;
        for (auto const& row : rows) verdicts.push_back(verdict_on(row, none));
        return broken_together(rows, verdicts).size();
    };
    CHECK(judged() == 0);
    rows[0].frames[0].windows[by_default][0] = 0.053; // 1 of 40
    CHECK(judged() == 0);
    rows[1].frames[0].windows[by_default][0] = 0.053; // 2 of 40
    CHECK(judged() == 1);
}

#include "chart_in.hpp"
#include "small_chart.hpp"

#include <quell/core/error.hpp>

#include <doctest/doctest.h>

#include <cstdlib>

using namespace quell::bench;
using quell::tests::bytes_of;
using quell::tests::Folder;

namespace {

/// All but what depends on the clock.
void forget_times(std::map<std::string, Cells>& rows) {
    for (auto& [method, row] : rows) row.erase("ms_per_frame"), row.erase("pareto");
}

void check_refused(ChartOptions const& options, std::string const& part, std::string const& external = "other") {
    try {
        chart_small(options);
        FAIL("nothing was thrown");
    } catch (quell::Error const& error) {
        INFO("message: ", error.what());
        CHECK(std::string(error.what()).find(part) != std::string::npos);
        CHECK(std::string(error.what()).find("--external '" + external + "'") == 0);
    }
}

/// Lets the noisy frames through as they are.
constexpr auto copy_frames = "for f in $(dirname {in})/*.exr; do cp $f $(dirname {out}); done";

} // namespace

TEST_CASE("a run writes table, plot, page and pictures, and the next one has every error the same to the last digit") {
    Folder const first, second;
    chart_small(small_options(first.path));
    auto by_one_thread = small_options(second.path);
    by_one_thread.threads = 1;
    chart_small(by_one_thread);
    auto one = chart_in(first.path), other = chart_in(second.path);
    CHECK(one.size() == 3);
    for (auto const* column : {"rmse", "ssim", "flip", "flip_median", "mask_rmse", "mask_ssim", "mask_flip", "bytes_per_pixel"})
        CHECK(std::stod(one["surface"][column]) > 0);
    CHECK(one["surface"]["flicker"].empty()); // two scored frames, but one of 31 to 34
    CHECK(std::stod(one["surface"]["ms_per_frame"]) > 0);
    CHECK(one["none"]["threads"] == "2");
    CHECK(other["none"]["threads"] == "1");
    forget_times(one), forget_times(other);
    for (auto& [method, row] : other) row["threads"] = "2";
    CHECK(one == other);
    for (auto const* file : {"index.html", "pictures/fence-shadow/surface.png", "pictures/fence-shadow/reference.png"})
        CHECK(std::filesystem::file_size(first / file) > 0);
    CHECK(bytes_of(first / "pictures/fence-shadow/surface.png") == bytes_of(second / "pictures/fence-shadow/surface.png"));
}

TEST_CASE("another seed is another noise") {
    Folder const folder;
    chart_small(small_options(folder.path));
    auto const usual = chart_in(folder.path);
    chart_small(small_options(folder.path, {"--seed", "7"}));
    CHECK(chart_in(folder.path).at("none").at("rmse") != usual.at("none").at("rmse"));
}

TEST_CASE("another program's output is measured as a method's") {
    Folder const folder;
    // Frames go through as they are; R, G, B are the noisy share, in half precision.
    chart_small(small_options(folder.path, {"--external", std::string("copy=") + copy_frames}));
    auto rows = chart_in(folder.path);
    CHECK(std::stod(rows["copy"]["rmse"]) == doctest::Approx(std::stod(rows["none"]["rmse"])).epsilon(0.01));
    CHECK(std::stod(rows["copy"]["ms_per_frame"]) > 0);
    CHECK(rows["copy"]["bytes_per_pixel"].empty());
}

TEST_CASE("another program's time is what it says, or that of its run") {
    Folder const folder;
    auto const milliseconds = [&](std::string const& said) {
        chart_small(small_options(folder.path, {"--external", std::string("copy=") + copy_frames + said}));
        return std::stod(chart_in(folder.path)["copy"]["ms_per_frame"]);
    };
    CHECK(milliseconds("; echo 'milliseconds per frame: 1234.5'; echo done") == doctest::Approx(1234.5));
    CHECK(milliseconds("; echo 'milliseconds per frame: 9'; echo 'milliseconds per frame: 2345'") == doctest::Approx(2345));
    CHECK(milliseconds("; echo 'milliseconds per frame: few'; echo 'it took milliseconds per frame: 3456'") != doctest::Approx(3456));
}

TEST_CASE("another program that fails is named with what it said last, and so is one that writes nothing") {
    Folder const folder;
    auto const run = [&](std::string const& command) { return small_options(folder.path, {"--external", "other=" + command}); };
    check_refused(run("echo {in} {out}; echo no such filter >&2; exit 3"), "ended with 3 and said 'no such filter'");
    check_refused(run("kill -9 $$ {in} {out}"), "signal 9");
    check_refused(run("true {in} {out}"), "it wrote no frame.0024.exr");
    check_refused(run("for f in {in}; do echo broken > $(dirname {out})/frame.0024.exr; done"), "frame.0024.exr");
}

TEST_CASE("what was charted before another program failed is kept") {
    Folder const folder;
    auto const options =
        small_options(folder.path, {"--external", std::string("copy=") + copy_frames, "--external", "other=false {in} {out}"});
    check_refused(options, "ended with 1");
    auto const rows = chart_in(folder.path);
    CHECK(rows.size() == 4);
    CHECK(rows.count("surface") == 1);
    CHECK(rows.count("copy") == 1);
}

TEST_CASE("another program has no method's name") {
    Folder const folder;
    check_refused(small_options(folder.path, {"--external", std::string("surface=") + copy_frames}), "the name of a method", "surface");
    CHECK(!std::filesystem::exists(folder / "pictures"));
}

TEST_CASE("another program's name is no path") {
    Folder const folder, temporary;
    quell::tests::write_bytes(temporary / "kept", "somebody's");
    char const* const usual = std::getenv("TMPDIR");
    ::setenv("TMPDIR", temporary.path.c_str(), 1);
    auto options = small_options(folder.path);
    options.externals = {{"..", copy_frames}}; // which the command line refuses
    chart_small(options);
    usual ? ::setenv("TMPDIR", usual, 1) : ::unsetenv("TMPDIR");
    CHECK(std::filesystem::exists(temporary / "kept"));
    CHECK(temporary.files() == 1); // nothing else is left there
}

TEST_CASE("where only times are wanted no reference is made: there is the table, without errors, and nothing else") {
    Folder const folder;
    auto options = small_options(folder.path);
    options.times = true;
    options.frames = 10;
    chart_small(options);
    auto rows = chart_in(folder.path);
    CHECK(std::stod(rows["surface"]["ms_per_frame"]) > 0);
    CHECK(std::stod(rows["surface"]["bytes_per_pixel"]) > 0);
    CHECK(rows["surface"]["rmse"].empty());
    CHECK(rows["input"]["ms_per_frame"].empty()); // it runs in scored frames only
    CHECK(rows["surface"]["pareto"] == "0");
    CHECK(!std::filesystem::exists(folder / "index.html"));
}

#include "fit/options.hpp"

#include <quell/core/error.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace quell::bench;

namespace {

FitOptions parsed(std::vector<char const*> words) {
    words.insert(words.begin(), "quell-fit");
    return fit_options(static_cast<int>(words.size()), words.data());
}
void check_refused(std::vector<char const*> const& words, std::string const& part) {
    try {
        static_cast<void>(parsed(words));
        FAIL("no error");
    } catch (quell::Error const& error) {
        INFO("message: ", error.what());
        CHECK(std::string(error.what()).find(part) != std::string::npos);
    }
}

} // namespace

TEST_CASE("a scene or files, and a bound") {
    auto const o = parsed({"--scene", "fence", "--rmse", "0.05", "--ms", "20", "--size", "64x32", "--threads", "3"});
    CHECK(o.scene == "fence");
    CHECK(*o.bounds.rmse == 0.05);
    CHECK(*o.bounds.ms == 20);
    CHECK_FALSE(o.bounds.flip);
    CHECK(o.size == quell::Extent{64, 32});
    CHECK(o.threads == 3);
    CHECK(parsed({"--in", "a.%04d.exr", "--reference", "r.%04d.exr", "--flip", "0.1"}).threads > 0);
}

TEST_CASE("command lines that can't be used are refused with what to do") {
    check_refused({"--rmse", "0.05"}, "neither --scene nor --in");
    check_refused({"--scene", "fence"}, "no bound");
    check_refused({"--scene", "fence", "--in", "a.%04d.exr", "--rmse", "1"}, "both");
    check_refused({"--in", "a.%04d.exr", "--rmse", "0.1"}, "--reference is missing");
    check_refused({"--in", "a.%04d.exr", "--reference", "r.%04d.exr", "--rmse", "0.1", "--size", "8x8"}, "--size");
    check_refused({"--in", "a.%04d.exr", "--reference", "r.%04d.exr", "--rmse", "0.1", "--blur"}, "--blur");
    check_refused({"--scene", "fence", "--rmse", "0"}, "--rmse");
    check_refused({"--scene", "fence", "--ms", "-3"}, "--ms");
    check_refused({"--scene", "fence", "--rmse", "0.1", "--size", "64"}, "'64'");
    check_refused({"--scene", "fence", "--rmse", "0.1", "--size", "99999x99999"}, "at most");
    check_refused({"--scene", "fence", "--rmse", "0.1", "--frames", "24"}, "--frames");
    check_refused({"--scene", "fence", "--rmse", "0.1", "--threads", "70000"}, "--threads");
}

#include "programs.hpp"

#include <denoise/isa_choice.hpp>

using namespace quell::tests;
using quell_isa::choose_isa;

TEST_CASE("the best code that the machine runs is chosen, or the one that is asked for") {
    std::vector<quell_isa::Isa> const built{{"x86-64-v4", false}, {"x86-64-v3", true}, {"x86-64", true}};
    CHECK(choose_isa(built, {"quell-denoise", "--in", "a"}).name == "x86-64-v3");
    CHECK(choose_isa(built, {"quell-denoise", "--isa", "x86-64", "--in", "a"}).name == "x86-64");
    CHECK(choose_isa(built, {"quell-denoise", "--isa=x86-64"}).name == "x86-64");
    CHECK(choose_isa(built, {"quell-denoise", "--isa=x86-64", "--isa", "x86-64-v3"}).name == "x86-64-v3");
    for (auto const* const name : {"", "x86", "neon"}) {
        auto const choice = choose_isa(built, {"quell-denoise", "--isa", name});
        CHECK(choice.name.empty());
        CHECK(choice.error == "--isa: this program has no code for '" + std::string(name) + "'; choose one of: x86-64-v3, x86-64");
    }
    CHECK(contains(choose_isa(built, {"quell-denoise", "--isa"}).error, "''"));
    CHECK(choose_isa(built, {"quell-denoise", "--isa", "x86-64-v4"}).error ==
          "--isa: this machine does not run x86-64-v4; choose one of: x86-64-v3, x86-64");
    CHECK(contains(choose_isa({{"x86-64-v4", false}}, {"quell-denoise"}).error, "runs none of x86-64-v4"));
}

TEST_CASE("quell-denoise says which code runs, and refuses what it has not") {
    auto const version = denoise("--version").out;
    CHECK(version.starts_with("quell-denoise 0."));
    auto const isa = version.substr(version.rfind(' ') + 1, version.size() - version.rfind(' ') - 2);
    CHECK(contains(denoise("--help").out, "is compiled for: "));
    CHECK(denoise("--list --isa " + isa).code == 0);
    check_refused(denoise("--list --isa abacus"), {"--isa", "'abacus'", "choose one of: ", isa});
}

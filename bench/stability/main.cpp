// quell-stability: the catalogue of cases in which methods that reuse earlier frames fail, each held against a promise.
//   quell-stability [--cheap] [--case cut ...] [--out out/stability] [--check]
#include "cases.hpp"
#include "known_limits.hpp"
#include "options.hpp"

#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <iostream>

using namespace quell::stability;

namespace {

std::vector<Case> chosen(StabilityOptions const& options) {
    if (options.cases.empty()) return cases();
    std::vector<Case> list;
    for (auto const& name : options.cases) list.push_back(case_of(name));
    return list;
}

void run_cases(StabilityOptions const& options, Results& results) {
    auto const list = chosen(options);
    quell::examples::Progress progress("quell-stability", static_cast<long long>(list.size()), !options.quiet);
    long long done = 0;
    for (auto const& each : list) {
        progress.show(done++, each.name);
        each.run(each.name, options.making, results);
    }
}

int run(StabilityOptions const& options) {
    quell::examples::make_output_folder(options.out);
    Results results;
    run_cases(options, results);
    write_tables(results, options.out);
    write_page(results, options.out);
    int const broken = judge(results, std::cout);
    return options.check && broken > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    int code = 0;
    int const failed = quell::examples::exit_code_of("quell-stability", [&] {
        auto const options = stability_options(argc, argv);
        if (!options) return;
        if (!options->list)
            code = run(*options);
        else
            for (auto const& each : cases()) std::cout << each.name << '\n';
    });
    return failed != 0 ? failed : code;
}

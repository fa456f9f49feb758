// Writes the sample pages that the browser test opens: report_sample FOLDER.
#include "sample_report.hpp"

#include <cstdio>
#include <exception>

int main(int argument_count, char** arguments) {
    namespace sample = quell::examples::sample;
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: report_sample FOLDER\n");
        return 2;
    }
    try {
        std::filesystem::path const folder = arguments[1];
        using quell::examples::write_report;
        write_report(sample::make_report(160, 90, 6), folder / "full.html");
        auto late = sample::make_report(64, 48, 4);
        late.frames.erase(late.frames.begin()); // the first one left lacks its reference
        write_report(late, folder / "late.html");
        write_report(sample::make_bare_report(), folder / "bare.html");
        write_report(sample::make_report_of_figures(), folder / "figures.html");
        write_report({.title = "Nothing"}, folder / "empty.html");
    } catch (std::exception const& error) {
        std::fprintf(stderr, "report_sample: %s\n", error.what());
        return 1;
    }
}

// Writes the sample pages that the browser test opens: report_sample FOLDER [WIDTH HEIGHT FRAMES].
#include "sample_report.hpp"

#include <cstdio>
#include <exception>
#include <string>

int main(int argument_count, char** arguments) {
    namespace sample = quell::examples::sample;
    if (argument_count != 2 && argument_count != 5) {
        std::fprintf(stderr, "usage: report_sample FOLDER [WIDTH HEIGHT FRAMES]\n");
        return 2;
    }
    try {
        std::filesystem::path const folder = arguments[1];
        int const width = argument_count == 5 ? std::stoi(arguments[2]) : 160;
        int const height = argument_count == 5 ? std::stoi(arguments[3]) : 90;
        int const frames = argument_count == 5 ? std::stoi(arguments[4]) : 6;
        using quell::examples::write_report;
        write_report(sample::make_report(width, height, frames), folder / "full.html");
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

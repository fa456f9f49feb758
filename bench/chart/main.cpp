// quell-chart: what each method costs and how close it comes, on one scene and effect. Rows of chart.csv on standard output:
//   quell-chart --scene fence --effect shadow [--tolerance 0.01] [--threads N] [--size 480x270] [--few]
// References and masks are cached in ~/.cache/quell. --few scores frames 24, 32 and 40 only, curved is glossy inside curved
// reflectors, and blur opens the shutter for half of the frame time; its references are to 0.005.
#include "chart_effect.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

int main(int count, char** arguments) {
    quell::bench::ChartOptions options;
    std::string size;
    bool few = false;
    CLI::App app("Speed and accuracy of every method on a scene");
    app.add_option("--scene", options.scene, "A built-in scene");
    app.add_option("--effect", options.effect, "shadow, glossy, curved, indirect or blur")
        ->check(CLI::IsMember({"shadow", "glossy", "curved", "indirect", "blur"}));
    app.add_option("--size", size, "WIDTHxHEIGHT");
    app.add_option("--threads", options.threads, "0: all");
    auto const* const tolerance =
        app.add_option("--tolerance", options.tolerance, "Of the references: mean FLIP between two independent halves");
    app.add_flag("--few", few, "Score frames 24, 32 and 40 only");
    CLI11_PARSE(app, count, arguments);
    options.every_scored_frame = !few;
    // What moves is a small part of some pictures.
    if (options.effect == "blur" && tolerance->count() == 0) options.tolerance = 0.005;
    try {
        if (!size.empty() && std::sscanf(size.c_str(), "%dx%d", &options.size.width, &options.size.height) != 2)
            throw quell::Error("--size", size, "write WIDTHxHEIGHT, such as 480x270");
        std::cout
            << "scene,effect,method,width,height,frames,threads,ms_per_frame,rmse,ssim,flip,flip_median,mask_rmse,mask_ssim,mask_flip,"
               "flicker,bytes_per_pixel\n";
        if (options.effect == "shadow")
            quell::bench::chart_shadow(options);
        else if (options.effect == "indirect")
            quell::bench::chart_indirect(options);
        else if (options.effect == "blur")
            quell::bench::chart_blur(options);
        else
            quell::bench::chart_glossy(options, options.effect == "curved");
    } catch (quell::Error const& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}

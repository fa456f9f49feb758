// Writes the plans of presets as graphs for Graphviz, into the folder given: general.dot, trmv.dot, blur.dot. See draw.sh.
#include <quell/pipeline/draw_plan.hpp>
#include <quell/presets/blur.hpp>
#include <quell/quell.hpp>

#include <fstream>

using namespace quell;

int main(int, char** arguments) {
    auto const write = [&](char const* name, auto const& pipeline) {
        std::ofstream(std::string(arguments[1]) + "/" + name + ".dot", std::ios::binary) << to_graphviz(plan_of(pipeline));
    };
    write("general", presets::general(radiance, Demodulate{}));
    write("trmv", presets::trmv());
    write("blur", presets::blur(radiance));
}

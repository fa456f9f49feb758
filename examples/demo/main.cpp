#include "demo.hpp"

#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <tracer/scenes/scenes.hpp>

#include <cstdio>

namespace {
void run(int argc, char const* const* argv) {
    using namespace quell;
    auto const options = examples::demo_options(argc, argv);
    if (options.wants_help) return;
    if (options.list) {
        for (auto const& name : tracer::scene_names()) std::puts(name.c_str());
        return;
    }
    auto const folders = examples::folders_of_scenes(options.out, options.scenes);
    for (std::size_t i = 0; i < folders.size(); ++i) {
        auto const page = examples::run_demo(options, options.scenes[i], folders[i]);
        std::printf("%s\n", std::filesystem::absolute(page).string().c_str());
    }
}
} // namespace

int main(int argc, char const* const* argv) {
    return quell::examples::exit_code_of("quell-demo", [&] { run(argc, argv); });
}

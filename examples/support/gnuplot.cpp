#include "gnuplot.hpp"

#include <quell/io/replace_file.hpp>

#include <cstdlib>

namespace quell::examples {
namespace {

std::string quoted_for_shell(std::string const& text) {
    std::string result = "'";
    for (char const c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

} // namespace

bool has_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

std::string quoted_for_gnuplot(std::string const& text) {
    std::string result = "\"";
    for (char const c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

void draw_by_gnuplot(std::filesystem::path const& script, std::string const& text) {
    io::replace_file(script, text);
    auto const folder = script.has_parent_path() ? script.parent_path() : std::filesystem::path(".");
    auto const name = quoted_for_shell(script.filename().string()), log = quoted_for_shell(script.filename().string() + ".log");
    auto const command = "cd -- " + quoted_for_shell(folder.string()) + " && gnuplot " + name + " > " + log + " 2>&1 && rm -- " + log;
    if (std::system(command.c_str()) != 0)
        throw Failure(script.string(), "gnuplot can't draw it", "see " + script.filename().string() + ".log beside it");
}

} // namespace quell::examples

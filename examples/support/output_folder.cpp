#include "output_folder.hpp"

#include <quell/io/replace_file.hpp>

#include <map>
#include <system_error>

namespace quell::examples {

void make_output_folder(std::filesystem::path const& folder) {
    std::error_code why;
    std::filesystem::create_directories(folder, why);
    if (why) throw Error(folder.string(), "the folder can't be made: " + why.message(), "choose another for --out");
    auto const probe = folder / ".quell";
    try {
        io::replace_file(probe, "");
    } catch (Error const&) {
        throw Error(folder.string(), "no file can be written there", "choose another for --out");
    }
    std::filesystem::remove(probe, why);
}

std::vector<std::filesystem::path> folders_of_scenes(std::filesystem::path const& out, std::vector<std::string> const& scenes) {
    if (scenes.size() == 1) return {out};
    std::map<std::filesystem::path, std::string> taken;
    std::vector<std::filesystem::path> folders;
    for (auto const& scene : scenes) {
        auto const folder = folders.emplace_back(out / std::filesystem::path(scene).stem());
        auto const [place, is_new] = taken.emplace(folder, scene);
        if (!is_new)
            throw Error("--scene", "'" + place->second + "' and '" + scene + "' would both go to " + folder.string(),
                        "run the program for each by itself, with an --out of its own");
    }
    return folders;
}

void make_folder_for(std::filesystem::path const& file) {
    if (std::filesystem::is_directory(file)) throw Error(file.string(), "it is a folder", "name a file for --out");
    auto const folder = file.parent_path();
    make_output_folder(folder.empty() ? "." : folder);
}

} // namespace quell::examples

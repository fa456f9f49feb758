#pragma once

#include "report/report.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace quell::examples {

/// A folder of the test's own, removed with all that it holds.
struct Folder {
    std::filesystem::path path = make();

    Folder() = default;
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    ~Folder() { std::filesystem::remove_all(path); }

    static std::filesystem::path make() {
        std::string name = (std::filesystem::temp_directory_path() / "quell_report_XXXXXX").string();
        return mkdtemp(name.data());
    }
};

inline std::string read_text(std::filesystem::path const& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string write_and_read(Report const& report) {
    Folder const folder;
    write_report(report, folder.path / "index.html");
    return read_text(folder.path / "index.html");
}

/// The text of the element with this id, as a browser would end it: at the first closing tag.
inline std::string element_text(std::string const& page, std::string const& id) {
    std::size_t const start = page.find('>', page.find("id=\"" + id + "\">")) + 1;
    return page.substr(start, page.find("</script", start) - start);
}

inline nlohmann::json data_of(std::string const& page) { return nlohmann::json::parse(element_text(page, "report-data")); }

} // namespace quell::examples

#pragma once

#include "../temporary_folder.hpp"
#include "report/report.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace quell::examples {

using tests::bytes_of;
using tests::Folder;

inline std::string write_and_read(Report const& report) {
    Folder const folder;
    write_report(report, folder / "index.html");
    return bytes_of(folder / "index.html");
}

/// The text of the element with this id, as a browser would end it: at the first closing tag.
inline std::string element_text(std::string const& page, std::string const& id) {
    std::size_t const start = page.find('>', page.find("id=\"" + id + "\">")) + 1;
    return page.substr(start, page.find("</script", start) - start);
}

inline nlohmann::json data_of(std::string const& page) { return nlohmann::json::parse(element_text(page, "report-data")); }

} // namespace quell::examples

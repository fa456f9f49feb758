#include "page.hpp"

#include <report/write_page.hpp>

#include <nlohmann/json.hpp>

namespace quell::examples {
PageParts chart_page(); // generated from page/
}

namespace quell::bench {
namespace {

using Json = nlohmann::json;

Json json_of(Row const& row) {
    Json json{{"scene", row.scene},
              {"effect", row.effect},
              {"method", row.method},
              {"width", row.size.width},
              {"height", row.size.height},
              {"frames", row.frames},
              {"threads", row.threads},
              {"competes", row.competes},
              {"picture", row.picture},
              {"reference", row.reference},
              {"ms_per_frame", row.ms_per_frame}};
    // JSON has no word for numbers that aren't known: the library writes null.
    for (auto const& measure : measures()) json[measure.name] = measure.of(row);
    return json;
}

std::string subtitle_of(std::vector<Row> const& rows) {
    if (rows.empty()) return "";
    auto const& row = rows.front();
    return to_string(row.size) + ", " + std::to_string(row.threads) + (row.threads == 1 ? " thread, " : " threads, ") +
           std::to_string(row.frames) + " frames; errors are of displayed pictures, and means over the scored frames";
}

} // namespace

void write_chart_page(std::vector<Row> const& rows, std::filesystem::path const& file) {
    std::string const title = "quell: speed against accuracy";
    Json data{{"title", title}, {"subtitle", subtitle_of(rows)}, {"measures", Json::array()}, {"rows", Json::array()}};
    for (auto const& measure : measures())
        data["measures"].push_back(
            {{"name", measure.name}, {"description", measure.description}, {"higher_is_better", measure.higher_is_better}});
    for (auto const& row : rows) data["rows"].push_back(json_of(row));
    auto const json = examples::without_angle_brackets(data.dump(-1, ' ', false, Json::error_handler_t::replace));
    examples::write_page(file, examples::chart_page(), title, [&](std::ostream& out, std::string_view mark) {
        if (mark == "data") out << json;
    });
}

} // namespace quell::bench

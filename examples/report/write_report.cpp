#include "report/report.hpp"

#include "report/base64.hpp"
#include "report/check.hpp"
#include "report/write_page.hpp"

#include <nlohmann/json.hpp>

#include <string_view>
#include <unordered_map>

namespace quell::examples {

using Json = nlohmann::json;

// What the page's scripts work on, by the names of the members. JSON has no word for numbers that aren't finite: the library writes null,
// which the plot takes for a gap.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ColorScale, label, low, high, colors)
static void to_json(Json& json, PictureKind const& kind) {
    json = {{"name", kind.name}, {"description", kind.description}, {"scale", kind.scale ? Json(*kind.scale) : Json()}};
}
static void to_json(Json& json, ReportPoint const& point) { json = Json::array({point.frame, point.value}); }
static void to_json(Json& json, ReportSeries const& series) { json = {{"name", series.name}, {"points", series.points}}; }
static void to_json(Json& json, ReportMetric const& metric) {
    json = {{"name", metric.name}, {"unit", metric.unit}, {"hint", metric.hint}, {"series", metric.series}};
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReportTable, caption, columns, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReportNote, label, text, code)

namespace {

/// The pictures, to which the JSON refers by index. Equal ones have one index: a still scene's reference is the same in every frame.
class PictureIndex {
public:
    std::size_t of(std::vector<unsigned char> const& png) {
        std::string_view const content(reinterpret_cast<char const*>(png.data()), png.size());
        auto const [entry, fresh] = indices.try_emplace(content, pictures.size());
        if (fresh) pictures.push_back(&png);
        return entry->second;
    }
    std::vector<std::vector<unsigned char> const*> pictures; ///< they stay the report's

private:
    std::unordered_map<std::string_view, std::size_t> indices;
};

/// A frame's pictures in the order of the kinds, null for those that it lacks.
Json frame_json(ReportFrame const& frame, std::vector<PictureKind> const& kinds, PictureIndex& index) {
    Json pictures = Json::array();
    for (PictureKind const& kind : kinds) {
        auto const found = frame.pictures.find(kind.name);
        pictures.push_back(found == frame.pictures.end() ? Json() : Json(index.of(found->second)));
    }
    return {{"number", frame.number}, {"pictures", std::move(pictures)}};
}

/// All but the pictures, safe inside a script element.
std::string page_json(Report const& report, PictureIndex& index) {
    Json page{{"title", report.title},   {"subtitle", report.subtitle}, {"kinds", report.kinds},  {"metrics", report.metrics},
              {"tables", report.tables}, {"notes", report.notes},       {"frames", Json::array()}};
    for (ReportFrame const& frame : report.frames) page["frames"].push_back(frame_json(frame, report.kinds, index));
    auto const size = index.pictures.empty() ? PictureSize{16, 9} : png_size(*index.pictures.front(), "first picture");
    page["size"] = {{"width", size.width}, {"height", size.height}};
    // Bytes that aren't UTF-8, as file names may hold, become replacement characters: a report is worth more than one of its letters.
    return without_angle_brackets(page.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// One element per picture, so that a browser holds no decoded copy of those that nobody looks at.
void write_pictures(std::ostream& out, PictureIndex const& index) {
    for (std::size_t i = 0; i < index.pictures.size(); ++i)
        out << "<script type=\"text/plain\" id=\"picture-" << i << "\">data:image/png;base64," << encode_base64(*index.pictures[i])
            << "</script>\n";
}

} // namespace

void write_report(Report const& report, std::filesystem::path const& file) {
    check_report(report);
    PictureIndex index;
    auto const json = page_json(report, index);
    write_page(file, report_page(), report.title, [&](std::ostream& out, std::string_view mark) {
        if (mark == "data") out << json;
        if (mark == "pictures") write_pictures(out, index);
    });
}

} // namespace quell::examples

#include "report/page_data.hpp"

#include "report/check.hpp"
#include "report/write_page.hpp"

#include <nlohmann/json.hpp>

#include <string_view>
#include <unordered_map>

namespace quell::examples {

namespace {

using Json = nlohmann::json;

/// Gives equal pictures one index, since a still scene's reference is the same in every frame.
class PictureIndex {
public:
    explicit PictureIndex(PageData& data) : data_(data) {}

    std::size_t of(std::vector<unsigned char> const& png) {
        std::string_view const content(reinterpret_cast<char const*>(png.data()), png.size());
        auto const [entry, fresh] = indices_.try_emplace(content, data_.pictures.size());
        if (fresh) data_.pictures.push_back(&png);
        return entry->second;
    }

private:
    PageData& data_;
    std::unordered_map<std::string_view, std::size_t> indices_;
};

Json scale_json(std::optional<ColorScale> const& scale) {
    if (!scale) return nullptr;
    return {{"label", scale->label}, {"low", scale->low}, {"high", scale->high}, {"colors", scale->colors}};
}

Json kinds_json(std::vector<PictureKind> const& kinds) {
    Json list = Json::array();
    for (PictureKind const& kind : kinds)
        list.push_back({{"name", kind.name}, {"description", kind.description}, {"scale", scale_json(kind.scale)}});
    return list;
}

/// A frame's pictures in the order of the kinds, null for those that it lacks.
Json frame_json(ReportFrame const& frame, std::vector<PictureKind> const& kinds, PictureIndex& index) {
    Json pictures = Json::array();
    for (PictureKind const& kind : kinds) {
        auto const found = frame.pictures.find(kind.name);
        pictures.push_back(found == frame.pictures.end() ? Json() : Json(index.of(found->second)));
    }
    return {{"number", frame.number}, {"pictures", std::move(pictures)}};
}

Json frames_json(Report const& report, PictureIndex& index) {
    Json list = Json::array();
    for (ReportFrame const& frame : report.frames) list.push_back(frame_json(frame, report.kinds, index));
    return list;
}

Json series_json(ReportSeries const& series) {
    Json points = Json::array();
    // JSON has no word for numbers that aren't finite: the library writes null, which the plot takes for a gap.
    for (ReportPoint const& point : series.points) points.push_back(Json::array({point.frame, point.value}));
    return {{"name", series.name}, {"points", std::move(points)}};
}

Json metrics_json(std::vector<ReportMetric> const& metrics) {
    Json list = Json::array();
    for (ReportMetric const& metric : metrics) {
        Json series = Json::array();
        for (ReportSeries const& one : metric.series) series.push_back(series_json(one));
        list.push_back({{"name", metric.name}, {"unit", metric.unit}, {"hint", metric.hint}, {"series", std::move(series)}});
    }
    return list;
}

Json tables_json(std::vector<ReportTable> const& tables) {
    Json list = Json::array();
    for (ReportTable const& table : tables) list.push_back({{"caption", table.caption}, {"columns", table.columns}, {"rows", table.rows}});
    return list;
}

Json notes_json(std::vector<ReportNote> const& notes) {
    Json list = Json::array();
    for (ReportNote const& note : notes) list.push_back({{"label", note.label}, {"text", note.text}, {"code", note.code}});
    return list;
}

Json size_json(PageData const& data) {
    if (data.pictures.empty()) return {{"width", 16}, {"height", 9}};
    PictureSize const size = png_size(*data.pictures.front(), "first picture");
    return {{"width", size.width}, {"height", size.height}};
}

} // namespace

PageData page_data(Report const& report) {
    PageData data;
    PictureIndex index(data);
    Json page = {{"title", report.title}, {"subtitle", report.subtitle}};
    page["kinds"] = kinds_json(report.kinds);
    page["frames"] = frames_json(report, index);
    page["size"] = size_json(data);
    page["metrics"] = metrics_json(report.metrics);
    page["tables"] = tables_json(report.tables);
    page["notes"] = notes_json(report.notes);
    // Bytes that aren't UTF-8, as file names may hold, become replacement characters: a report is worth more than one of its letters.
    data.json = without_angle_brackets(page.dump(-1, ' ', false, Json::error_handler_t::replace));
    return data;
}

} // namespace quell::examples

#include "report/report.hpp"

#include "report/base64.hpp"
#include "report/check.hpp"
#include "report/page_data.hpp"
#include "report/write_page.hpp"

namespace quell::examples {

namespace {

/// One element per picture, so that a browser holds no decoded copy of those that nobody looks at.
void write_pictures(std::ostream& out, PageData const& data) {
    for (std::size_t i = 0; i < data.pictures.size(); ++i)
        out << "<script type=\"text/plain\" id=\"picture-" << i << "\">data:image/png;base64," << encode_base64(*data.pictures[i])
            << "</script>\n";
}

} // namespace

void write_report(Report const& report, std::filesystem::path const& file) {
    check_report(report);
    PageData const data = page_data(report);
    write_page(file, report_page(), report.title, [&](std::ostream& out, std::string_view mark) {
        if (mark == "data") out << data.json;
        if (mark == "pictures") write_pictures(out, data);
    });
}

} // namespace quell::examples

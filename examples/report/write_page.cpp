#include "report/write_page.hpp"

#include "quell/core/error.hpp"

#include <fstream>
#include <system_error>
#include <utility>

namespace quell::examples {

namespace {

std::string escape_html(std::string_view text) {
    std::string escaped;
    for (char const character : text) {
        switch (character) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        default:
            escaped += character;
        }
    }
    return escaped;
}

void write_all(std::ostream& out, std::span<std::string_view const> texts) {
    for (std::string_view const text : texts) out << text;
}

void fill_in(std::ostream& out, PageParts const& page, std::string const& title,
             std::function<void(std::ostream&, std::string_view)> const& write_mark) {
    std::string_view rest = page.html;
    for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
        std::size_t const close = rest.find("}}", open);
        out << rest.substr(0, open);
        auto const mark = rest.substr(open + 2, close - open - 2);
        if (mark == "title") out << escape_html(title);
        if (mark == "style") write_all(out, page.styles);
        if (mark == "scripts") write_all(out, page.scripts);
        write_mark(out, mark);
        rest.remove_prefix(close + 2);
    }
    out << rest;
}

[[noreturn]] void fail(std::filesystem::path const& file, std::string const& found) {
    throw Failure(file.string(), found, "check that its folder exists, may be written to and has room left");
}

/// Removes a half-written file, except where it has been put in place.
class PartialFile {
public:
    explicit PartialFile(std::filesystem::path path) : path_(std::move(path)) {}
    PartialFile(PartialFile const&) = delete;
    PartialFile& operator=(PartialFile const&) = delete;
    ~PartialFile() {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
    }

    std::filesystem::path const& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace

void write_page(std::filesystem::path const& file, PageParts const& page, std::string const& title,
                std::function<void(std::ostream&, std::string_view)> const& write_mark) {
    PartialFile const partial(std::filesystem::path(file) += ".partial");
    std::ofstream out(partial.path(), std::ios::binary);
    if (!out) fail(file, "can't be opened for writing");
    fill_in(out, page, title, write_mark);
    out.close();
    if (!out) fail(file, "can't be written in full");
    std::error_code error;
    std::filesystem::rename(partial.path(), file, error);
    if (error) fail(file, "can't be put in place: " + error.message());
}

std::string without_angle_brackets(std::string const& json) {
    std::string text;
    text.reserve(json.size());
    for (char const character : json) {
        if (character == '<')
            text += "\\u003c";
        else
            text += character;
    }
    return text;
}

} // namespace quell::examples

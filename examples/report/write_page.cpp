#include "report/write_page.hpp"

#include "quell/io/replace_file.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace quell::examples {

namespace {

/// A text with others in place of some of its letters.
std::string replaced(std::string_view text, std::initializer_list<std::pair<char, std::string_view>> others) {
    std::string result;
    for (char const& letter : text) {
        auto const other = std::ranges::find(others, letter, &std::pair<char, std::string_view>::first);
        result += other == others.end() ? std::string_view(&letter, 1) : other->second;
    }
    return result;
}

void write_all(std::ostream& out, std::span<std::string_view const> texts) {
    for (std::string_view const text : texts) out << text;
}

} // namespace

void write_page(std::filesystem::path const& file, PageParts const& page, std::string const& title,
                std::function<void(std::ostream&, std::string_view)> const& write_mark) {
    std::ostringstream out;
    std::string_view rest = page.html;
    for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
        std::size_t const close = rest.find("}}", open);
        out << rest.substr(0, open);
        auto const mark = rest.substr(open + 2, close - open - 2);
        if (mark == "title") out << replaced(title, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
        if (mark == "style") write_all(out, page.styles);
        if (mark == "scripts") write_all(out, page.scripts);
        write_mark(out, mark);
        rest.remove_prefix(close + 2);
    }
    out << rest;
    io::replace_file(file, out.view());
}

std::string without_angle_brackets(std::string const& json) { return replaced(json, {{'<', "\\u003c"}}); }

} // namespace quell::examples

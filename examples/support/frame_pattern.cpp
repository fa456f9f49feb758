#include <support/frame_pattern.hpp>

#include <quell/core/error.hpp>

#include <algorithm>
#include <charconv>
#include <regex>
#include <set>

namespace quell::examples {

FramePattern::FramePattern(std::string const& pattern_) : pattern(pattern_) {
    std::filesystem::path const path(pattern);
    folder = path.parent_path();
    auto const name = path.filename().string();
    static std::regex const form("([^%]*)%(0([1-9]))?d([^%]*)");
    std::smatch parts;
    if (!std::regex_match(name, parts, form))
        throw Error("'" + pattern + "'", "no place for the frame's number in the file name",
                    "write %04d once where it stands, as in frame.%04d.exr");
    before = parts[1], after = parts[4];
    if (parts[3].matched) digits = static_cast<std::size_t>(parts[3].str()[0] - '0');
}

std::filesystem::path FramePattern::path(long long number) const {
    auto text = std::to_string(number < 0 ? -number : number);
    auto const width = digits - std::min<std::size_t>(digits, number < 0 ? 1 : 0);
    if (text.size() < width) text.insert(0, width - text.size(), '0');
    return folder / (before + (number < 0 ? "-" : "") + text + after);
}

std::optional<long long> FramePattern::number_in(std::string const& name) const {
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after)) return std::nullopt;
    auto const* const begin = name.data() + before.size();
    auto const* const end = name.data() + name.size() - after.size();
    long long number = 0;
    auto const read = std::from_chars(begin, end, number);
    if (read.ec != std::errc{} || read.ptr != end || path(number).filename() != name) return std::nullopt;
    return number;
}

std::vector<long long> FramePattern::on_disk() const {
    std::set<long long> numbers;
    std::error_code none;
    for (auto const& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, none))
        if (auto const number = number_in(entry.path().filename().string())) numbers.insert(*number);
    return {numbers.begin(), numbers.end()};
}

} // namespace quell::examples

#include <support/frame_pattern.hpp>

#include <quell/core/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace quell::examples {

namespace {
/// Where the number stands in a file name, and to how many digits it is padded.
struct Place {
    std::size_t begin, end, digits;
};

/// A place such as %d or %04d; nothing where there is none, or another % behind it.
std::optional<Place> printf_place(std::string const& name, std::size_t begin) {
    auto const text = name.substr(begin + 1);
    if (text.find('%') != std::string::npos) return std::nullopt;
    if (text.starts_with('d')) return Place{begin, begin + 2, 0};
    bool const padded = text.size() >= 3 && text[0] == '0' && text[1] >= '1' && text[1] <= '9' && text[2] == 'd';
    return padded ? std::optional(Place{begin, begin + 4, static_cast<std::size_t>(text[1] - '0')}) : std::nullopt;
}

/// In a name with a %, # stands for itself.
std::optional<Place> place_in(std::string const& name) {
    if (auto const percent = name.find('%'); percent != std::string::npos) return printf_place(name, percent);
    auto const begin = name.find('#');
    if (begin == std::string::npos) return std::nullopt;
    auto const end = std::min(name.find_first_not_of('#', begin), name.size());
    return name.find('#', end) == std::string::npos ? std::optional(Place{begin, end, end - begin}) : std::nullopt;
}
} // namespace

FramePattern::FramePattern(std::string const& pattern_) : pattern(pattern_) {
    std::filesystem::path const path(pattern);
    folder = path.parent_path();
    auto const name = path.filename().string();
    auto const place = place_in(name);
    if (!place)
        throw Error("'" + pattern + "'", "no place for the frame's number in the file name",
                    "write %04d or #### once where it stands, as in frame.%04d.exr");
    before = name.substr(0, place->begin), after = name.substr(place->end);
    digits = place->digits;
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

std::vector<long long> FramePattern::on_disk(long long first, long long last) const {
    auto numbers = on_disk();
    std::erase_if(numbers, [&](auto number) { return number < first || number > last; });
    return numbers;
}

std::string frame_file_name(std::string const& name, long long number, std::string const& ending) {
    return fmt::format("{}.{:04}.{}", name, number, ending);
}

FrameRange range_of(FramePattern const& files, std::optional<long long> first, std::optional<long long> last) {
    auto const there = files.on_disk();
    if (there.empty())
        throw Error(files.text(), "there is no such file for any number", "check the folder and the name before and after the number");
    FrameRange const range{first.value_or(there.front()), last.value_or(there.back())};
    if (range.first <= range.last) return range;
    throw Error("frames", "the first is " + std::to_string(range.first) + " and the last is " + std::to_string(range.last),
                "give --first and --last in order; there are " + std::to_string(there.front()) + " to " + std::to_string(there.back()));
}

namespace {
std::filesystem::path resolved(std::filesystem::path const& path) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
}
} // namespace

void check_keeps(FramePattern const& kept, std::string const& what, FramePattern const& out, std::vector<long long> const& numbers) {
    auto const folder = resolved(std::filesystem::absolute(kept.path(0)).parent_path());
    std::set<std::filesystem::path> files; // links may lead to them from elsewhere
    for (auto const number : kept.on_disk()) files.insert(resolved(kept.path(number)));
    for (auto const number : numbers) {
        auto const path = resolved(out.path(number));
        if (files.contains(path) || (path.parent_path() == folder && kept.number_in(path.filename().string())))
            throw Error("--out", out.path(number).string() + " would take the place of one of " + what, "choose another name or folder");
    }
}

} // namespace quell::examples

#include <denoise/frame_list.hpp>

#include <quell/core/error.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>

namespace quell::examples {

namespace {

constexpr std::size_t most_frames = 1'000'000;

/// Reads a whole number at the beginning of a text, and takes it away.
std::optional<long long> take_number(std::string_view& text) {
    long long number = 0;
    auto const read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc{} || number < -999'999'999'999 || number > 999'999'999'999) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return number;
}
bool take(std::string_view& text, char character) {
    if (!text.starts_with(character)) return false;
    text.remove_prefix(1);
    return true;
}

struct Span {
    long long first, last, step = 1;
};
std::optional<Span> span_in(std::string_view text) {
    auto const first = take_number(text);
    if (!first) return std::nullopt;
    Span span{*first, *first};
    if (take(text, '-')) {
        auto const last = take_number(text);
        if (!last || *last < *first) return std::nullopt;
        span.last = *last;
        if (take(text, 'x')) {
            auto const step = take_number(text);
            if (!step || *step < 1) return std::nullopt;
            span.step = *step;
        }
    }
    return text.empty() ? std::optional(span) : std::nullopt;
}

/// The first frame that warms up `number`.
long long begin_of(long long number, WarmUp const& warm_up, std::vector<long long> const& there) {
    // A shot's first frames have none before them to warm up with.
    auto const first = there.empty() ? number : std::min(number, there.front());
    auto begin = std::max(number - warm_up.frames, first);
    if (!warm_up.whatever_there_is) return begin;
    for (auto earlier = number - 1; earlier >= begin; --earlier)
        if (!std::ranges::binary_search(there, earlier)) return earlier + 1;
    return begin;
}

} // namespace

std::vector<long long> frames_in(std::string const& text) {
    std::set<long long> frames;
    std::istringstream list(text);
    auto const refuse = [&](std::string const& part) {
        throw Error("--frames", "'" + part + "' in '" + text + "'", "give numbers and ascending ranges, as in 1-48,60 or 1-99x2");
    };
    if (text.empty() || text.ends_with(',')) refuse("");
    for (std::string part; std::getline(list, part, ',');) {
        auto const span = span_in(part);
        if (!span) refuse(part);
        if (static_cast<std::size_t>((span->last - span->first) / span->step) >= most_frames)
            throw Error("--frames", "'" + part + "' has more than a million frames", "give fewer at a time");
        for (auto number = span->first; number <= span->last; number += span->step) frames.insert(number);
    }
    return {frames.begin(), frames.end()};
}

Chunk chunk_in(std::string const& text) {
    std::string_view rest = text;
    auto const number = take_number(rest);
    auto const slash = take(rest, '/');
    auto const count = slash ? take_number(rest) : std::nullopt;
    if (number && count && rest.empty() && *number >= 1 && *number <= *count) return {*number, *count};
    throw Error("--chunk", "'" + text + "'", "give a part and how many there are, from 1/6 to 6/6");
}

std::vector<long long> part_of(std::vector<long long> const& frames, Chunk const& chunk) {
    auto const total = static_cast<long long>(frames.size());
    // In two steps, as a product of both may be too large.
    auto const bound = [&](long long part) { return total / chunk.count * part + total % chunk.count * part / chunk.count; };
    return {frames.begin() + bound(chunk.number - 1), frames.begin() + bound(chunk.number)};
}

std::vector<Step> steps_for(std::vector<long long> const& written, WarmUp const& warm_up, std::vector<long long> const& there) {
    std::vector<Step> steps;
    for (auto const number : written) {
        auto begin = begin_of(number, warm_up, there);
        bool const goes_on = !steps.empty() && begin <= steps.back().number + 1;
        if (goes_on) begin = steps.back().number + 1;
        for (auto each = begin; each <= number; ++each) steps.push_back({each, each == number, !goes_on && each == begin});
    }
    return steps;
}

} // namespace quell::examples

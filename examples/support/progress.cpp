#include <support/progress.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace quell::examples {

namespace {

bool stderr_is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

constexpr auto wipe = "\r\x1b[K";

/// Minutes and seconds.
std::string clock(double seconds) {
    auto const whole = static_cast<long long>(seconds + 0.5);
    auto const rest = std::to_string(whole % 60);
    return std::to_string(whole / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string bar(double part) {
    constexpr int width = 30;
    auto const full = static_cast<std::size_t>(std::clamp(part, 0., 1.) * width);
    return std::string(full, '=').append(width - full, ' ');
}

} // namespace

Progress::Progress(std::string label_, long long total_, bool wanted)
    : label(std::move(label_)), total(std::max(total_, 1LL)), on_terminal(wanted && stderr_is_terminal()) {}

Progress::~Progress() {
    if (visible) std::fputs(wipe, stderr);
}

void Progress::say(std::string const& line) {
    std::fprintf(stderr, "%s%s\n", visible ? wipe : "", line.c_str());
    visible = false;
}

void Progress::show(long long done, std::string const& what) {
    using std::chrono::duration;
    auto const now = std::chrono::steady_clock::now();
    double const elapsed = duration<double>(now - begin).count();
    if (!on_terminal || elapsed < 0.5 || (visible && duration<double>(now - last).count() < 0.1)) return;
    visible = true, last = now;
    double const part = static_cast<double>(done) / static_cast<double>(total);
    std::string text = wipe;
    text.append(label).append(" [").append(bar(part)).append("] ").append(std::to_string(done)).append("/").append(std::to_string(total));
    if (done > 0) text.append(" ").append(clock(elapsed * (1. - part) / part)).append(" left");
    std::fputs(text.append("  ").append(what).c_str(), stderr);
    std::fflush(stderr);
}

} // namespace quell::examples

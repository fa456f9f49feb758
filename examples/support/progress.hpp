#pragma once

#include <chrono>
#include <string>

namespace quell::examples {

/// A bar on stderr for work that takes a while. It shows only on a terminal, and only once the work has taken half a second.
class Progress {
public:
    /// @param label what is being done; @param total how many steps there are; @param wanted false for --quiet
    Progress(std::string label, long long total, bool wanted = true);
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;
    /// Wipes the bar.
    ~Progress();

    /// Tells that this many steps of all are done, and perhaps what comes next.
    void show(long long done, std::string const& what = {});

    /// Writes a line on stderr, on a terminal in place of the bar until that shows again. It appears in any case.
    void say(std::string const& line);

private:
    std::string label;
    long long total;
    bool on_terminal, visible = false;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now(), last = begin;
};

} // namespace quell::examples

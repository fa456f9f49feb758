#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace quell::examples {

/// How often images change their layout: every pixel is written into an image of another type or order, and nothing is computed. Functions
/// that copy say so, whatever calls them. It counts for the signal whose light they copy.
class LayoutChanges {
    inline static std::string signal = "other";
    inline static std::map<std::string, double> counts;
    inline static double frames = 0;

public:
    /// While it lives, changes are those of a signal's light, or of whatever else has this name.
    class Of {
        std::string before;

    public:
        explicit Of(std::string name) : before(std::exchange(signal, std::move(name))) {}
        ~Of() { signal = std::move(before); }
        Of(Of const&) = delete;
        Of& operator=(Of const&) = delete;
    };

    /// Counts one.
    static void add() { ++counts[signal]; }
    /// Counts one of a guide's.
    static void add_guide(std::string_view name) { ++counts[name.starts_with("motion") ? std::string(name) : "other"]; }
    static void begin_frame() { ++frames; }
    /// Of each signal, motion and all others together, the mean over frames that were read.
    [[nodiscard]] static std::map<std::string, double> per_frame() {
        auto means = counts;
        for (auto& [name, count] : means) count /= frames;
        return means;
    }
};

} // namespace quell::examples

#pragma once

#include "errors.hpp"
#include "options.hpp"

#include <span>

namespace quell::bench {

/// What a method is called, how it is charted, and how it does.
struct Entry {
    std::string method;
    bool competes = true;
    MethodErrors errors{};
    std::string picture{}; ///< from the chart's folder
};

/// What a method's picture is called: a name that any file system and any address can have.
[[nodiscard]] std::string file_name(std::string name);

/// Knows what the scored frames of an effect on a scene should be.
class Judge {
public:
    static constexpr auto reference_name = "reference"; ///< as if it were a method

    /// Writes the picture of the reference. @throws Error where it can't
    /// @param wanted in order
    /// @param pictured the frame whose pictures are kept
    Judge(ChartOptions const& options, SceneEffect const& what, std::vector<Wanted> wanted, long long pictured);

    /// Measures what each method made of a scored frame, side by side, and keeps one frame's pictures as files.
    /// @param pictures linear, one for each entry; @throws Error for a picture that isn't finite, or can't be written
    void measure(long long frame, std::span<Entry> entries, std::span<metrics::Picture const> pictures) const;
    /// What is known of a method in the end.
    [[nodiscard]] Row row_of(Entry const& entry, double ms_per_frame, double bytes_per_pixel) const;
    [[nodiscard]] Extent size() const { return options.size; }
    [[nodiscard]] std::vector<int> frames() const { return options.scored_frames(); }

private:
    ChartOptions const& options;
    std::string scene, effect;
    std::vector<Wanted> wanted;
    long long pictured;
    std::string reference;

    [[nodiscard]] metrics::Picture displayed(std::string const& method, long long frame, metrics::Picture const& linear) const;
    std::string write(std::string const& method, metrics::Picture const& shown) const;
};

} // namespace quell::bench

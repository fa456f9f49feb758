#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// The paths of a sequence's frames, as in `dir/frame.%04d.exr`: the number stands where `%d` or `%0Nd` is, padded with zeros to N digits.
class FramePattern {
public:
    /// @throws Error where the file name doesn't have exactly one such place
    explicit FramePattern(std::string const& pattern);

    [[nodiscard]] std::filesystem::path path(long long number) const;
    /// The numbers of the frames that there are, ascending.
    [[nodiscard]] std::vector<long long> on_disk() const;
    [[nodiscard]] std::string const& text() const { return pattern; }

private:
    std::string pattern;
    std::filesystem::path folder;
    std::string before, after; ///< the file name's parts
    std::size_t digits = 0;

    [[nodiscard]] std::optional<long long> number_in(std::string const& file_name) const;
};

} // namespace quell::examples

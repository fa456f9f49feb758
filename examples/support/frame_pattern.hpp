#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// The paths of a sequence's frames, as in `dir/frame.%04d.exr` or `dir/frame.####.exr`: the number stands where `%d` or `%0Nd` is, padded
/// with zeros to N digits, or where a run of `#` is, padded to as many digits. In a file name with a `%`, `#` stands for itself.
class FramePattern {
public:
    /// @throws Error where the file name doesn't have exactly one such place
    explicit FramePattern(std::string const& pattern);

    [[nodiscard]] std::filesystem::path path(long long number) const;
    /// The numbers of the frames that there are, ascending.
    [[nodiscard]] std::vector<long long> on_disk() const;
    /// Those of them from first to last.
    [[nodiscard]] std::vector<long long> on_disk(long long first, long long last) const;
    /// The number of the frame of that file name; nothing where the pattern never makes it.
    [[nodiscard]] std::optional<long long> number_in(std::string const& file_name) const;
    [[nodiscard]] std::string const& text() const { return pattern; }

private:
    std::string pattern;
    std::filesystem::path folder;
    std::string before, after; ///< the file name's parts
    std::size_t digits = 0;
};

/// What quell's own programs call the file of a frame: name.0007.exr.
[[nodiscard]] std::string frame_file_name(std::string const& name, long long number, std::string const& ending);

/// Numbers of the first and the last frame of those that are wanted.
struct FrameRange {
    long long first, last;
};
/// What isn't given is found on disk. @throws Error where there is no file, or the first comes after the last
[[nodiscard]] FrameRange range_of(FramePattern const& files, std::optional<long long> first, std::optional<long long> last);

/// Makes sure that results of these numbers overwrite none of the files of another pattern, of any number, which messages call `what`.
/// @throws Error naming the file that would
void check_keeps(FramePattern const& kept, std::string const& what, FramePattern const& out, std::vector<long long> const& numbers);

} // namespace quell::examples

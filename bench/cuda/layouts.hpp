#pragma once

#include <string>
#include <vector>

// How jobs, which kernels are given, are laid out by the host's compiler. Without headers of quell.
namespace quell::bench {

/// A job's layout: a hash of its pass's name, its alignment, then place and size of it and of each of its parts.
using Layout = std::vector<unsigned>;
struct KnownLayout {
    std::string pass;
    Layout layout;
};
/// Of all jobs for which there are kernels in the program.
inline std::vector<KnownLayout>& known_layouts() {
    static std::vector<KnownLayout> all;
    return all;
}

/// Compares them with what PTX files say of the same jobs, and prints what differs.
/// @return whether all are equal
bool check_layouts(std::vector<std::string> const& ptx_files);

} // namespace quell::bench

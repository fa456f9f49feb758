#pragma once

#include "reference.hpp"

#include <cstdint>
#include <optional>

namespace quell::tracer::detail {

/// One reference's file. It is written beside its final name and renamed, so that no program ever reads half of one; a file that isn't
/// whole is as good as none, and so is a cache that can't be written: everything in it can be computed again.
class ReferenceCache {
public:
    /// An empty folder stands for $QUELL_CACHE, else ~/.cache/quell.
    ReferenceCache(std::filesystem::path const& folder, std::string const& scene, int frame, std::uint64_t key);

    [[nodiscard]] std::optional<Reference> load() const;
    void store(Reference const& reference) const;

private:
    std::filesystem::path file;
    std::uint64_t key;
};

} // namespace quell::tracer::detail

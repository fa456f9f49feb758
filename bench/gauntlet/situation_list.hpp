#pragma once

#include <gauntlet/situations.hpp>

#include <functional>

namespace quell::gauntlet {

/// What makes a shot another one.
using Change = std::function<void(Shot&)>;

/// Situations, each made from one before it.
struct SituationList {
    std::vector<Situation> all;

    /// A situation's shot with a change.
    [[nodiscard]] Shot with(std::string const& name, Change const& change) const;
    /// One in which all is as it should be.
    void add_right(std::string const& name, std::string const& about, Shot shot, bool is_small = false);
    /// One in which something is broken that is not in its twin.
    void add(std::string const& name, std::string const& about, std::string const& stage, std::string const& twin, Change const& change,
             bool is_small = false);
    [[nodiscard]] Situation& last() { return all.back(); }
};

/// Motion that vectors do not tell.
void add_untold_motion(SituationList& list);

} // namespace quell::gauntlet

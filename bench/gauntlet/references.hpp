#pragma once

#include <gauntlet/render.hpp>

#include <quell/metrics/picture.hpp>

#include <deque>
#include <map>
#include <mutex>

namespace quell::gauntlet {

/// What a frame is without noise.
struct Reference {
    metrics::Picture picture;
    metrics::Mask right; ///< pixels that lie away from what a situation breaks; empty: there is no such part
};

/// References, each made once: many situations have them in common.
class References {
    struct OfShot {
        Shot shot;
        std::map<int, Reference> frames{};
    };
    std::mutex mutex;
    std::deque<OfShot> all;

public:
    /// Valid as long as this object.
    [[nodiscard]] Reference const& of(Shot const& shot, Making const& making, int frame);
};

} // namespace quell::gauntlet

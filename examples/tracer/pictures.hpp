#pragma once

#include "math.hpp"

#include <quell/core/channel.hpp>
#include <quell/metrics/picture.hpp>

#include <array>
#include <cstddef>

namespace quell::tracer {

template <class C, class Set> inline constexpr std::size_t channel_index = 0;
template <class C, class... Cs>
inline constexpr std::size_t channel_index<C, Channels<Cs...>> = [] {
    std::size_t index = 0;
    static_cast<void>(((std::is_same_v<C, Cs> || (++index, false)) || ...));
    return index;
}();

/// The simplest sink: a picture per channel. One component is repeated in all three, two components leave the third at 0.
template <class Wanted> class Pictures {
public:
    explicit Pictures(Extent size) {
        for (auto& picture : pictures) picture = {size, std::vector<glm::vec3>(static_cast<std::size_t>(size.pixels()))};
    }

    template <class C, class Value> void put(C, int x, int y, Value const& value) {
        auto& picture = pictures[channel_index<C, Wanted>];
        picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) + static_cast<std::size_t>(x)] =
            widened(value);
    }

    template <class C> [[nodiscard]] metrics::Picture& operator[](C) {
        static_assert(Wanted::template has<C>, "this channel isn't in the set that these Pictures were made for");
        return pictures[channel_index<C, Wanted>];
    }
    template <class C> [[nodiscard]] metrics::Picture const& operator[](C) const {
        static_assert(Wanted::template has<C>, "this channel isn't in the set that these Pictures were made for");
        return pictures[channel_index<C, Wanted>];
    }

private:
    static glm::vec3 widened(float value) { return glm::vec3{value}; }
    static glm::vec3 widened(glm::vec2 value) { return {value, 0.f}; }
    static glm::vec3 widened(glm::vec3 value) { return value; }

    std::array<metrics::Picture, static_cast<std::size_t>(Wanted::size)> pictures;
};

} // namespace quell::tracer

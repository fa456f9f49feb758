#pragma once

#include <quell/frame/earlier.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A channel as a value. Its address identifies it.
struct ChannelInfo {
    std::string_view name;
    int fraction = 1;                   ///< image size = frame size / fraction, rounded up
    ChannelInfo const* later = nullptr; ///< of an Earlier: what it was a frame ago
};
/// That of what an Earlier was a frame ago; null for other channels.
template <class C> struct LaterInfo { static constexpr ChannelInfo const* value = nullptr; };
template <ChannelTag C> inline constexpr ChannelInfo channel_info{C::name, C::fraction, LaterInfo<C>::value};
template <ChannelTag C, int frames> struct LaterInfo<Earlier<C, frames>> {
    static constexpr ChannelInfo const* value = &channel_info<typename Earlier<C, frames>::later>;
};
using ChannelId = ChannelInfo const*;

/// Some channels, in order.
class ChannelIds {
    static constexpr int most = 32;
    std::array<ChannelId, most> ids{};
    int count = 0;

public:
    constexpr ChannelIds() = default;
    template <class... Cs> constexpr explicit ChannelIds(Channels<Cs...>) : ids{&channel_info<Cs>...}, count(sizeof...(Cs)) {
        static_assert(sizeof...(Cs) <= most, "a pass lists more than 32 channels of one kind");
    }
    [[nodiscard]] constexpr ChannelId const* begin() const { return ids.data(); }
    [[nodiscard]] constexpr ChannelId const* end() const { return ids.data() + count; }
    [[nodiscard]] constexpr int size() const { return count; }
    [[nodiscard]] constexpr bool has(ChannelId wanted) const {
        for (ChannelId const id : *this)
            if (id == wanted) return true;
        return false;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

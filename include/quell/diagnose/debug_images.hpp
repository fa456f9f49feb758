#pragma once

#include <quell/diagnose/inspect.hpp>
#include <quell/diagnose/watched.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Images of a channel that pipelines keep in this history: DebugChannels where the pipeline is watched() (DebugClamp only with a clamp),
/// and what policies keep themselves, such as history_length. One image per pipeline that keeps the channel; empty before the first run.
/// Multi-component channels give their first component.
/// @param channel what to show
/// @param history of a Pipeline or Composite that has run
template <ChannelTag C, class P, class Storage>
[[nodiscard]] std::vector<DebugImage> debug_images(C channel, History<P, Storage>& history) {
    std::vector<DebugImage> images;
    detail::for_each_history(history, [&]<class Part>(std::type_identity<Part>, auto& of_part) {
        if constexpr (Part::keeps::template has<C>) {
            auto const view = detail::Inspect::kept(of_part, channel);
            if (view.size.width == 0) return;
            DebugImage result{std::string(Part::Output::name), view.size, {}};
            for (int y = 0; y < view.size.height; ++y)
                for (int x = 0; x < view.size.width; ++x) result.values.push_back(view.get(0, x, y));
            images.push_back(std::move(result));
        }
    });
    return images;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

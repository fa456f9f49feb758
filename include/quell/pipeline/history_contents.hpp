#pragma once

#include <quell/pipeline/history.hpp>

#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What a history remembers of its last frame, as plain numbers. For hosts that keep it in files, or make one history of others: after a
/// signal has changed its unit, or where two signals are denoised as one from now on.
struct HistoryContents {
    using Planes = std::vector<std::vector<float>>; ///< one per component, row by row

    Extent size;                                       ///< of the frame
    Planes signal;                                     ///< accumulated, as the filters see it: divided by the albedo with Demodulate
    std::map<std::string, Planes, std::less<>> kept;   ///< by the channel's name: history_length and others
    std::map<std::string, Planes, std::less<>> guides; ///< by the channel's name: what the pipeline remembers of the frame
    Camera camera;                                     ///< of the frame
    float shutter = 0;                                 ///< of the frame
    std::optional<long long> number;                   ///< of the frame
};

namespace detail {
/// Access to what histories hold.
struct ReachContents {
    template <class H> static bool has_past(H const& history) { return !history.empty && history.then.signal; }

    static HistoryContents::Planes planes_of(auto const& image) {
        auto const view = image.view();
        HistoryContents::Planes planes(std::remove_cvref_t<decltype(view)>::components);
        for (std::size_t c = 0; c < planes.size(); ++c)
            for (int y = 0; y < view.size.height; ++y)
                for (int x = 0; x < view.size.width; ++x) planes[c].push_back(view.get(static_cast<int>(c), x, y));
        return planes;
    }
    template <class P, class Storage> static HistoryContents read(History<P, Storage> const& history) {
        auto const& then = history.then;
        HistoryContents contents{history.size, planes_of(then.signal), {}, {}, then.camera, then.shutter, then.number};
        for_each_channel(typename P::keeps{}, [&](auto c) {
            if (auto const& image = slot<decltype(c)>(then.kept)) contents.kept[std::string(c.name)] = planes_of(image);
        });
        for_each_channel(typename FrameState<P, Storage>::Guides{}, [&](auto c) {
            if (auto const& image = slot<decltype(c)>(then.guides)) contents.guides[std::string(c.name)] = planes_of(image);
        });
        return contents;
    }

    /// @param planes of another number of components: the image's further ones become 1, as alpha is
    template <class Image> static void put(ImagePool& pool, PooledImage<Image>& image, HistoryContents::Planes const& planes) {
        image = pool.template take<Image>();
        auto const view = image.view();
        for (std::size_t c = 0; c < std::remove_cvref_t<decltype(view)>::components; ++c)
            for (int y = 0; y < view.size.height; ++y)
                for (int x = 0; x < view.size.width; ++x)
                    view.set(static_cast<int>(c), x, y,
                             c < planes.size() ? planes[c][static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size.width) +
                                                           static_cast<std::size_t>(x)]
                                               : 1.f);
    }
    template <class P, class Storage> static void write(History<P, Storage>& history, HistoryContents const& contents) {
        history.restart(contents.size);
        auto& then = history.then;
        auto const put_named = [&]<class C>(auto& handles, C, auto const& from) {
            auto const found = from.find(C::name);
            if (found == from.end()) raise_error("history contents", "they lack " + std::string(C::name), "take them of a like pipeline");
            put(*history.pool, slot<C>(handles), found->second);
        };
        put(*history.pool, then.signal, contents.signal);
        for_each_channel(typename P::keeps{}, [&](auto c) { put_named(then.kept, c, contents.kept); });
        for_each_channel(typename FrameState<P, Storage>::Guides{}, [&](auto c) { put_named(then.guides, c, contents.guides); });
        then.camera = contents.camera, then.shutter = contents.shutter, then.number = contents.number;
        history.empty = false;
    }
};
} // namespace detail

/// What a history remembers; nothing before its first frame, and of pipelines without a past.
template <class P, class Storage> [[nodiscard]] std::optional<HistoryContents> contents_of(History<P, Storage> const& history) {
    if (!detail::ReachContents::has_past(history)) return std::nullopt;
    return detail::ReachContents::read(history);
}

/// Makes a history remember that. A component that the contents lack, such as alpha, becomes 1.
/// @param contents of a pipeline that keeps and remembers the same channels; its signal may have another number of components
/// @throws Error naming a channel that they lack
template <class P, class Storage> void put_contents(History<P, Storage>& history, HistoryContents const& contents) {
    static_assert(P::has_past, "put_contents(history, contents): the pipeline has no Temporal{...}, so its history remembers nothing");
    detail::ReachContents::write(history, contents);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

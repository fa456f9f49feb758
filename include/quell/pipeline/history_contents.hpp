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
template <class Storage, ChannelTag C> HistoryContents::Planes planes_of(PooledImage const& image) {
    auto const view = view_in<Storage, C>(image);
    HistoryContents::Planes planes(C::components);
    for (std::size_t c = 0; c < planes.size(); ++c)
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x) planes[c].push_back(view.get(static_cast<int>(c), x, y));
    return planes;
}
/// @param planes of another number of components: the image's further ones become 1, as alpha is
template <class Storage, ChannelTag C> PooledImage image_of(ImagePool& pool, HistoryContents::Planes const& planes) {
    auto const image = pool.take(format_of<Storage, C>);
    auto const view = view_in<Storage, C>(image);
    auto const width = static_cast<std::size_t>(view.size.width);
    for (std::size_t c = 0; c < C::components; ++c)
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x)
                view.set(static_cast<int>(c), x, y,
                         c < planes.size() ? planes[c][static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] : 1.f);
    return image;
}

template <class P, class Storage> HistoryContents read_contents(HistoryImages const& images) {
    auto const& then = images.then;
    HistoryContents contents{images.size, planes_of<Storage, typename P::Signal>(then.signal), {}, {}, then.camera, then.shutter,
                             then.number};
    auto const read = [](ImageTable const& table, auto& to) {
        return [&]<class C>(C) {
            if (auto const* const image = table.find(&channel_info<C>)) to[std::string(C::name)] = planes_of<Storage, C>(*image);
        };
    };
    for_each_channel(decltype(typename P::keeps{} | typename P::carries{}){}, read(then.kept, contents.kept));
    for_each_channel(typename StoredChannels<typename P::remembers>::type{}, read(then.guides, contents.guides));
    return contents;
}
template <class P, class Storage> void write_contents(HistoryImages& images, HistoryContents const& contents) {
    constexpr decltype(typename P::keeps{} | typename P::carries{}) kept;
    constexpr typename StoredChannels<typename P::remembers>::type guides;
    auto const check = [](auto const& from) {
        return [&]<class C>(C) {
            if (!from.contains(C::name))
                raise_error("history contents", "they lack " + std::string(C::name),
                            "take them of a like pipeline, after a run() of all its stages");
        };
    };
    for_each_channel(kept, check(contents.kept)), for_each_channel(guides, check(contents.guides));
    images.restart(contents.size);
    auto& then = images.then;
    auto const write = [&](ImageTable& table, auto const& from) {
        return [&]<class C>(C) { table[&channel_info<C>] = image_of<Storage, C>(*images.pool, from.find(C::name)->second); };
    };
    then.signal = image_of<Storage, typename P::Signal>(*images.pool, contents.signal);
    for_each_channel(kept, write(then.kept, contents.kept));
    for_each_channel(guides, write(then.guides, contents.guides));
    then.camera = contents.camera, then.shutter = contents.shutter, then.number = contents.number;
    images.empty = false;
}
} // namespace detail

/// What a history remembers; nothing before its first frame, and of pipelines without a past.
template <class P, class Storage> [[nodiscard]] std::optional<HistoryContents> contents_of(History<P, Storage> const& history) {
    auto const& images = detail::OpenHistory::images(history);
    if (images.empty || !images.then.signal) return std::nullopt;
    return detail::read_contents<P, Storage>(images);
}

/// Makes a history remember other contents than its own. A component that the contents lack, such as alpha, becomes 1.
/// @param history  any of the pipeline's; what it remembered is forgotten
/// @param contents of a pipeline that keeps and remembers the same channels; its signal may have another number of components
/// @throws Error naming a channel that they lack, before anything is forgotten
template <class P, class Storage> void put_contents(History<P, Storage>& history, HistoryContents const& contents) {
    static_assert(P::has_temporal, "put_contents(history, contents): the pipeline has no Temporal{...}, so its history remembers nothing");
    detail::write_contents<P, Storage>(detail::OpenHistory::images(history), contents);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

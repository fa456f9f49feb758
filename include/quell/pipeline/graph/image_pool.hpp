#pragma once

#include <quell/frame/frame.hpp>
#include <quell/pipeline/graph/channel_info.hpp>
#include <quell/pipeline/graph/pooled_image.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Images of the frame's size, or fractions of it, that passes take and give back. An image without handles is free for the next pass.
/// Once all frames that are kept are there, nothing is allocated. What one frame leaves for the next is held apart from it, in FrameState.
class ImagePool {
    struct Entry {
        void const* type;
        Extent size;
        std::shared_ptr<void> piece;
        std::size_t bytes;
    };
    std::vector<Entry> entries;
    Extent extent;

public:
    explicit ImagePool(Extent size) : extent(size) {}

    /// An image of 1/fraction of the pool's width and height. What it holds is left over from others; its padding is zero.
    [[nodiscard]] PooledImage take(ImageFormat const& format, int fraction = 1) {
        PooledImage taken;
        for (int i = 0; i < format.pieces; ++i) taken.pieces[static_cast<std::size_t>(i)] = free_or_new(format, divided(extent, fraction));
        return taken;
    }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (auto const& e : entries) sum += e.bytes;
        return sum;
    }
    [[nodiscard]] Extent size() const { return extent; }
    /// Drops images that nobody holds. The next frame makes them again.
    void release() {
        std::erase_if(entries, [](Entry const& e) { return e.piece.use_count() == 1; });
    }
    /// Drops images of another size. Those still held live until they are released.
    void resize(Extent new_size) {
        if (new_size == extent) return;
        entries.clear();
        extent = new_size;
    }

private:
    std::shared_ptr<void> free_or_new(ImageFormat const& format, Extent size) {
        for (auto const& e : entries)
            if (e.type == format.piece && e.size == size && e.piece.use_count() == 1) return e.piece;
        auto piece = format.make(size);
        auto const bytes = format.bytes(piece.get());
        entries.push_back({.type = format.piece, .size = size, .piece = piece, .bytes = bytes});
        return piece;
    }
};

/// Handles to the images of several channels.
class ImageTable {
    std::vector<std::pair<ChannelId, PooledImage>> images;
    // Not std::ranges, which the standard library of Debian's emscripten lacks.
    static auto is_of(ChannelId channel) {
        return [channel](auto const& image) { return image.first == channel; };
    }

public:
    /// The channel's handle, which may be empty.
    [[nodiscard]] PooledImage& operator[](ChannelId channel) {
        auto const found = std::find_if(images.begin(), images.end(), is_of(channel));
        return found != images.end() ? found->second : images.emplace_back(channel, PooledImage{}).second;
    }
    /// Null where there is none.
    [[nodiscard]] PooledImage const* find(ChannelId channel) const {
        auto const found = std::find_if(images.begin(), images.end(), is_of(channel));
        return found != images.end() && found->second ? &found->second : nullptr;
    }
    /// Whether there is an image of each. After a frame of fewer stages (accumulate) there is none of what the others keep.
    template <class... Cs> [[nodiscard]] bool has_all(Channels<Cs...>) const { return (find(&channel_info<Cs>) && ...); }
    void drop_all() { images.clear(); } // keeps the vector's memory
    void drop_if(auto&& unwanted) {
        for (auto& [channel, image] : images)
            if (unwanted(channel)) image = {};
    }
    void for_each(auto&& visit) const {
        for (auto const& [channel, image] : images) visit(image);
    }
    /// Whether somebody else holds one of its images, beside the pool.
    [[nodiscard]] bool is_shared() const {
        return std::any_of(images.begin(), images.end(), [](auto const& image) { return image.second.pieces[0].use_count() > 2; });
    }
    void swap(ImageTable& other) { images.swap(other.images); }

    /// The view of a channel's image; empty where there is none.
    template <class Storage, ChannelTag C> [[nodiscard]] ViewOf<Storage, C> view() const {
        auto const* const image = find(&channel_info<C>);
        return image ? view_in<Storage, C>(*image) : ViewOf<Storage, C>{};
    }
    /// Views of several channels.
    template <class Storage, class... Cs> [[nodiscard]] auto views(Channels<Cs...>) const {
        return Views<Storage, Channels<Cs...>>{{view<Storage, Cs>()}...};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

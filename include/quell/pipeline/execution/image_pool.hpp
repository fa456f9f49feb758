#pragma once

#include <quell/frame/frame.hpp>

#include <array>
#include <memory>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

template <class Image> using ViewIn = decltype(std::declval<Image const&>().view());
template <class View> using PlanesOf = std::array<std::shared_ptr<typename View::Plane>, std::size_t{View::components}>;
/// Whether the components of an image may lie apart, each in an image of one component.
template <class Image>
concept HasPlanes = requires(PlanesOf<ViewIn<Image>> const& planes) {
    { ViewIn<Image>::of(planes) } -> std::same_as<ViewIn<Image>>;
};

/// A handle to an image of the pool, or empty.
template <class Image> struct PooledImage {
    std::shared_ptr<Image> image;

    explicit operator bool() const { return image != nullptr; }
    bool operator==(PooledImage const&) const = default;
    [[nodiscard]] auto view() const { return image->view(); }
};
/// One to an image of planes, each of which may later be part of another image.
template <HasPlanes Image> struct PooledImage<Image> {
    PlanesOf<ViewIn<Image>> planes;

    explicit operator bool() const { return planes[0] != nullptr; }
    bool operator==(PooledImage const&) const = default;
    [[nodiscard]] auto view() const { return ViewIn<Image>::of(planes); }
};

/// Images of the frame's size, or fractions of it, that passes take and give back. An image without handles is free for the next pass.
/// After the second frame nothing is allocated. What one frame leaves for the next is held apart from it, in FrameState.
class ImagePool {
    struct Entry {
        void const* type;
        Extent size;
        std::shared_ptr<void> image;
        std::size_t bytes;
    };
    std::vector<Entry> entries;
    Extent extent;

    // Its address identifies the type, without RTTI. Not const: linkers may merge equal constants.
    template <class Image> static inline char type_key = 0;

public:
    explicit ImagePool(Extent size) : extent(size) {}

    /// An image of 1/fraction of the pool's width and height. What it holds is left over from others; its padding is zero.
    template <class Image> [[nodiscard]] PooledImage<Image> take(int fraction = 1) {
        if constexpr (HasPlanes<Image>) {
            PooledImage<Image> taken;
            for (auto& plane : taken.planes) plane = free_or_new<typename ViewIn<Image>::Plane>(divided(extent, fraction));
            return taken;
        } else
            return {free_or_new<Image>(divided(extent, fraction))};
    }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (auto const& e : entries) sum += e.bytes;
        return sum;
    }
    [[nodiscard]] Extent size() const { return extent; }
    /// Drops images that nobody holds. The next frame makes them again.
    void release() {
        std::erase_if(entries, [](Entry const& e) { return e.image.use_count() == 1; });
    }
    /// Drops images of another size. Those still held live until they are released.
    void resize(Extent new_size) {
        if (new_size == extent) return;
        entries.clear();
        extent = new_size;
    }

private:
    template <class Image> std::shared_ptr<Image> free_or_new(Extent size) {
        for (auto const& e : entries)
            if (e.type == &type_key<Image> && e.size == size && e.image.use_count() == 1) return std::static_pointer_cast<Image>(e.image);
        auto image = std::make_shared<Image>(size);
        entries.push_back({.type = &type_key<Image>, .size = size, .image = image, .bytes = image->bytes()});
        return image;
    }
};

/// Handles to the images of several channels. Each may be empty.
template <class Storage, class Set> struct Handles;
template <class Storage, class... Cs> struct Handles<Storage, Channels<Cs...>> : Slot<Cs, PooledImage<ImageOf<Storage, Cs>>>... {
    template <ChannelTag C> auto& operator[](C) { return slot<C>(*this); }
    /// Views of some of the channels; empty for empty handles.
    template <class... Ds> [[nodiscard]] auto views(Channels<Ds...>) const {
        return Views<Storage, Channels<Ds...>>{{view<Ds>(slot<Ds>(*this))}...};
    }
    void take_all(ImagePool& pool) { ((slot<Cs>(*this) = pool.take<ImageOf<Storage, Cs>>(Cs::fraction)), ...); }
    void drop_all() { ((slot<Cs>(*this) = {}), ...); }

private:
    template <ChannelTag C, class Image> static auto view(PooledImage<Image> const& image) {
        return image ? view_of<C>(image) : ViewOf<Storage, C>{};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

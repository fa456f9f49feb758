#pragma once

#include <quell/image/image_storage.hpp>

#include <array>
#include <memory>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

template <class Image> using ViewIn = decltype(std::declval<Image const&>().view());
template <class View> using PlanesOf = std::array<std::shared_ptr<typename View::Plane>, std::size_t{View::components}>;
/// Whether the components of an image may lie apart, each in an image of one component.
template <class Image>
concept HasPlanes = requires(PlanesOf<ViewIn<Image>> const& planes) {
    { ViewIn<Image>::of(planes) } -> std::same_as<ViewIn<Image>>;
};
/// The same for planes whose owners are elsewhere, which need not be counted then.
template <class Image>
concept TakesPlanes = HasPlanes<Image> &&
    requires(std::array<typename ViewIn<Image>::Plane const*, std::size_t{ViewIn<Image>::components}> const& planes) {
    { ViewIn<Image>::of(planes) } -> std::same_as<ViewIn<Image>>;
};

/// A type of images as a value: the pieces that one is made of. An image with planes has a piece per component, each of which may later be
/// part of another image; others are in one piece.
struct ImageFormat {
    void const* piece = nullptr; ///< its address identifies the type of a piece, without RTTI
    int pieces = 0;
    std::shared_ptr<void> (*make)(Extent) = nullptr; ///< makes a piece
    std::size_t (*bytes)(void const*) = nullptr;     ///< of a piece
};

/// A handle to an image of the pool, of any type; or empty.
struct PooledImage {
    static constexpr int most_pieces = 32;
    std::array<std::shared_ptr<void>, most_pieces> pieces;

    explicit operator bool() const { return pieces[0] != nullptr; }
    bool operator==(PooledImage const&) const = default;
};

// Not const: linkers may merge equal constants.
template <class Piece> inline char piece_key = 0;
template <class Piece, int pieces> constexpr ImageFormat format_of_pieces() {
    static_assert(pieces <= PooledImage::most_pieces, "a history holds images of at most 32 planes");
    return {&piece_key<Piece>, pieces, [](Extent size) -> std::shared_ptr<void> { return std::make_shared<Piece>(size); },
            [](void const* piece) { return static_cast<Piece const*>(piece)->bytes(); }};
}
template <class Image> constexpr ImageFormat format_of_image() {
    if constexpr (HasPlanes<Image>)
        return format_of_pieces<typename ViewIn<Image>::Plane, ViewIn<Image>::components>();
    else
        return format_of_pieces<Image, 1>();
}
template <class Image> ViewIn<Image> view_of_image(PooledImage const& image) {
    using View = ViewIn<Image>;
    if constexpr (TakesPlanes<Image>) {
        std::array<typename View::Plane const*, std::size_t{View::components}> planes;
        for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = static_cast<typename View::Plane const*>(image.pieces[i].get());
        return View::of(planes);
    } else if constexpr (HasPlanes<Image>) {
        PlanesOf<ViewIn<Image>> planes;
        for (std::size_t i = 0; i < planes.size(); ++i)
            planes[i] = std::static_pointer_cast<typename ViewIn<Image>::Plane>(image.pieces[i]);
        return ViewIn<Image>::of(planes);
    } else
        return static_cast<Image const*>(image.pieces[0].get())->view();
}

/// The format of a channel's images.
template <class Storage, ChannelTag C> inline constexpr ImageFormat format_of = format_of_image<ImageOf<Storage, C>>();
/// The view of a channel's image; empty for an empty handle.
template <class Storage, ChannelTag C> ViewOf<Storage, C> view_in(PooledImage const& image) {
    if (!image) return {};
    return in_format_of<C>(view_of_image<ImageOf<Storage, C>>(image));
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

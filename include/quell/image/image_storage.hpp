#pragma once

#include <quell/core/channel.hpp>
#include <quell/core/value.hpp>
#include <quell/image/extent.hpp>

#include <concepts>
#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A view of an image, which kernels take by value. Required:
///
///     Extent size;  static constexpr int components;
///     float get(int c, int x, int y) const;  void set(int c, int x, int y, float) const;
///
/// Optional, for packs; without these functions quell assembles packs lane by lane:
///
///     Value<N, Real> load<Real>(int x, int y) const;           // width_of<Real> pixels from (x, y) to the right; see below
///     Real load_component<Real>(int c, int x, int y) const;    // the same for one component
///     Value<N, Real> gather<Real>(Index x, Index y) const;     // scattered pixels, all inside the image
///     void store<Real>(int x, int y, Value<N, Real>) const;    // all lanes inside the image or in the row's padding
///     auto squares() const;                                    // a view that stores roots and gives and takes squares: see below
///
/// `load` must accept an x up to `width_of<Real>` pixels outside the row on either side. Lanes outside must be finite; their values are not
/// used.
template <class V>
concept ImageView = std::is_trivially_copyable_v<V> && requires(V const v, int i, float a) {
    { v.size } -> std::convertible_to<Extent>;
    { V::components } -> std::convertible_to<int>;
    { v.get(i, i, i) } -> std::same_as<float>;
    v.set(i, i, i, a);
};

/// Who owns the memory of images and how pixels are laid out: `Storage::Image<N>(size).view()` is an ImageView of N components. Histories
/// call
///
///     explicit Image(Extent size);  View view() const;  std::size_t bytes() const;    // what it takes
///
/// and hosts, which fill a frame,
///
///     Value<N, float> get(int x, int y) const;  void set(int x, int y, Value<N, float> const&);
///
/// `Storage::Exact` is the storage for channels with `full_precision`; a storage of 32-bit floats names itself. `Storage::Half`, if it has
/// one, is the storage for channels with `always_half`. Variances (`squared`) go to Exact, unless the views have `squares()`: a view of the
/// same memory, in a format that holds their roots. If its views have `View::Plane`, the type of an image of one component, and
/// `View::of(std::array<std::shared_ptr<Plane>, N>)`, a history puts images together from such planes, which takes less memory. One that
/// does not own its memory may name a storage that does, `Copy`, and make a view of its image, `View::of_copy(view)`: guides that have to
/// be repaired are copied there, and stay as they are otherwise. `Storage::Memory`, if it has one, is the ImageMemory in which a history
/// keeps the counts that kernels write. `Storage::ImageOf<C>`, if there is one, is the image of channel C, whatever the rest says: see
/// Subsampled. Models: Planar, Interleaved, Borrowed, Subsampled.
template <class S>
concept ImageStorage = requires(Extent size) {
    { typename S::template Image<3>(size).view() } -> ImageView;
    { typename S::Exact::template Image<3>(size).view() } -> ImageView;
};

/// Whether quell can allocate and write images of this storage: its `owns_memory`, or true.
template <class Storage> constexpr bool owns_memory() {
    if constexpr (requires { requires detail::is_constant<decltype(&Storage::owns_memory), bool>; })
        return Storage::owns_memory;
    else {
        static_assert(
            !requires(Storage const& storage) { storage.owns_memory; },
            "`owns_memory` of a storage must be `static constexpr bool`; any other member needs another name");
        return true;
    }
}

namespace detail {
template <class C> constexpr bool is_squared() {
    if constexpr (requires { C::squared; })
        return C::squared;
    else
        return false;
}
template <class View>
concept ViewsSquares = requires(View const& view) {
    { view.squares() } -> ImageView;
};
/// Whether a channel goes to S::Exact: it needs full precision, or it is squared and S has no format for squares.
template <ImageStorage S, ChannelTag C>
inline constexpr bool stored_exactly = C::full_precision ||
                                       (is_squared<C>() &&
                                        !ViewsSquares<decltype(std::declval<typename S::template Image<C::components> const&>().view())>);

/// The storage in which S keeps a channel.
template <ImageStorage S, ChannelTag C> constexpr auto storage_of() {
    if constexpr (requires {
                      requires C::always_half;
                      requires ImageStorage<typename S::Half>;
                  })
        return std::type_identity<typename S::Half>{};
    else if constexpr (stored_exactly<S, C>)
        return std::type_identity<typename S::Exact>{};
    else
        return std::type_identity<S>{};
}

/// The view of a channel, from that of its image: for a `squared` channel, in the format of squares if there is one.
template <ChannelTag C, class View> auto in_format_of(View const& view) {
    if constexpr (is_squared<C>() && ViewsSquares<View>)
        return view.squares();
    else
        return view;
}
template <ChannelTag C, class Image> auto view_of(Image const& image) { return in_format_of<C>(image.view()); }
} // namespace detail

namespace detail {
template <class Storage, ChannelTag C> constexpr auto image_of() {
    if constexpr (requires { typename Storage::template ImageOf<C>; })
        return std::type_identity<typename Storage::template ImageOf<C>>{};
    else
        return std::type_identity<typename decltype(storage_of<Storage, C>())::type::template Image<C::components>>{};
}
} // namespace detail

/// The image type in which a storage keeps a channel.
template <class Storage, ChannelTag C> using ImageOf = typename decltype(detail::image_of<Storage, C>())::type;
/// The view of that image.
template <class Storage, ChannelTag C> using ViewOf = decltype(detail::view_of<C>(std::declval<ImageOf<Storage, C> const&>()));

namespace detail {
QUELL_KERNEL int clamp_to(int i, int last) { return i < 0 ? 0 : i > last ? last : i; }

template <class Real, ImageView View> QUELL_KERNEL auto load_pixels(View const& view, int x, int y) {
    if constexpr (requires { view.template load<Real>(x, y); })
        return view.template load<Real>(x, y);
    else
        return make_value<View::components, Real>([&](auto c) {
            alignas(64) float lane[width_of<Real>];
            for (int i = 0; i < width_of<Real>; ++i) lane[i] = view.get(c, clamp_to(x + i, view.size.width - 1), y);
            if constexpr (width_of<Real> == 1)
                return lane[0];
            else
                return Real::load_aligned(lane);
        });
}

/// One component only, for channels of many components.
template <class Real, int c, ImageView View> QUELL_KERNEL Real load_one(View const& view, int x, int y) {
    if constexpr (requires { view.template load_component<Real>(c, x, y); })
        return view.template load_component<Real>(c, x, y);
    else
        return component<c>(load_pixels<Real>(view, x, y));
}

template <class Real, ImageView View> QUELL_KERNEL auto gather_pixels(View const& view, Index<Real> x, Index<Real> y) {
    if constexpr (requires { view.template gather<Real>(x, y); })
        return view.template gather<Real>(x, y);
    else
        return make_value<View::components, Real>([&](auto c) {
            alignas(64) float gathered[width_of<Real>];
            for (int i = 0; i < width_of<Real>; ++i) gathered[i] = view.get(c, lane(x, i), lane(y, i));
            if constexpr (width_of<Real> == 1)
                return gathered[0];
            else
                return Real::load_aligned(gathered);
        });
}

/// Stores the first `count` lanes one by one. Not inlined: it runs at the end of a row only and would be half of a kernel's code.
template <class Real, ImageView View>
QUELL_OUTLINED constexpr void store_lanes(View const& view, int x, int y, Value<View::components, Real> const& value, int count) {
    alignas(64) float stored[View::components][width_of<Real>];
    [&]<int... c>(std::integer_sequence<int, c...>) { (component<c>(value).store_aligned(stored[c]), ...); }
    (std::make_integer_sequence<int, View::components>{});
    for (int c = 0; c < View::components; ++c)
        for (int k = 0; k < count; ++k) view.set(c, x + k, y, stored[c][k]);
}

/// Stores the first `count` lanes.
template <class Real, ImageView View>
QUELL_KERNEL void store_pixels(View const& view, int x, int y, Value<View::components, Real> const& value, int count) {
    if constexpr (requires { view.template store<Real>(x, y, value); }) {
        if (count == width_of<Real>) return view.template store<Real>(x, y, value);
    }
    if constexpr (width_of < Real >> 1)
        store_lanes<Real>(view, x, y, value, count);
    else
        [&]<int... c>(std::integer_sequence<int, c...>) { (view.set(c, x, y, component<c>(value)), ...); }
    (std::make_integer_sequence<int, View::components>{});
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

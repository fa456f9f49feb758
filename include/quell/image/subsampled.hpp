#pragma once

#include <quell/core/permute.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/image/planar.hpp>
#include <quell/image/sample_pattern.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Stands where there is no sample: the ingest takes it for a missing one. It is finite, so that -ffast-math leaves it alone.
inline constexpr float no_sample = 1e30f;

/// A view of the frame's size of an image of fewer samples. Reading puts them where they belong.
/// @tparam Stored  view of the image that has the samples
/// @tparam repeats whether pixels without a sample have that of their block; else they have none
template <class Stored, SamplePattern pattern, bool repeats> struct SubsampledView {
    static constexpr int components = Stored::components, columns = pattern.columns, rows = pattern.rows;
    static constexpr SamplePattern samples = pattern;

    Stored stored;     ///< of the samples side by side, or of the frame's size
    Extent size;       ///< the frame's
    glm::ivec2 phase;  ///< from (0, 0) to (columns - 1, rows - 1)
    bool side_by_side; ///< whether `stored` holds samples only

    QUELL_KERNEL float get(int c, int x, int y) const {
        auto const at = pattern.pixel(x / columns, y / rows, phase);
        auto const place = in_stored(x / columns, y / rows, at);
        bool const has = place.x < stored.size.width && place.y < stored.size.height;
        if (!repeats && !(has && at == glm::ivec2(x, y))) return no_sample;
        return stored.get(c, clamp_to(place.x, stored.size.width - 1), clamp_to(place.y, stored.size.height - 1));
    }
    QUELL_KERNEL Value<components, float> const get(int x, int y) const {
        return make_value<components, float>([&](auto c) QUELL_INLINED { return get(c, x, y); });
    }
    /// Pixels without a sample stay without one.
    QUELL_KERNEL void set(int c, int x, int y, float a) const {
        auto const at = pattern.pixel(x / columns, y / rows, phase);
        if (auto const place = in_stored(x / columns, y / rows, at); at == glm::ivec2(x, y)) stored.set(c, place.x, place.y, a);
    }
    template <class Real> QUELL_KERNEL Value<components, Real> load(int x, int y) const {
        if constexpr (width_of<Real> == 1)
            return make_value<components, Real>([&](auto c) QUELL_INLINED { return get(c, clamp_to(x, size.width - 1), y); });
        else if constexpr (repeats)
            return make_value<components, Real>(
                [&](auto c) QUELL_INLINED { return generate<Real>([&](int i) { return get(c, clamp_to(x + i, size.width - 1), y); }); });
        else
            return load_samples<Real>(x, y);
    }

private:
    QUELL_KERNEL glm::ivec2 in_stored(int column, int row, glm::ivec2 pixel) const {
        return side_by_side ? glm::ivec2(column, row) : pixel;
    }
    template <class Real> QUELL_KERNEL Value<components, Real> load_samples(int x, int y) const {
        int const row = y / rows, stored_row = side_by_side ? row : y;
        if (y % rows != phase.y || stored_row >= stored.size.height) return splat<Value<components, Real>>(Real(no_sample));
        int const block = x >= 0 ? x / columns : -((columns - 1 - x) / columns), first = side_by_side ? block : x;
        auto const from = static_cast<float>(x - block * columns); // of the first lane, in its block
        auto const blocks = floor((lanes<Real>() + (from + 0.5f)) * (1.f / columns));
        auto const column = lanes<Real>() + from - blocks * static_cast<float>(columns);
        auto const wanted = static_cast<float>(pattern.column_in_block(row, phase));
        auto has = abs(column - wanted) < Real(0.5f);
        if (side_by_side) has = both(has, blocks < Real(static_cast<float>(stored.size.width - block)));
        auto const run = load_pixels<Real>(stored, first, stored_row);
        return map([&](auto lane_run)
                       QUELL_INLINED { return select(has, side_by_side ? spread(lane_run, blocks) : lane_run, Real(no_sample)); },
                   run);
    }
    /// Lane i is lane `blocks`[i].
    template <class Real> QUELL_KERNEL static Real spread(Real const& run, Real const& blocks) {
        if constexpr (columns == 1)
            return run;
        else if constexpr (permutes<Real>)
            return permuted(run, run, truncate(blocks));
        else {
            auto const place = truncate(blocks);
            return generate<Real>([&](int i) QUELL_INLINED { return lane(run, lane(place, i)); });
        }
    }
};

/// The image of a channel that has fewer samples than the frame has pixels.
/// @tparam Stored an image of the storage within
template <class Stored, SamplePattern pattern, bool repeats> class SubsampledImage {
    Extent extent;

public:
    static constexpr int components = Stored::components; ///< per pixel
    /// The samples: side by side, as SamplePattern::stored() says, or in an image of the frame's size, of which other pixels are not read.
    Stored stored{};
    /// Which pixel of each block they are of, in this frame. Numbers beyond a block count on in the next.
    glm::ivec2 phase{0};

    SubsampledImage() = default;
    explicit SubsampledImage(Extent size) : extent(size), stored(pattern.stored(size)) {}
    /// From now on these are the samples. The phase stays.
    SubsampledImage& operator=(Stored image) {
        stored = std::move(image);
        return *this;
    }

    /// A pixel; without a sample, a number that is none.
    [[nodiscard]] Value<components, float> const get(int x, int y) const { return view().get(x, y); }
    [[nodiscard]] float get(int c, int x, int y) const { return view().get(c, x, y); }
    /// Sets a pixel that has a sample; others stay without one.
    void set(int x, int y, Value<components, float> const& value) {
        auto const to = view();
        [&]<int... c>(std::integer_sequence<int, c...>) { (to.set(c, x, y, component<c>(value)), ...); }
        (std::make_integer_sequence<int, components>{});
    }
    [[nodiscard]] Extent size() const { return extent; }               ///< the frame's
    [[nodiscard]] std::size_t bytes() const { return stored.bytes(); } ///< what the samples take
    [[nodiscard]] auto view() const {
        auto const inside = [](int i, int n) { return (i % n + n) % n; };
        return SubsampledView<decltype(stored.view()), pattern, repeats>{
            stored.view(), extent, {inside(phase.x, pattern.columns), inside(phase.y, pattern.rows)}, !(stored.size() == extent)};
    }
};
} // namespace detail

/// Image storage of a frame in which some channels have fewer samples than the frame has pixels: reflections at half size, shadows in every
/// second pixel. The guides stay as they are.
///
///     Frame frame{size, reflections, Subsampled<half_size, Channels<Glossy, GlossyHit, GlossyHitPrevious>, Borrowed<>>{}};
///     frame[glossy] = {pointer, half, 4, 4 * half.width}; // as ever, with the size of the samples' image
///     frame[glossy].phase = half_size.phase(number);      // each frame: which pixel of each 2x2 they are of
///
/// Pixels of a signal that have no sample are missing ones: their history goes on, and without one their neighbours stand in. Other
/// channels of the set (what the ray of the sample has hit) have that of the sample in their block. An image of the frame's size will do
/// too: then only pixels that have a sample are read. Several patterns in one frame: Subsampled<checkerboard, Channels<Visibility>,
/// Subsampled<half_size, Channels<Glossy>>>.
/// @tparam pattern which pixels have a sample
/// @tparam Set     Channels<...>: those of which there are fewer samples
/// @tparam Within  the storage that images lie in
template <SamplePattern pattern, class Set, class Within = Planar<>> struct Subsampled {
    static_assert(pattern.columns >= 1 && pattern.columns <= 8 && pattern.rows >= 1 && pattern.rows <= 8,
                  "Subsampled<pattern, Channels<...>, Storage>: a block of the pattern has 1 to 8 columns and rows");
    static_assert(ImageStorage<Within>, "Subsampled<pattern, Channels<...>, Storage>: `Storage` must be Planar<>, Borrowed<> or another "
                                        "storage, see quell/image/image_storage.hpp");
    using Exact = Subsampled<pattern, Set, typename Within::Exact>; ///< storage of channels that need 32 bits
    using Others = Within;                                          ///< storage of the channels that are not of the set
    static constexpr bool owns_memory = false;                      ///< a history cannot use it
    static constexpr auto name = "subsampled";                      ///< for messages
    /// An image of a channel that is not of the set.
    template <int N> using Image = typename Within::template Image<N>;
    /// Whether pixels without a sample have that of their block; in a signal they have none.
    template <ChannelTag C> static constexpr bool repeats = C::full_precision || C::finite_on_surfaces;
    /// The image of a channel.
    template <ChannelTag C>
    using ImageOf = std::conditional_t<Set::template has<C>, detail::SubsampledImage<quell::ImageOf<Within, C>, pattern, repeats<C>>,
                                       quell::ImageOf<Within, C>>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

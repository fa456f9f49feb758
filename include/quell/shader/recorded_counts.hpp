#pragma once

#include <quell/pipeline/ingest.hpp>
#include <quell/shader/recorded_taps.hpp>

/// @file
/// Counts of the ingest as passes of their own: sums of 8x8 pixels, and sums of 8x8 of these. A host adds up what is left.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What is counted of a pixel of the ingest, in order: of the host's samples and guides.
template <class Pass> struct CountsOfSamples;
template <ChannelTag Input, Modulation Form, class Suppression, class Guides>
struct CountsOfSamples<Ingest<Input, Form, Suppression, Guides>> {
    static constexpr std::size_t size = 1 + (Guides::size > 0 ? 1 + Guides::size : 0);
    static constexpr bool takes_given_guides = true;
    static constexpr auto signal = Input::name;

    static std::vector<std::string> names() {
        std::vector<std::string> all{"missing samples"};
        if constexpr (Guides::size > 0) all.push_back("impossible guides");
        for_each_channel(Guides{}, [&]<class C>(C) { all.push_back("impossible " + std::string(C::name)); });
        return all;
    }
    static std::array<Recorded, size> of(auto const&, auto const& px) {
        std::array<Recorded, size> all;
        std::size_t next = 0;
        auto const add = [&](RecordedMask mask) { all[next++] = masked(mask, Recorded(1.f)); };
        add(invert(is_light(px[Input{}])));
        if constexpr (Guides::size > 0) add(impossible_guides<Guides>(px) > Recorded(0.f));
        for_each_channel(Guides{}, [&]<class C>(C) {
            auto const bad = invert(Repair<C>::possible(px[C{}]));
            add(std::is_same_v<C, Normal> ? both(bad, shows_surface<Guides>(px)) : bad);
        });
        return all;
    }
};
/// What the ingest takes away, with guides as they are repaired. Of no size where it takes nothing.
template <class Pass> struct CountsOfLight;
template <ChannelTag Input, Modulation Form, class Suppression, class Guides>
struct CountsOfLight<Ingest<Input, Form, Suppression, Guides>> {
    static constexpr std::size_t size = !std::is_same_v<Suppression, NoSuppression>;
    static constexpr bool takes_given_guides = false;
    static constexpr auto signal = Input::name;

    static std::vector<std::string> names() { return {"suppressed light"}; }
    static std::array<Recorded, size> of(auto const& ingest, auto const& px) { return {max(ingest(px).more[Suppressed{}], Recorded(0.f))}; }
};
template <class Pass>
concept IsCounted = requires {
    CountsOfSamples<Pass>::size;
};

/// The sums of squares of 8x8, of what `numbers(column, row)` says of each.
/// @param fraction of the plane that they are sums of, as its size is
template <std::size_t count> std::array<Recorded, count> sums_of_squares(int fraction, auto const& numbers) {
    auto const x = recorded_leaf<RecordedInteger>(Operation::this_column, 0), y = recorded_leaf<RecordedInteger>(Operation::this_row, 0);
    auto const size = recorded_size(fraction);
    std::array<Recorded, count> sums;
    sums.fill(Recorded(0.f));
    auto const add = [&](Recorded turn) {
        auto const down = floor(turn * 0.125f);
        auto const column = x * 8 + truncate(turn - down * 8.f), row = y * 8 + truncate(down);
        auto const inside = column < size.width & row < size.height;
        auto const values = numbers(within(column, size.width), within(row, size.height));
        for (std::size_t i = 0; i < count; ++i) sums[i] = sums[i] + masked(inside, values[i]);
    };
    for_each_turn(Recorded(64.f), add, sums);
    return sums;
}
/// The place of a number of a square: blocks of all squares, one below the other.
inline RecordedInteger place_of_sum(int fraction, std::size_t number, RecordedInteger column, RecordedInteger row) {
    auto const size = recorded_size(fraction), frame = recorded_size(1);
    auto const place = (row + RecordedInteger(static_cast<std::int32_t>(number)) * size.height) * size.width + column;
    return within(place, frame.width * frame.height); // images of fewer pixels than there are numbers
}
inline void store_sums(auto const& sums, int fraction, void const* memory) {
    auto const x = recorded_leaf<RecordedInteger>(Operation::this_column, 0), y = recorded_leaf<RecordedInteger>(Operation::this_row, 0);
    auto const plane = pass_recording->plane(memory);
    for (std::size_t i = 0; i < sums.size(); ++i)
        graph_builder->add({Operation::store, {sums[i].node, place_of_sum(fraction, i, x, y).node}, plane});
}
/// Counts of pixels, summed over squares.
template <class Counted, class Job> void record_counts_of_pixels(Job const& job, void const* to) {
    using Px = Pixel<Recorded, decltype(Job::scope), 1>;
    auto const of_pixel = [&](RecordedInteger column, RecordedInteger row) { return Counted::of(job.pass, Px{job.scope, column, row}); };
    store_sums(sums_of_squares<Counted::size>(1, of_pixel), 8, to);
}
/// The sums of these.
template <std::size_t count> void record_sums_of_counts(void const* from, void const* to) {
    auto const plane = pass_recording->plane(from);
    auto const of_square = [&](RecordedInteger column, RecordedInteger row) {
        std::array<Recorded, count> all;
        for (std::size_t i = 0; i < count; ++i)
            all[i].node = graph_builder->add({Operation::load, {place_of_sum(8, i, column, row).node}, plane});
        return all;
    };
    store_sums(sums_of_squares<count>(8, of_square), 64, to);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

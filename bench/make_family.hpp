#pragma once

#include "family.hpp"

#include <quell/presets/named.hpp>

#include <algorithm>

namespace quell::bench {

/// What generated files instantiate.
template <class P, class Storage, bool with_serial> class PresetWorkload final : public Workload {
    P pipeline;
    History<P, Storage> history;

public:
    PresetWorkload(P const& p, Extent size) : pipeline(p), history(size, p) {}
    void run(Input const& frame, How how) override { quell::run(pipeline, frame, history, Timed<Chosen<with_serial>>{{how}, &taken}); }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

/// The names under which passes are reported: no spaces, and several of one name numbered.
template <class P> std::vector<std::string> pass_names(P const& pipeline) {
    std::vector<std::string> names{pipeline.ingest.name};
    pipeline.for_each_pass([&](auto const& pass) { names.push_back(pass.name); });
    if (names.size() == 1) names.push_back(detail::PassThrough::name);
    auto const all = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::ranges::replace(names[i], ' ', '-');
        if (std::ranges::count(all, all[i]) > 1)
            names[i] += "/level" + std::to_string(std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), all[i]));
    }
    return names;
}

template <class Storage, class Preset> Family make_family(Preset const& preset, std::size_t order) {
    using P = decltype(Preset::usual());
    using Format = typename Storage::format;
    // One pixel at a time is the reference for the fast storage only; elsewhere it would double the time to compile for nothing.
    constexpr bool with_serial = std::is_same_v<Storage, Planar<>>;
    return {std::string(preset.name),
            order,
            std::string(Storage::name) + "-" + Format::name,
            sizeof(typename Format::Element),
            with_serial,
            pass_names(Preset::usual()),
            [](Extent size) -> std::unique_ptr<Workload> {
                return std::make_unique<PresetWorkload<P, Storage, with_serial>>(Preset::usual(), size);
            }};
}

/// Whether the sequence has what a pipeline reads.
template <class P> inline constexpr bool is_measured = contained_in<typename P::reads, Input::channels>;

template <class Storage, std::size_t unit, std::size_t units> std::vector<Family> families_of_unit() {
    std::vector<Family> made;
    std::size_t order = unit;
    for_each_preset<unit, units>([&](auto const& preset) {
        if constexpr (is_measured<decltype(preset.usual())>) made.push_back(make_family<Storage>(preset, order));
        order += units;
    });
    return made;
}

} // namespace quell::bench

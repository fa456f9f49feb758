#pragma once

#include "family.hpp"
#include "traced_sequence.hpp"

#include <quell/pipeline/plan.hpp>
#include <support/name_list.hpp>

#include <algorithm>

namespace quell::bench {

/// Whether the made-up sequence has what a pipeline reads.
template <class P> inline constexpr bool reads_input = contained_in<typename P::reads, Input::channels>;

template <class P> auto const& frames_for(Extent size) {
    if constexpr (reads_input<P>)
        return sequence(size);
    else
        return traced_sequence<blurs<P>>(size);
}

/// What generated files instantiate.
template <class P, class Storage, bool with_serial> class PresetWorkload final : public Workload {
    P pipeline;
    History<P, Storage> history;
    Extent size;

public:
    PresetWorkload(P const& p, Extent s) : pipeline(p), history(s, p), size(s) {}
    void run(std::size_t frame, How how) override {
        quell::run(pipeline, frames_for<P>(size)[frame], history, Timed<Chosen<with_serial>>{{how}, &taken});
    }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

/// The names under which passes are reported: no spaces, and several of one name numbered.
template <class P> std::vector<std::string> pass_names(P const& pipeline) {
    std::vector<std::string> names;
    for (auto const& pass : plan_of(pipeline).passes) names.emplace_back(pass.name);
    auto const all = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::ranges::replace(names[i], ' ', '-');
        if (std::ranges::count(all, all[i]) > 1)
            names[i] += "/" + std::to_string(std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), all[i]));
    }
    return names;
}

template <class Storage, class Preset> Family make_family(Preset const& preset, std::size_t order) {
    using P = decltype(Preset::usual());
    using Format = typename Storage::format;
    // One pixel at a time is a reference: everywhere, it would double the time to compile for nothing.
    constexpr bool with_serial = std::is_same_v<Storage, Planar<>> && reads_input<P>;
    return {std::string(preset.name),
            order,
            std::string(Storage::name) + "-" + Format::name,
            with_serial,
            pass_names(Preset::usual()),
            [](Extent size) -> std::unique_ptr<Workload> {
                return std::make_unique<PresetWorkload<P, Storage, with_serial>>(Preset::usual(), size);
            }};
}

/// Whether there are frames for a pipeline.
template <class P> inline constexpr bool is_measured = QUELL_BENCH_TRACES || reads_input<P>;

template <class Storage, std::size_t unit, std::size_t units> std::vector<Family> families_of_unit() {
    std::vector<Family> made;
    for_each_preset_index<unit, units>([&](auto i) {
        constexpr auto const& preset = std::get<i>(named_presets);
        if constexpr (examples::is_chosen(QUELL_BENCH_PRESETS, preset.name) && is_measured<decltype(preset.usual())>)
            made.push_back(make_family<Storage>(preset, i));
    });
    return made;
}

} // namespace quell::bench

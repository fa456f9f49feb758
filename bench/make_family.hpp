#pragma once

#include "family.hpp"
#include "sequence.hpp"

#include <baselines/named.hpp>
#include <library/name_list.hpp>
#include <library/preset_share.hpp>
#include <quell/pipeline/plan.hpp>

namespace quell::bench {

/// What generated files instantiate.
/// @tparam with_serial whether it runs one pixel after the other, and not in packs
template <class P, class Storage, bool with_serial> class PresetWorkload final : public Workload {
    P pipeline;
    History<P, Storage> history;
    Extent size;

public:
    PresetWorkload(P const& p, Extent s) : pipeline(p), history(s, p), size(s) {}
    void run(std::size_t frame, How how) override {
        using E = std::conditional_t<with_serial, Serial, Chosen>;
        auto const executor = [&] {
            if constexpr (with_serial)
                return E{};
            else
                return E{how};
        }();
        quell::run(pipeline, sequence(size)[frame], history, Timed<E>{executor, &taken});
    }
    [[nodiscard]] double bytes_per_pixel() const override { return history.bytes_per_pixel(); }
};

template <class Storage, class Preset> Family make_family(Preset const& preset) {
    using P = decltype(Preset::usual());
    using Format = typename Storage::format;
    constexpr bool with_serial = std::is_same_v<Storage, Planar<>>;
    std::vector<std::string> passes;
    for (auto const& pass : plan_of(Preset::usual()).passes) passes.emplace_back(pass.name);
    Family family{std::string(preset.name), std::string(Storage::name) + "-" + Format::name, pass_names(passes)};
    auto const make = [](Extent size) -> std::unique_ptr<Workload> {
        return std::make_unique<PresetWorkload<P, Storage, with_serial>>(Preset::usual(), size);
    };
    if constexpr (with_serial)
        family.make_serial = make;
    else
        family.make = make;
    return family;
}

/// Whether a preset is measured with a storage. One pixel at a time is a reference: of what reads more, it would take minutes to compile.
template <class Storage>
inline constexpr auto is_wanted = [](auto const& preset) {
    using Reads = typename decltype(preset.usual())::reads;
    return quell_library::is_chosen(QUELL_BENCH_PRESETS, preset.name) &&
           (!std::is_same_v<Storage, Planar<>> || contained_in<Reads, Channels<Radiance, Depth, Normal, Motion, Albedo>>);
};

template <class Storage, std::size_t unit, std::size_t units> std::vector<Family> families_of_unit() {
    std::vector<Family> made;
    for_each_preset_index(all_presets, [&](auto i) {
        constexpr auto const& preset = std::get<i>(all_presets);
        if constexpr (is_wanted<Storage>(preset))
            if constexpr (quell_library::share_of_preset<units>(i, is_wanted<Storage>) == unit)
                made.push_back(make_family<Storage>(preset));
    });
    return made;
}

} // namespace quell::bench

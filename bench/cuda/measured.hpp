#pragma once

#include "scene.hpp"

#include <quell/image/managed.cuh>
#include <quell/presets/named.hpp>

#include <string>
#include <vector>

// What main.cu asks of each preset; presets.cu answers, in several files side by side.
namespace quell::bench {

/// A preset that is run: all but the published ones.
template <std::size_t i> inline constexpr bool is_run = std::get<i>(named_presets).group != PresetGroup::published;

namespace detail {
template <std::size_t i>
using ReadsOfPreset =
    std::conditional_t<is_run<i>, typename decltype(std::remove_cvref_t<decltype(std::get<i>(named_presets))>::usual())::reads, Channels<>>;
template <std::size_t... i> union_of<ReadsOfPreset<i>...> all_reads(std::index_sequence<i...>);
} // namespace detail

/// A frame with all that these presets read.
using Input = Frame<decltype(detail::all_reads(std::make_index_sequence<preset_count>{})), Managed<>>;

/// How far Cuda's pictures are from those of Serial, over all frames.
struct Agreement {
    double worst = 0;         ///< greatest difference, relative to max(1, value)
    double apart = 0;         ///< part of the components that differ by more than `allowed`
    bool counts_equal = true; ///< of missing samples
    static constexpr double allowed = 1e-3, allowed_apart = 1e-3;

    [[nodiscard]] bool good() const { return counts_equal && apart <= allowed_apart; }
};

/// A pass on the device.
struct PassCost {
    std::string name;
    double milliseconds = 0; ///< of the device
    int registers = 0;
    std::size_t local_bytes = 0; ///< per thread
};
struct Cost {
    double milliseconds = 0; ///< by the host's clock
    std::vector<PassCost> passes;
};

struct Measured {
    std::string name;
    std::size_t order; ///< among named_presets
    Agreement (*agreement)(Input& frame, int frames);
    Cost (*cost)(std::vector<Input> const& frames, int rounds);
};
/// Filled by the files of presets.cu before main().
inline std::vector<Measured>& measured_presets() {
    static std::vector<Measured> all;
    return all;
}

} // namespace quell::bench

// The entry of the library's code for one instruction set: QUELL_CODE_ENTRY is its name.
#include "preset_code.hpp"

#include <support/preset_units.hpp>

namespace quell_library {

template <std::size_t unit, std::size_t units> std::vector<PresetCode> codes_of_unit();

namespace {
constexpr std::size_t units = QUELL_PRESET_UNITS;

std::vector<PresetCode> all_units() {
    return []<std::size_t... i>(std::index_sequence<i...>) { return quell::examples::in_order(std::array{codes_of_unit<i, units>()...}); }
    (std::make_index_sequence<units>{});
}
} // namespace

} // namespace quell_library

extern "C" quell_library::PresetCodes QUELL_CODE_ENTRY;
extern "C" std::vector<quell_library::PresetCode> const& QUELL_CODE_ENTRY() {
    static std::vector<quell_library::PresetCode> const all = quell_library::all_units();
    return all;
}

#include "errors.hpp"

#include <algorithm>

namespace quell::bench {

void mark_flicker(std::vector<Wanted>& wanted) {
    std::size_t begin = 0, end = 0, longest = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (i > 0 && wanted[i].frame != wanted[i - 1].frame + 1) begin = i;
        if (i + 1 - begin > longest) end = i + 1, longest = end - begin;
    }
    for (auto i = end - std::min<std::size_t>(longest, 4); i < end; ++i) wanted[i].shows_flicker = true;
}

void MethodErrors::add(Wanted const& wanted, metrics::Picture const& shown) {
    metrics::Comparison const compared{wanted.displayed, shown};
    whole.add(metrics::errors_of(compared));
    flip_medians += compared.difference.weighted_median();
    if (std::ranges::any_of(wanted.mask, [](auto m) { return m != 0; })) masked.add(metrics::errors_of(compared, wanted.mask));
    if (wanted.shows_flicker) flicker.add(wanted.displayed, shown);
}

void MethodErrors::put(Row& row) const {
    row.errors = whole.mean(), row.mask_errors = masked.mean();
    if (whole.count > 0) row.flip_median = flip_medians / whole.count;
    if (flicker.frames > 1) row.flicker = flicker.mean();
}

} // namespace quell::bench

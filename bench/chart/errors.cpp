#include "errors.hpp"

#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>

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

void ErrorSums::add(Wanted const& wanted, metrics::Picture const& shown) {
    auto const difference = metrics::flip(wanted.displayed, shown);
    rmse += metrics::rmse(wanted.displayed, shown), ssim += metrics::ssim(wanted.displayed, shown);
    flip += difference.mean(), flip_median += difference.weighted_median(), ++frames;
    if (std::ranges::any_of(wanted.mask, [](auto m) { return m != 0; })) {
        mask_rmse += metrics::rmse(wanted.displayed, shown, wanted.mask), mask_ssim += metrics::ssim(wanted.displayed, shown, wanted.mask);
        mask_flip += difference.mean(wanted.mask), ++masked_frames;
    }
    if (wanted.shows_flicker) flicker.add(wanted.displayed, shown);
}

void ErrorSums::put(Row& row) const {
    if (frames > 0) row.rmse = rmse / frames, row.ssim = ssim / frames, row.flip = flip / frames, row.flip_median = flip_median / frames;
    if (masked_frames > 0)
        row.mask_rmse = mask_rmse / masked_frames, row.mask_ssim = mask_ssim / masked_frames, row.mask_flip = mask_flip / masked_frames;
    if (flicker.frames > 1) row.flicker = flicker.mean();
}

} // namespace quell::bench

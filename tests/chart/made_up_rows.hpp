#pragma once

#include "../temporary_folder.hpp"
#include "chart/row.hpp"

#include <string>
#include <vector>

namespace quell::bench {

/// Rows of no run, for the plot and the page: two scenes with two effects, an input that doesn't compete, and a method
/// of which not all is known.
inline std::vector<Row> made_up_rows() {
    std::vector<Row> rows;
    auto const add = [&](std::string scene, std::string effect, std::string method, double ms, double rmse) -> Row& {
        Row row{.scene = std::move(scene), .effect = std::move(effect), .method = std::move(method), .size = {480, 270}, .frames = 41};
        row.threads = 2, row.ms_per_frame = ms, row.bytes_per_pixel = 10 * ms;
        row.errors["rmse"] = rmse, row.errors["ssim"] = 1 - 4 * rmse, row.errors["flip"] = 2 * rmse, row.flip_median = rmse;
        row.mask_errors["rmse"] = 3 * rmse, row.mask_errors["ssim"] = 1 - 8 * rmse, row.mask_errors["flip"] = 3 * rmse;
        row.flicker = 0.05 - 0.5 * rmse; // the most accurate flickers most
        return rows.emplace_back(std::move(row));
    };
    for (std::string const scene : {"fence", "temple"}) {
        std::string const effect = scene == "fence" ? "shadow" : "glossy";
        double const scale = scene == "fence" ? 1. : 0.6;
        add(scene, effect, "none", 0.2, 0.09 * scale);
        add(scene, effect, "surface", 1.5, 0.06 * scale);
        add(scene, effect, "surface-clamp", 2.1, 0.062 * scale);
        add(scene, effect, "svgf", 15, 0.03 * scale);
        add(scene, effect, "none-16spp", 0.2, 0.02).competes = false;
        auto& other = add(scene, effect, "other", 40, 0.028 * scale);
        other.bytes_per_pixel = other.flicker = Row::unknown;
    }
    return rows;
}

} // namespace quell::bench

#pragma once

#include <optional>
#include <string>

namespace quell::bench {

/// What a composition costs and how far from the reference its displayed picture is, in the mean over the scored frames.
struct Figures {
    double ms = 0, rmse = 0, bytes_per_pixel = 0;
    std::optional<double> flip{}; ///< where it was measured: it takes long
};

/// What a composition must keep to; at least one of these.
struct Bounds {
    std::optional<double> rmse, flip, ms;

    [[nodiscard]] bool in_time(Figures const& f) const { return !ms || f.ms <= *ms; }
    [[nodiscard]] bool asks_for_error() const { return rmse || flip; }
    [[nodiscard]] bool accurate(Figures const& f) const { return (!rmse || f.rmse <= *rmse) && (!flip || (f.flip && *f.flip <= *flip)); }
    [[nodiscard]] bool met_by(Figures const& f) const { return in_time(f) && accurate(f); }
};

/// As in "RMSE 0.05 or less".
[[nodiscard]] std::string to_string(Bounds const& bounds);
/// As in "8.31 ms, RMSE 0.0412".
[[nodiscard]] std::string to_string(Figures const& figures);

} // namespace quell::bench

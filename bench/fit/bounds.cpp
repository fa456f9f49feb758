#include "bounds.hpp"

#include <fmt/format.h>

#include <vector>

namespace quell::bench {
std::string to_string(Bounds const& bounds) {
    std::vector<std::string> list;
    if (bounds.rmse) list.push_back(fmt::format("RMSE {:g} or less", *bounds.rmse));
    if (bounds.flip) list.push_back(fmt::format("FLIP {:g} or less", *bounds.flip));
    if (bounds.ms) list.push_back(fmt::format("{:g} ms or less", *bounds.ms));
    return fmt::format("{}", fmt::join(list, ", "));
}

std::string to_string(Figures const& figures) {
    auto text = fmt::format("{:.2f} ms, RMSE {:.6f}", figures.ms, figures.rmse);
    if (figures.flip) text += fmt::format(", FLIP {:.6f}", *figures.flip);
    return text;
}

} // namespace quell::bench

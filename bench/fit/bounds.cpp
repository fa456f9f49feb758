#include "bounds.hpp"

#include <fmt/format.h>

namespace quell::bench {
namespace {

void append(std::string& list, std::string const& item) { list += (list.empty() ? "" : ", ") + item; }

} // namespace

std::string to_string(Bounds const& bounds) {
    std::string list;
    if (bounds.rmse) append(list, fmt::format("RMSE {:g} or less", *bounds.rmse));
    if (bounds.flip) append(list, fmt::format("FLIP {:g} or less", *bounds.flip));
    if (bounds.ms) append(list, fmt::format("{:g} ms or less", *bounds.ms));
    return list;
}

std::string to_string(Figures const& figures) {
    auto text = fmt::format("{:.2f} ms, RMSE {:.6f}", figures.ms, figures.rmse);
    if (figures.flip) text += fmt::format(", FLIP {:.6f}", *figures.flip);
    return text;
}

} // namespace quell::bench

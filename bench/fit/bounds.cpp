#include "bounds.hpp"

#include <cstdio>

namespace quell::bench {
namespace {

std::string number(char const* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

void append(std::string& list, std::string const& item) { list += (list.empty() ? "" : ", ") + item; }

} // namespace

std::string to_string(Bounds const& bounds) {
    std::string list;
    if (bounds.rmse) append(list, "RMSE " + number("%g", *bounds.rmse) + " or less");
    if (bounds.flip) append(list, "FLIP " + number("%g", *bounds.flip) + " or less");
    if (bounds.ms) append(list, number("%g", *bounds.ms) + " ms or less");
    return list;
}

std::string to_string(Figures const& figures) {
    auto text = number("%.2f", figures.ms) + " ms, RMSE " + number("%.6f", figures.rmse);
    if (figures.flip) text += ", FLIP " + number("%.6f", *figures.flip);
    return text;
}

} // namespace quell::bench

#pragma once

#include "report/report.hpp"

namespace quell::examples {

struct PictureSize {
    unsigned width = 0;
    unsigned height = 0;
};

/// The size that a PNG file in memory declares; the subject names it where it is no PNG file and Error is thrown.
PictureSize png_size(std::vector<unsigned char> const& bytes, std::string const& subject);

/// Throws Error where the report contradicts itself, so that a mistake shows where it is made and not as a hole in the page.
void check_report(Report const& report);

} // namespace quell::examples

#pragma once

#include "report/report.hpp"

namespace quell::examples::sample {

/// A report with all that a page can show; odd frames lack the reference and the error map.
Report make_report(int width, int height, int frame_count);

/// A report with one frame of one kind, no metrics, no tables and no notes.
Report make_bare_report();

/// A report without pictures, like that of quell-stability: many methods in a metric, and tables of long names without spaces.
Report make_report_of_figures();

} // namespace quell::examples::sample

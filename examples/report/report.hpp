#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace quell::examples {

/// How a picture's colours stand for numbers: evenly spaced stops from low to high.
struct ColorScale {
    std::string label; ///< what the numbers are, e.g. "FLIP error"
    double low = 0;
    double high = 1;
    std::vector<std::string> colors; ///< CSS colours, e.g. "#1a2b3c"; at least two
};

/// The scale in which FLIP's authors draw their error maps: magma, from 0 (same) to 1 (as different as can be).
ColorScale flip_color_scale();

/// One sort of picture that frames may have. The page opens with the first two kinds side by side.
struct PictureKind {
    std::string name;             ///< e.g. "noisy"; a series of the same name is taken to measure these pictures
    std::string description = {}; ///< one line, shown as a tooltip
    std::optional<ColorScale> scale = {};
};

/// The pictures of one frame, as PNG files in memory, by the names of their kinds. A frame may lack any of them.
struct ReportFrame {
    int number = 0;
    std::map<std::string, std::vector<unsigned char>> pictures = {};
};

/// A number at a frame. One that isn't finite leaves a gap in the plot.
struct ReportPoint {
    int frame = 0;
    double value = 0;
};

struct ReportSeries {
    std::string name;
    std::vector<ReportPoint> points = {}; ///< by ascending frame
};

/// A quantity that is plotted over the frames, e.g. "FLIP" for the series "noisy" and "denoised".
struct ReportMetric {
    std::string name;
    std::string unit = {}; ///< e.g. "0 to 1" or "ms"; empty for none
    std::string hint = {}; ///< e.g. "lower is better"
    std::vector<ReportSeries> series = {};
};

/// Figures in words: every row has as many cells as there are columns.
struct ReportTable {
    std::string caption;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// A remark such as the machine, the scene or the command line.
struct ReportNote {
    std::string label;
    std::string text;
    bool code = false; ///< set in a fixed-width face, with a button that copies it
};

/// All that a report page shows. Text is UTF-8; frames come by ascending number; all pictures are drawn at the size of the first.
struct Report {
    std::string title;
    std::string subtitle = {};
    std::vector<PictureKind> kinds = {};
    std::vector<ReportFrame> frames = {};
    std::vector<ReportMetric> metrics = {};
    std::vector<ReportTable> tables = {};
    std::vector<ReportNote> notes = {};

    /// Appends a value to a series of a metric, making either where the report lacks it.
    void add_value(std::string const& metric, std::string const& series, int frame, double value);
};

/// Writes the report as one HTML file that needs no other file and no network. The file appears whole or not at all.
/// Throws quell::Error where the report contradicts itself or the file can't be written.
void write_report(Report const& report, std::filesystem::path const& file);

} // namespace quell::examples

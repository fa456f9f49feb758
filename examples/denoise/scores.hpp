#pragma once

#include <support/image_errors.hpp>

#include <ostream>

namespace quell::examples {

/// The table of errors that quell-denoise prints: a row per frame that has a reference, and their mean.
class Scores {
public:
    /// Writes the header.
    explicit Scores(std::ostream& out);
    /// Compares two linear pictures as a screen shows them, writes the row at once, and returns it.
    ImageErrors add(long long frame, metrics::Picture const& reference, metrics::Picture const& output);
    /// Writes the last row.
    void finish() const;

private:
    std::ostream& out;
    ImageErrors sum;
    int frames = 0;

    void row(std::string const& name, ImageErrors const& errors) const;
};

} // namespace quell::examples

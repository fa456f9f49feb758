#pragma once

#include "contender.hpp"
#include "parts.hpp"
#include "sequence.hpp"

#include <list>

namespace quell::bench {

/// A contender, and what it made of the sequence.
struct Trial {
    Contender const* contender = nullptr;
    Effects split; ///< of one for the rest: which effects were split off
    Precision memory = Precision::single;
    double ms = 0, bytes_per_pixel = 0;
    std::vector<metrics::Picture> shares{}; ///< its linear share of each scored frame's picture
};

/// What is to be run.
struct Entrant {
    Contender const* contender = nullptr;
    Effects split; ///< of one for the rest
    Precision memory = Precision::single;
};

/// Runs contenders over the sequence, side by side.
class Trials {
public:
    Trials(FitSequence& sequence, FitOptions const& options);

    /// @param label for the progress bar; @throws Error for frames that can't be read
    [[nodiscard]] std::list<Trial> run(std::vector<Entrant> const& entrants, std::string const& label);
    /// Whether nothing is left of the picture where these are split off.
    [[nodiscard]] bool leaves_nothing(Effects const& split);

private:
    FitSequence& sequence;
    ChartOptions how;
    FitFrame frame;
};

/// Makes `radiance` of the whole picture that it is what is left when effects are split off.
void take_from_picture(FitFrame& frame, Effects const& split);

} // namespace quell::bench

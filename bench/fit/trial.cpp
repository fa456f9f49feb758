#include "trial.hpp"

#include <support/progress.hpp>

#include <algorithm>

namespace quell::bench {
namespace {

glm::vec3 at(ImageView auto const& view, int x, int y) { return {view.get(0, x, y), view.get(1, x, y), view.get(2, x, y)}; }

/// A share that a host couldn't compute takes nothing away.
glm::vec3 finite(glm::vec3 share) { return metrics::detail::is_finite(share.x + share.y + share.z) ? share : glm::vec3(0.f); }

glm::vec3 share_of(FitFrame const& frame, Effects const& split, int x, int y) {
    glm::vec3 sum(0.f);
    if (has(split, Part::shadow)) sum += finite(at(frame[direct].view(), x, y) * frame[visibility].view().get(0, x, y));
    if (has(split, Part::glossy)) sum += finite(at(frame[glossy].view(), x, y));
    if (has(split, Part::indirect)) sum += finite(at(frame[albedo].view(), x, y) * at(frame[indirect].view(), x, y));
    return sum;
}

/// Files hold halves: less than a thousandth of the whole is their rounding.
float left_of(float whole, float taken) {
    float const left = whole - taken;
    return left < 0.001f * whole ? 0.f : left;
}

metrics::Picture picture_in(FitFrame const& frame) {
    metrics::Picture picture{frame.size, {}};
    auto const view = frame[radiance].view();
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) picture.pixels.push_back(at(view, x, y));
    return picture;
}

/// A contender at work.
struct Runner {
    std::unique_ptr<Method<FitFrame>> method;
    Trial trial;

    void next(FitFrame const& frame, bool scored) {
        auto share = method->run(frame);
        if (scored) trial.shares.push_back(std::move(share));
    }
    Trial finished() {
        trial.ms = method->ms_per_frame(), trial.bytes_per_pixel = method->bytes_per_pixel();
        return std::move(trial);
    }
};

} // namespace

void take_from_picture(FitFrame& frame, Effects const& split) {
    if (split.none()) return;
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const whole = at(frame[radiance].view(), x, y), taken = share_of(frame, split, x, y);
            frame[radiance].set(x, y, {left_of(whole.x, taken.x), left_of(whole.y, taken.y), left_of(whole.z, taken.z)});
        }
}

Trials::Trials(FitSequence& sequence_, FitOptions const& options) : sequence(sequence_), frame(sequence_.size) {
    how.size = sequence.size, how.threads = options.threads, how.quiet = options.quiet;
}

std::list<Trial> Trials::run(std::vector<Entrant> const& entrants, std::string const& label) {
    std::vector<Runner> runners;
    for (auto const& entrant : entrants)
        runners.push_back({entrant.contender->start(how, entrant.memory), {entrant.contender, entrant.split, entrant.memory}});
    examples::Progress bar(label, static_cast<long long>(sequence.numbers.size()), !how.quiet);
    for (auto const number : sequence.numbers) {
        bar.show(number - sequence.numbers.front(), std::to_string(entrants.size()) + " pipelines");
        sequence.load(number, frame);
        bool const scored = std::ranges::find(sequence.converged, number, &Converged::frame) != sequence.converged.end();
        auto const whole = picture_in(frame);
        for (auto& runner : runners) {
            take_from_picture(frame, runner.trial.split);
            runner.next(frame, scored);
            if (runner.trial.split.any()) put_picture(whole, frame);
        }
    }
    std::list<Trial> trials;
    for (auto& runner : runners) trials.push_back(runner.finished());
    return trials;
}

bool Trials::leaves_nothing(Effects const& split) {
    long long left = 0;
    for (auto const& one : sequence.converged) {
        sequence.load(one.frame, frame);
        take_from_picture(frame, split);
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x) left += at(frame[radiance].view(), x, y) != glm::vec3(0.f);
    }
    return left * 1000 < sequence.size.pixels() * static_cast<long long>(sequence.converged.size());
}

} // namespace quell::bench

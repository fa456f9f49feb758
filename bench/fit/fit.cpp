#include "fit.hpp"

#include <quell/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace quell::bench {
namespace {

/// The search, from small to large.
class Search {
public:
    Search(FitSequence& sequence_, std::vector<Contender> const& contenders_, FitOptions const& options_, std::ostream& out_)
        : sequence(sequence_), contenders(contenders_), options(options_), out(out_), survey(sequence_), trials(sequence_, options_) {
        check_rest();
        for (auto const effect : effects)
            if (std::ranges::any_of(contenders, [&](auto const& one) { return one.part == effect && may_run(one); }))
                splittable = with(splittable, effect);
    }

    /// @throws OutOfReach
    Composition& find() {
        print_survey();
        for (std::size_t split = 0; split <= splittable.count(); ++split) {
            if (split == levels.size()) look_at_level(split);
            if (!options.bounds.asks_for_error()) continue;
            if (auto* const found = smallest_within(levels[split], options.bounds, sequence.converged)) return *found;
        }
        if (!options.bounds.asks_for_error())
            if (auto* const found = most_accurate_in_time(levels, options.bounds)) return *found;
        throw OutOfReach("nothing keeps " + sequence.name + " to " + to_string(options.bounds) + "; " + best() +
                         "; loosen the bound, or give the frames more samples");
    }

    /// Runs the pipelines together, and once more with halves in their memory, which do where nothing asks for more. What they cost is
    /// known better then, and noted.
    [[nodiscard]] Fitted verified(Composition& found) {
        std::vector<Entrant> entrants;
        for (auto const memory : {Precision::single, Precision::half})
            for (auto const* trial : found.parts) entrants.push_back({trial->contender, trial->split, memory});
        Fitted fitted{trials.run(entrants, "verifying"), {}, origin(found)};
        auto const in_floats = composed(fitted.trials, Precision::single, found.split);
        auto const in_halves = composed(fitted.trials, Precision::half, found.split);
        bool const halves_do = stands_in_for(in_halves, in_floats, options.bounds);
        fitted.composition = halves_do ? in_halves : in_floats;
        fitted.origin.memory = about_memory(in_floats, in_halves, halves_do);
        found.figures = in_floats.figures;
        return fitted;
    }

    void print(Fitted const& fitted) const {
        out << (options.bounds.asks_for_error() ? "The smallest within " : "The smallest of the most accurate within ")
            << to_string(options.bounds) << ": " << to_string(fitted.composition)
            << "\n  run as a whole: " << to_string(fitted.composition.figures) << ", " << bytes_of(fitted.composition)
            << "\n  memory: " << fitted.origin.memory << '\n';
        for (auto const& sentence : fitted.origin.left_out) out << "  left out: " << sentence << '\n';
        out << "  channels:";
        for (auto const& name : channels_of(fitted.composition)) out << ' ' << name;
        out << std::endl;
    }

private:
    FitSequence& sequence;
    std::vector<Contender> const& contenders;
    FitOptions const& options;
    std::ostream& out;
    Survey survey;
    Trials trials;
    Effects splittable;
    std::list<Trial> known;
    std::vector<std::vector<Composition>> levels; ///< by the number of effects split off

    [[nodiscard]] std::string missing_channel(Contender const& contender) const {
        for (auto const& name : contender.reads)
            if (!sequence.channels.contains(name)) return name;
        return {};
    }
    [[nodiscard]] bool may_run(Contender const& contender) const {
        if (!missing_channel(contender).empty() || (contender.needs_camera && !sequence.has_camera)) return false;
        if (contender.part == Part::rest) return survey.blur().present || !contender.blurs();
        auto const& effect = survey[contender.part];
        return effect.present && effect.splits && (effect.moves || !contender.follows);
    }
    void check_rest() const {
        auto const rest = std::ranges::find(contenders, Part::rest, &Contender::part);
        if (auto const missing = missing_channel(*rest); !missing.empty())
            throw Error(sequence.name, "its frames have no channel '" + missing + "'", "render that too");
    }

    void look_at_level(std::size_t split) {
        std::vector<Entrant> entrants;
        for (auto const& one : contenders) {
            if (!may_run(one)) continue;
            if (one.part != Part::rest && split == 1) entrants.push_back({&one, {}});
            for (auto const& chosen : choices(split))
                if (one.part == Part::rest && !trials.leaves_nothing(chosen)) entrants.push_back({&one, chosen});
        }
        known.splice(known.end(), trials.run(entrants, "splitting off " + std::to_string(split)));
        auto& level = levels.emplace_back();
        for (auto const& chosen : choices(split)) compose(chosen, level);
        for (auto& composition : level) measure(composition, sequence.converged);
        print_level(split, level);
    }

    /// All ways to split off so many.
    [[nodiscard]] std::vector<Effects> choices(std::size_t split) const {
        std::vector<Effects> found;
        for (unsigned bits = 0; bits < (1u << effects.size()); ++bits)
            if (Effects const chosen(bits); chosen.count() == split && (chosen & ~splittable).none()) found.push_back(chosen);
        return found;
    }

    /// All that can be made of one choice: each effect's pipelines with each other's and with the rest's.
    void compose(Effects const& chosen, std::vector<Composition>& level) {
        std::vector<Composition> partial{{chosen, {}}};
        for (auto const effect : effects)
            if (has(chosen, effect)) partial = extended(partial, effect);
        auto whole = extended(partial, Part::rest);
        std::ranges::move(whole.empty() ? partial : whole, std::back_inserter(level));
    }
    [[nodiscard]] std::vector<Composition> extended(std::vector<Composition> const& partial, Part part) const {
        std::vector<Composition> more;
        for (auto const& one : partial)
            for (auto const& trial : known) {
                if (trial.contender->part != part || (part == Part::rest && trial.split != one.split)) continue;
                more.push_back(one);
                more.back().parts.push_back(&trial);
            }
        return more;
    }

    [[nodiscard]] Composition composed(std::list<Trial> const& run, Precision memory, Effects const& split) const {
        Composition whole{split, {}};
        for (auto const& trial : run)
            if (trial.memory == memory) whole.parts.push_back(&trial);
        measure(whole, sequence.converged);
        measure_flip(whole, sequence.converged);
        return whole;
    }

    [[nodiscard]] static std::string bytes_of(Composition const& composition) {
        return std::to_string(std::llround(composition.figures.bytes_per_pixel)) + " bytes per pixel";
    }
    [[nodiscard]] static std::string about_memory(Composition const& in_floats, Composition const& in_halves, bool halves_do) {
        auto const text = [](Composition const& one) { return to_string(one.figures) + ", " + bytes_of(one); };
        return (halves_do ? "halves do" : "halves don't do") + (": " + text(in_halves)) + "; in floats " + text(in_floats);
    }

    /// The best of all, where none is good enough.
    [[nodiscard]] std::string best() {
        Composition* best = nullptr;
        bool const late = std::ranges::none_of(levels, [&](auto const& level) { return any_in_time(level); });
        auto const key = [&](Composition const& one) { return late ? one.figures.ms : one.figures.rmse; };
        for (auto& level : levels)
            for (auto& one : level)
                if ((late || options.bounds.in_time(one.figures)) && (!best || key(one) < key(*best))) best = &one;
        if (options.bounds.flip && !best->figures.flip) measure_flip(*best, sequence.converged);
        return std::string(late ? "the fastest" : "the most accurate") + " is " + to_string(*best) + ": " + to_string(best->figures);
    }
    [[nodiscard]] bool any_in_time(std::vector<Composition> const& level) const {
        return std::ranges::any_of(level, [&](auto const& one) { return options.bounds.in_time(one.figures); });
    }

    /// A sentence for each effect without a pipeline of its own.
    [[nodiscard]] std::vector<std::string> left_out(Composition const& found) const {
        std::vector<std::string> sentences;
        if (std::ranges::none_of(found.parts, [](auto const* trial) { return trial->contender->blurs(); }))
            sentences.push_back("blur: " + survey.blur().evidence);
        for (auto const effect : effects) {
            if (has(found.split, effect)) continue;
            auto const name = effect == Part::indirect ? std::string("indirect, dual vectors and cones") : std::string(name_of(effect));
            auto const& verdict = survey[effect];
            sentences.push_back(name + ": " + verdict.evidence + (verdict.present ? "; it stays in the rest" : ""));
        }
        return sentences;
    }
    [[nodiscard]] Origin origin(Composition const& found) const {
        Origin origin{sequence.name, sequence.size, options.threads, options.bounds, {}, {}, left_out(found)};
        for (auto const& one : sequence.converged) origin.scored.push_back(one.frame);
        return origin;
    }

    void print_survey() const {
        out << sequence.name << ", " << to_string(sequence.size) << ", " << sequence.numbers.size() << " frames, " << options.threads
            << " threads\n";
        out << "  blur: " << survey.blur().evidence << '\n';
        for (auto const effect : effects) out << "  " << name_of(effect) << ": " << survey[effect].evidence << '\n';
    }
    void print_level(std::size_t split, std::vector<Composition>& level) const {
        auto const front = front_of(level);
        out << (split == 0 ? std::string("All as one colour") : std::to_string(split) + " split off") << ": " << level.size()
            << " compositions, of which nothing is both cheaper and more accurate than\n";
        for (auto const* one : front) out << "  " << to_string(one->figures) << ": " << to_string(*one) << '\n';
        out << std::flush;
    }
};

} // namespace

Fitted fit(FitSequence& sequence, std::vector<Contender> const& contenders, FitOptions const& options, std::ostream& out) {
    Search search(sequence, contenders, options, out);
    for (;;) {
        auto fitted = search.verified(search.find());
        if (!options.bounds.in_time(fitted.composition.figures)) continue; // the next best
        search.print(fitted);
        return fitted;
    }
}

} // namespace quell::bench

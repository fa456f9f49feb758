#include "history_choice.hpp"
#include "resolved_denoiser.hpp"
#include "stage.hpp"
#include "steady_denoiser.hpp"

#include <algorithm>

namespace quell_library {

namespace {

using Compiled = std::unique_ptr<CompiledDenoiser>;

Stage evidence() {
    return {.name = evidence_stage,
            .refusal = [](Way const& way) { return can_choose_history(way) ? "" : "has no history, or several"; },
            .plan = [](std::string const& inner, Way const& way, Way const& judge) { return plan_of_choice(way, judge) + inner; },
            .put =
                [](Compiled denoiser, StagePlace const& at) {
                    auto choice = make_history_choice(at.way, at.judge, at.size, at.parallel, at.memory);
                    choice->tell_samples(at.samples);
                    return with_history_choice(std::move(denoiser), std::move(choice));
                }};
}

Stage resolve() {
    return {
        .name = resolve_stage,
        .refusal = [](Way const& way) { return can_resolve(way) ? "" : "makes no picture"; },
        .needs_jitter = true,
        .plan = [](std::string const& inner, Way const& way, Way const&) { return inner + plan_of_resolved(way); },
        .put = [](Compiled denoiser,
                  StagePlace const& at) { return make_resolved(std::move(denoiser), at.way, at.size, at.output, at.parallel, at.memory); }};
}

/// @tparam C the guide
template <class C> Stage steady() {
    return {.name = "steady-" + std::string(C::name),
            .refusal = [](Way const& way) -> std::string {
                for (std::string_view const read : {C::name, quell::Motion::name})
                    if (!way.place_of(read)) return "reads no " + std::string(read);
                return {};
            },
            .takes_one_frame = true,
            .plan = [](std::string const& inner, Way const&, Way const&) { return plan_of_steady<C>() + inner; },
            .put =
                [](Compiled denoiser, StagePlace const& at) {
                    return with_steady_guide<C>(std::move(denoiser), at.channels, at.size, at.parallel, at.memory);
                }};
}

} // namespace

std::vector<Stage> const& stages() {
    static auto const all = [] {
        std::vector<Stage> made{evidence()};
        std::ranges::move(link_stages(), std::back_inserter(made));
        made.push_back(resolve());
        made.push_back(steady<quell::Albedo>());
        made.push_back(steady<quell::Depth>());
        return made;
    }();
    return all;
}

} // namespace quell_library

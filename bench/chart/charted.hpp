#pragma once

#include "parameters.hpp"
#include "row.hpp"

#include <quell/image/planar.hpp>
#include <quell/resolve/resolved.hpp>

#include <fmt/format.h>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quell::bench {

/// A pipeline's picture is its effect's share of the image: direct * visibility, glossy, or albedo * indirect. Several make the image.
template <class... Ps> constexpr Composite<Ps...> whole(Composite<Ps...> const& pipelines) { return pipelines; }
template <ChannelTag S, class... Parts> constexpr Composite<Pipeline<S, Parts...>> whole(Pipeline<S, Parts...> const& pipeline) {
    return Composite<Pipeline<S, Parts...>>(pipeline);
}

template <class P, class Policy> constexpr auto whole(Resolved<P, Policy> const& resolved) {
    return Resolved{whole(resolved.pipeline), resolved.resolve};
}

/// A pipeline to chart, by the name that its row has.
/// @tparam HistoryStorage of what it remembers
template <class P, class HistoryStorage = Planar<>> struct Charted {
    using Whole = decltype(whole(std::declval<P>()));
    using Storage = HistoryStorage;
    std::string name;
    P pipeline;
    bool competes = true;
    std::optional<Variant> variant{}; ///< what this is a variant of, where its type differs from the preset's

    Charted(std::string name_, P const& p) : name(std::move(name_)), pipeline(p) {}

    /// The same with its history in half precision, as a variant.
    [[nodiscard]] auto in_half() const {
        Charted<P, Planar<Float16>> half{name, pipeline};
        half.variant = Variant{name, "history_bits", 16., 32.};
        return half;
    }
};
template <class P> Charted(char const*, P) -> Charted<P>;
template <class P> Charted(std::string, P) -> Charted<P>;

/// What a variant's row is called: svgf/levels=3.
[[nodiscard]] inline std::string name_of(Variant const& variant) {
    return fmt::format("{}/{}={:g}", variant.preset, variant.parameter, variant.value);
}

/// A pipeline with one number changed.
template <class P> struct Changed {
    Variant variant;
    P pipeline;
};

/// A pipeline with each value of each parameter that isn't its own. They are of its type: they cost no time to compile.
template <class P> std::vector<Changed<P>> variants_of(std::string const& preset, P const& pipeline) {
    std::vector<Changed<P>> all;
    auto source = pipeline;
    int place = 0; // among the pipeline's numbers
    for_each_parameter(source, [&](Parameter const& parameter, auto const& own) {
        for (double const value : parameter.values) {
            if (static_cast<float>(value) == static_cast<float>(own)) continue;
            auto& made = all.emplace_back(Variant{preset, std::string(parameter.name), value, static_cast<double>(own)}, pipeline);
            int at = 0;
            for_each_parameter(made.pipeline, [&](Parameter const&, auto& number) {
                if (at++ == place) number = static_cast<std::remove_reference_t<decltype(number)>>(value);
            });
        }
        ++place;
    });
    return all;
}

/// A pipeline of another type that differs from a preset in one number.
template <class P> Charted<P> variant_of(Variant const& variant, P const& pipeline) {
    Charted<P> named(name_of(variant), pipeline);
    named.variant = variant;
    return named;
}

} // namespace quell::bench

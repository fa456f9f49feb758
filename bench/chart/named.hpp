#pragma once

#include "row.hpp"

#include <quell/image/planar.hpp>
#include <quell/pipeline/composite.hpp>

#include <cstdio>
#include <initializer_list>
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

/// A pipeline to chart, by the name that its row has, and variants of it that are of its type: those cost no time to compile.
/// @tparam HistoryStorage of what it remembers
template <class P, class HistoryStorage = Planar<>> struct Named {
    using Whole = decltype(whole(std::declval<P>()));
    using Storage = HistoryStorage;
    struct Changed {
        Variant variant;
        P pipeline;
    };
    std::string name;
    P pipeline;
    std::vector<Changed> variants{};
    bool competes = true;
    std::optional<Variant> variant{}; ///< what this is a variant of, where its type differs from the preset's

    Named(std::string name_, P const& p) : name(std::move(name_)), pipeline(p) {}

    /// Adds a variant for each value that isn't the preset's own; `field(pipeline)` is a reference to the number.
    Named vary(std::string const& parameter, std::initializer_list<double> values, auto const& field) const {
        Named more = *this;
        for (double const value : values) {
            Changed changed{{name, parameter, value, 0.}, pipeline};
            auto& number = field(changed.pipeline);
            changed.variant.preset_value = static_cast<double>(number);
            number = static_cast<std::remove_reference_t<decltype(number)>>(value);
            if (static_cast<float>(value) != static_cast<float>(changed.variant.preset_value)) more.variants.push_back(changed);
        }
        return more;
    }
    /// The same with its history in half precision, as a variant.
    [[nodiscard]] auto in_half() const {
        Named<P, Planar<Float16>> half{name, pipeline};
        half.variant = Variant{name, "history_bits", 16., 32.};
        return half;
    }
};
template <class P> Named(char const*, P) -> Named<P>;
template <class P> Named(std::string, P) -> Named<P>;

/// What a variant's row is called: svgf/levels=3.
[[nodiscard]] inline std::string name_of(Variant const& variant) {
    char value[32];
    std::snprintf(value, sizeof value, "%g", variant.value);
    return variant.preset + "/" + variant.parameter + "=" + value;
}

/// A pipeline of another type that differs from a preset in one number.
template <class P> Named<P> variant_of(Variant const& variant, P const& pipeline) {
    Named<P> named(name_of(variant), pipeline);
    named.variant = variant;
    return named;
}

} // namespace quell::bench

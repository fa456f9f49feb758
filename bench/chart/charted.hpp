#pragma once

#include "row.hpp"

#include <quell/resolve/resolved.hpp>

#include <string>
#include <utility>

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
template <class P> struct Charted {
    using Whole = decltype(whole(std::declval<P>()));
    std::string name;
    P pipeline;
    bool competes = true;

    Charted(std::string name_, P const& p) : name(std::move(name_)), pipeline(p) {}
};
template <class P> Charted(char const*, P) -> Charted<P>;
template <class P> Charted(std::string, P) -> Charted<P>;

} // namespace quell::bench

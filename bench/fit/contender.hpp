#pragma once

#include "chart/method.hpp"
#include "parts.hpp"
#include "precision.hpp"
#include "sequence.hpp"

#include <algorithm>

namespace quell::bench {

/// A pipeline that may become part of a composition.
struct Contender {
    Part part;
    std::string name; ///< as in svgf/levels=3
    std::string code; ///< the C++ that makes it, in namespace quell
    bool follows;     ///< whether it is there to follow what moves
    bool needs_camera;
    std::vector<std::string> reads; ///< channels, its share's factor among them
    std::unique_ptr<Method<FitFrame>> (*start)(ChartOptions const&, Precision memory);

    /// Makes motion blur of samples of different times.
    [[nodiscard]] bool blurs() const { return std::ranges::count(reads, Sweep::name) > 0; }
};

template <class P> Part part_of(P const&) {
    using Signal = typename P::Output;
    if constexpr (std::is_same_v<Signal, Visibility>) return Part::shadow;
    if constexpr (std::is_same_v<Signal, Glossy>) return Part::glossy;
    if constexpr (std::is_same_v<Signal, Indirect>) return Part::indirect;
    return Part::rest;
}

/// @param code and what it makes: QUELL_FIT_CODE writes both
/// @param follows whether it does so by motion of the effect's own
template <class Make> Contender contender(std::string name, bool follows, char const* code, Make) {
    using Pipe = decltype(Make{}());
    using Made = Composite<Pipe>;
    std::vector<std::string> reads;
    for_each_channel(typename Made::reads{}, [&](auto channel) { reads.emplace_back(channel.name); });
    return {part_of(Make{}()),
            std::move(name),
            code,
            follows,
            Made::needs_camera,
            reads,
            [](ChartOptions const& options, Precision memory) -> std::unique_ptr<Method<FitFrame>> {
                if (memory == Precision::half) return std::make_unique<MethodOf<FitFrame, Made, Planar<Float16>>>(whole(Make{}()), options);
                return std::make_unique<MethodOf<FitFrame, Made, Planar<>>>(whole(Make{}()), options);
            }};
}

} // namespace quell::bench

/// Code as text and as what it makes, so that the two are the same.
#define QUELL_FIT_CODE(...)                                                                                                                \
#__VA_ARGS__, [] { using namespace quell; return __VA_ARGS__; }

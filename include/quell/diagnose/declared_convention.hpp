#pragma once

#include <quell/motion/supplied_motion.hpp>
#include <quell/pipeline/composite.hpp>

#include <initializer_list>

namespace quell::detail {

constexpr MotionConvention first_declared(std::initializer_list<MotionConvention> all) {
    for (auto const convention : all)
        if (!(convention == MotionConvention{})) return convention;
    return {};
}

/// What a pipeline takes the Motion channel for: quell's own convention, or that of the Supplied<> in it.
template <class T> struct DeclaredConvention { static constexpr MotionConvention value{}; };
template <MotionConvention convention, class Test> struct DeclaredConvention<Supplied<convention, Test>> {
    static constexpr MotionConvention value = convention;
};
template <class... Sources> struct DeclaredConvention<FirstValid<Sources...>> {
    static constexpr MotionConvention value = first_declared({DeclaredConvention<Sources>::value...});
};
template <class M, class B, class F> struct DeclaredConvention<Temporal<M, B, F>> : DeclaredConvention<M> {};
template <class S, class... Parts> struct DeclaredConvention<Pipeline<S, Parts...>> {
    static constexpr MotionConvention value = first_declared({DeclaredConvention<Parts>::value...});
};
template <class... Ps> struct DeclaredConvention<Composite<Ps...>> {
    static constexpr MotionConvention value = first_declared({DeclaredConvention<Ps>::value...});
};

} // namespace quell::detail

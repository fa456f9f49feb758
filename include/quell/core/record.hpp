#pragma once

#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
template <class C, class T> struct Slot { T held; };
template <class C, class T> QUELL_KERNEL T& slot(Slot<C, T>& s) { return s.held; }
template <class C, class T> QUELL_KERNEL T const& slot(Slot<C, T> const& s) { return s.held; }
} // namespace detail

/// The values of several channels at one pixel: `record[history_length]`.
/// @tparam Real float or a pack
/// @tparam Set  Channels<...>
template <class Real, class Set> struct Record;
/// The values of several channels at one pixel.
template <class Real, class... Cs> struct Record<Real, Channels<Cs...>> : detail::Slot<Cs, Value<Cs::components, Real>>... {
    using channels = Channels<Cs...>; ///< those that it has

    /// The value of a channel. A channel that the record lacks does not compile.
    template <ChannelTag C> QUELL_KERNEL auto operator[](C) const {
        static_assert(channels::template has<C>, "a policy looks at a value that is not kept: add the channel to its `keeps`");
        if constexpr (channels::template has<C>) return detail::slot<C>(*this);
    }
    /// Replaces the value of a channel.
    template <ChannelTag C> QUELL_KERNEL void set(C, Value<C::components, Real> v) { detail::slot<C>(*this) = v; }
};

/// Makes a record of the values f(channel).
template <class Real, class... Cs, class F> QUELL_KERNEL Record<Real, Channels<Cs...>> make_record(Channels<Cs...>, F&& f) {
    return {{f(Cs{})}...};
}

/// What a blend policy or a filter returns for a pixel: the new value and the channels that it keeps or emits.
///
///     return Result{value, alpha}.with(history_length, n);
///
/// @tparam V   the signal's value
/// @tparam Set Channels<...> of `more`
template <class V, class Set = Channels<>> struct Result {
    using Real = real_of<V>;  ///< float or a pack
    V value;                  ///< the signal's new value
    Real alpha = Real(1.f);   ///< weight of the current frame in `value`, in [0, 1]
    Record<Real, Set> more{}; ///< channels kept or emitted

    /// The same result with one more channel, or with a new value for a channel that it has.
    template <class C, class T> QUELL_KERNEL auto with(C c, T const& v) const {
        static_assert(ChannelTag<C>, "with(channel, value): the first must be a channel, such as history_length");
        static_assert(std::is_convertible_v<T, Value<C::components, Real>>,
                      "with(channel, value): the value must have as many components as the channel");
        using Wider = decltype(Set{} + c);
        return Result<V, Wider>{value, alpha, make_record<Real>(Wider{}, [&](auto d) QUELL_INLINED {
                                    if constexpr (std::is_same_v<decltype(d), C>)
                                        return Value<C::components, Real>(v);
                                    else
                                        return more[d];
                                })};
    }
};
template <class V> Result(V) -> Result<V>;
template <class V, class A> Result(V, A) -> Result<V>;

/// The result of a kernel that makes a channel and no signal. Add further channels by .with().
///
///     return emitted<Real>(shadow_track, track);
template <class Real, class C, class T> QUELL_KERNEL auto emitted(C channel, T const& value) {
    return Result<Real>{Real(0.f), Real(1.f), {}}.with(channel, value);
}

namespace detail {
template <class T> inline constexpr bool is_result = false;
template <class V, class Set> inline constexpr bool is_result<Result<V, Set>> = true;

/// Wraps a bare value, which policies without channels may return.
template <class T> QUELL_KERNEL auto as_result(T const& t) {
    if constexpr (is_result<T>)
        return t;
    else
        return Result<T>{t, real_of<T>(1.f), {}};
}
} // namespace detail

/// What make() returns, as a Result: for decorators, whose inner policy may return a bare value. Avoids a copy, for which g++ calls memcpy.
///
///     auto const result = result_of([&]() QUELL_INLINED { return inner.blend(px, past); });    return result.with(channel, value);
///
template <class F> QUELL_KERNEL auto result_of(F&& make) {
    if constexpr (detail::is_result<decltype(make())>)
        return make();
    else
        return detail::as_result(make());
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

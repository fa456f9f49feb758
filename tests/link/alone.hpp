#pragma once

#include "../frames.hpp"

#include <quell/link/light_given_back.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

// Passes of a link by themselves, on numbers of the host's, to hold against double loops.
namespace quell::tests {

inline constexpr float none = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();

template <class C, class Base> struct Like : Base {
    static constexpr auto name = C::name;
    static constexpr bool full_precision = true;
};
/// A channel of the host's for one that an earlier pass makes; of a channel of blocks, the first pixel of each.
template <ChannelTag C> using Given = Like<C, Channel<C::components>>;
/// What the passes have made of a channel, at each pixel.
template <ChannelTag C> using Made = Like<C, InternalChannel<C::components>>;
template <ChannelTag From, ChannelTag To, bool keeps_it> struct Copy {
    static constexpr int fraction = To::fraction;
    using reads = Channels<From>;
    using keeps = std::conditional_t<keeps_it, Channels<To>, Channels<>>;
    using emits = std::conditional_t<keeps_it, Channels<>, Channels<To>>;
    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        if constexpr (From::fraction == fraction)
            return emitted<Real>(To{}, px[From{}]);
        else if constexpr (From::fraction < fraction)
            return emitted<Real>(To{}, px.finer(From{}, 0, 0));
        else
            return emitted<Real>(To{}, px.coarser(From{}));
    }
};

/// A storage that says 7 of columns beside an image.
struct Sevens {
    using Exact = Sevens;
    template <int N> struct Image : Planar<>::Image<N> {
        struct View {
            static constexpr int components = N;
            typename Planar<>::Image<N>::View inner;
            Extent size;
            [[nodiscard]] float get(int c, int x, int y) const { return x < 0 || x >= inner.size.width ? 7.f : inner.get(c, x, y); }
            void set(int c, int x, int y, float a) const { inner.set(c, x, y, a); }
        };
        using Planar<>::Image<N>::Image;
        [[nodiscard]] View view() const { return {Planar<>::Image<N>::view(), Planar<>::Image<N>::view().size}; }
    };
};

/// Passes behind copies of what they read and in front of copies of what they make.
template <class... Passes> struct Alone : detail::Slot<Passes, Passes>... {
    template <class... Cs> static auto internal(Channels<Cs...>) {
        return union_of<std::conditional_t<detail::is_made_by_stages<Cs>, Channels<Cs>, Channels<>>...>{};
    }
    template <class C> using Put = Copy<Given<C>, C, std::is_same_v<C, Lacking>>;
    template <class C> using Show = Copy<C, Made<C>, true>;
    template <class... Before, class... Behind> static auto all(Channels<Before...>, Channels<Behind...>) {
        return Parts<Put<Before>..., Passes..., Show<Behind>...>{};
    }
    using To = decltype(emits_of<Passes...>{} | keeps_of<Passes...>{});
    using Read = decltype(internal(reads_of<Passes...>{} | reads_kept_of<Passes...>{}));
    using From = std::conditional_t<(sizeof...(Passes) > 1), without<Read, To>, Read>; // one pass may make anew what it is given
    using parts = decltype(all(From{}, To{}));

    constexpr void for_each_pass(auto&& visit) const {
        for_each_channel(From{}, [&]<class C>(C) { visit(Put<C>{}); });
        (detail::for_each_pass(Spatial{detail::slot<Passes>(*this)}, visit), ...);
        for_each_channel(To{}, [&]<class C>(C) { visit(Show<C>{}); });
    }
};

using Triple = glm::dvec3;
inline double luminance_of(Triple const& c) { return glm::dot(c, Triple(.2126, .7152, .0722)); }
inline double square(Triple const& c) { return glm::dot(c, c); }
inline Triple limited(Triple const& c, double most) { return glm::min(glm::max(c, Triple(-most)), Triple(most)); }
inline bool is_even(int sum) { return sum % 2 == 0; }

/// Passes with a frame of random numbers from -1 to 1, whose brightness they take for 1.5. What they make is to be within `most` of what is
/// wanted, as a part of that or of 1.
template <class... Passes> struct PassAlone {
    using Link = Pipeline<Denoised, Spatial<Alone<Passes...>>>;
    using Set = typename Link::reads;
    Link link;
    Frame<Set> frame, then; ///< of now, and one that was before
    History<Link, Sevens> history;
    Planar<>::Image<3> picture; ///< that was made
    double most = 1e-4, worst = 0.;
    std::mt19937 random{7};

    explicit PassAlone(Passes const&... pass) : PassAlone(Extent{37, 23}, pass...) {}
    explicit PassAlone(Extent size, Passes const&... pass)
        : link(denoised, Spatial{Alone<Passes...>{{pass}...}}), frame(size), then(size), history(size, link), picture(size) {
        for_each_channel(Set{}, [&](auto c) { fill(c, -1.f, 1.f); });
        fill(denoised, .05f, 1.4f);
        at(0, 0).set(detail::BrightnessSums<detail::whole_frame>{}, {6.f, 4.f});
    }
    PassAlone(PassAlone const&) = delete;
    ~PassAlone() { CHECK(worst < most); }

    /// A pixel.
    struct At {
        PassAlone& pass;
        int x, y;
        Frame<Set>& frame = pass.frame;

        [[nodiscard]] At before() const { return {pass, x, y, pass.then}; }
        template <class C> static constexpr bool is_read = Set::template has<C> || Set::template has<Given<C>>;
        template <class C> auto& image(C) const { return frame[std::conditional_t<Set::template has<C>, C, Given<C>>{}]; }
        /// What the passes are given.
        double in(auto c, int k = 0) const { return static_cast<double>(image(c).view().get(k, x, y)); }
        Triple colour(auto c, int k = 0) const { return {in(c, k), in(c, k + 1), in(c, k + 2)}; }
        /// Some of it; nothing for a channel that they do not read.
        template <class C> void set(C c, std::initializer_list<float> values, int k = 0) const {
            if constexpr (is_read<C>)
                for (float const value : values) image(c).view().set(k++, x, y, value);
        }
        /// The sum over columns and rows around that lie in the image, of f(pixel).
        auto sum(int across, int down, auto const& f) const {
            auto all = 0. * f(*this);
            for (int j = std::max(y - down, 0); j <= std::min(y + down, frame.size.height - 1); ++j)
                for (int i = std::max(x - across, 0); i <= std::min(x + across, frame.size.width - 1); ++i) all += f(At{pass, i, j, frame});
            return all;
        }
        /// The same of a component along the column.
        double column(auto c, int radius, int k = 0) const {
            return sum(0, radius, [&](At const& p) { return p.in(c, k); });
        }
        [[nodiscard]] double pixels(int radius) const {
            return sum(radius, radius, [](At const&) { return 1.; });
        }
        /// Compares what they have made of a channel, or of the picture, with numbers and colours.
        template <class C> void check(C, auto const&... wanted) const {
            auto compare = [&, k = 0](double number) mutable {
                if constexpr (std::is_same_v<C, Denoised>)
                    pass.compare(pass.picture.view().get(k++, x, y), number);
                else
                    pass.compare(pass.history[Made<C>{}].get(k++, x, y), number);
            };
            (check_each(compare, wanted), ...);
        }
        static void check_each(auto& compare, double wanted) { compare(wanted); }
        static void check_each(auto& compare, Triple const& wanted) { compare(wanted.x), compare(wanted.y), compare(wanted.z); }
    };
    At at(int x, int y) { return {*this, x, y}; }
    void each_pixel(auto const& f) {
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x) f(at(x, y));
    }
    /// Random numbers for a channel.
    void fill(auto c, float low, float high) {
        std::uniform_real_distribution<float> number(low, high);
        each_pixel([&](At const& p) {
            for (int k = 0; k < c.components; ++k) p.set(c, {number(random)}, k);
        });
    }
    /// Looks at each pixel that comes out.
    void run(auto const& check) { run_into(picture.view(), link, frame, history), each_pixel(check); }
    void compare(float made, double wanted) {
        double const by = std::abs(static_cast<double>(made) - wanted) / (1. + std::abs(wanted));
        worst = by <= 1e9 ? std::max(worst, by) : 1e9;
    }
};

} // namespace quell::tests

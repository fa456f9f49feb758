#pragma once

#include "../views.hpp"
#include "bounds.hpp"
#include "cases.hpp"
#include "input.hpp"

#include <quell/diagnose/inspect.hpp>

#include <cstdio>
#include <cstdlib>

// A pipeline's run over frames of arbitrary content, and what must hold afterwards.
namespace quell::fuzz {

/// What an input asks for before it comes to pixels.
struct Plan {
    Extent size, other_size;
    int frames;
    std::uint32_t spoilt_parts;    ///< of 256 pixels in a spoilt channel
    std::uint32_t spoilt_channels; ///< a bit each
    bool spoilt_camera, resized, cut;
    std::uint32_t seed;

    explicit Plan(Bytes& in) {
        size = {1 + in.byte() % 17, 1 + in.byte() % 9};
        other_size = {size.height, size.width};
        frames = 2 + in.byte() % 4;
        spoilt_parts = in.byte() + 1u;
        auto const flags = in.byte();
        spoilt_camera = (flags & 7) == 7, resized = (flags & 24) == 24, cut = (flags & 96) == 96;
        spoilt_channels = in.word(), seed = in.word();
    }
};

template <class F> void fill_arbitrarily(F& frame, Plan const& plan, Patterns& patterns) {
    int number = 0;
    for_each_channel(typename F::channels{}, [&](auto c) {
        auto const view = frame[c].view();
        if ((plan.spoilt_channels >> (number++ % 32) & 1) == 0) return;
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                if (patterns.chance(plan.spoilt_parts))
                    for (int i = 0; i < view.components; ++i) view.set(i, x, y, patterns.next());
    });
}

inline Camera arbitrary_camera(Patterns& patterns) {
    Camera camera;
    for (int i = 0; i < 16; ++i) {
        camera.view[i / 4][i % 4] = patterns.next();
        camera.projection[i / 4][i % 4] = patterns.next();
    }
    camera.jitter = {patterns.next(), patterns.next()};
    return camera;
}

[[noreturn]] inline void fail(std::string const& preset, std::string_view channel, int frame, int x, int y, float value) {
    std::fprintf(stderr, "%s: %.*s is %g at pixel (%d, %d) after frame %d\n", preset.c_str(), static_cast<int>(channel.size()),
                 channel.data(), static_cast<double>(value), x, y, frame);
    std::abort();
}

void check_finite(std::string const& preset, std::string_view channel, int frame, auto const& view) {
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < view.components; ++c)
                if (float const value = view.get(c, x, y); !is_finite(value)) fail(preset, channel, frame, x, y, value);
}

template <class P> void check_history(std::string const& preset, int frame, std::type_identity<P>, auto const& history) {
    check_finite(preset, "history", frame, detail::Inspect::signal(history));
    for_each_channel(typename P::keeps{}, [&](auto c) { check_finite(preset, c.name, frame, detail::Inspect::kept(history, c)); });
}

/// The bounds of a pipeline, or of all pipelines of a composite.
template <class P> struct BoundsOf { std::tuple<Bounds<P>> all; };
template <class... Ps> struct BoundsOf<Composite<Ps...>> { std::tuple<Bounds<Ps>...> all; };

/// Runs a pipeline over the frames that an input describes. Only a camera that can't be used may be refused.
template <class Executor, class Storage = Planar<>, class P> void run_frames(std::string const& preset, P const& pipeline, Bytes& in) {
    constexpr bool half = std::is_same_v<typename Storage::format, Float16>;
    Plan const plan(in);
    Patterns patterns(plan.seed, in.rest());
    History history{plan.size, pipeline, Storage{}};
    BoundsOf<P> bounds;
    for (int i = 0; i < plan.frames; ++i) {
        Frame frame{plan.resized && i == plan.frames / 2 ? plan.other_size : plan.size, pipeline};
        tests::fill_randomly(frame, plan.seed + static_cast<unsigned>(i));
        frame.camera = tests::View({0.1 * i, 1, 8}, {1, 1, 0}, frame.size).camera();
        fill_arbitrarily(frame, plan, patterns);
        if (plan.spoilt_camera) frame.camera = arbitrary_camera(patterns), frame.shutter = patterns.next();
        if (plan.cut && i == 1) history.forget();
        try {
            check_finite(preset, "output", i, run(pipeline, frame, history, Executor{}));
        } catch (Error const&) {
            if (!plan.spoilt_camera) throw;
            continue;
        }
        detail::for_each_history(history, [&]<class Part>(std::type_identity<Part> p, auto const& part) {
            check_history(preset, i, p, part);
            auto& its = std::get<Bounds<Part>>(bounds.all);
            if (part.statistics().frames == 1) its.start_over();
            its.see(frame);
            its.check(frame, detail::Inspect::output(part), half ? 4e-3f : 1e-5f, half ? 1e-7f : 1e-30f, half ? 65504.f : 1e30f,
                      [&](int x, int y, float value, float least, float most) {
                          std::fprintf(stderr, "%s's samples are %g to %g\n", preset.c_str(), static_cast<double>(least),
                                       static_cast<double>(most));
                          fail(preset, "output", i, x, y, value);
                      });
        });
    }
}

/// A preset as a case. QUELL_FUZZ_EXECUTOR: Serial, whose reads the sanitizers see, or Simd.
template <class Storage = Planar<>> Known known(std::string const& name, auto const& pipeline) {
    return Known({name, [=](Bytes& in) { run_frames<QUELL_FUZZ_EXECUTOR, Storage>(name, pipeline, in); }});
}

} // namespace quell::fuzz

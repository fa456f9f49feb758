#include <denoise/preset_memory.hpp>

#include <quell/presets/named.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

/// Of an exponential average's memory: e to the minus this is the weight of what the warm-up lacks.
constexpr float memories_to_warm_up = 2.f;

/// Frames after which a blend policy gives an old frame 1/e of its first weight.
template <class Blend> constexpr float memory_of(Blend const& blend) {
    if constexpr (requires { blend.inner; })
        return memory_of(blend.inner);
    else if constexpr (requires { blend.cap; })
        return blend.cap;
    else if constexpr (requires { blend.alpha; })
        return 1.f / blend.alpha;
    else
        static_assert(sizeof(Blend) == 0, "a blend policy whose memory isn't known");
}

template <class Stage> constexpr float memory_of_stage(Stage const& stage) {
    if constexpr (requires { stage.blending; })
        return memory_of(stage.blending);
    else
        return 0.f;
}

template <class P> constexpr float memory_of_pipeline(P const& pipeline) {
    auto const largest = [](auto const& parts, auto const& memory) {
        return std::apply([&](auto const&... part) { return std::max({0.f, memory(part)...}); }, parts);
    };
    if constexpr (requires { pipeline.pipelines; })
        return largest(pipeline.pipelines, [](auto const& part) { return memory_of_pipeline(part); });
    else
        return largest(pipeline.stages, [](auto const& stage) { return memory_of_stage(stage); });
}

template <class Named> float memory_of_preset(Named const&) {
    constexpr auto pipeline = Named::usual();
    return memory_of_pipeline(pipeline); // joining both sides begins anew in each frame
}

} // namespace

int usual_warm_up(std::string const& preset) {
    float memory = 0;
    for_each_preset([&](auto const& named) {
        if (named.name == preset) memory = memory_of_preset(named);
    });
    return static_cast<int>(std::ceil(memory * memories_to_warm_up));
}

} // namespace quell::examples

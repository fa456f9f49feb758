// error: Resolved{pipeline, resolve}: colours of that pipeline are anti-aliased already; take one of presets::resolve and
// presets::anti_aliased
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/resolve.hpp>
#include <quell/quell.hpp>
using namespace quell;

constexpr auto pipeline = presets::none(radiance);
#ifdef CORRECT
constexpr auto denoise = presets::resolve(pipeline);
#else
constexpr auto denoise = presets::resolve(presets::anti_aliased(pipeline));
#endif
constexpr auto output = decltype(denoise)::Output::components;

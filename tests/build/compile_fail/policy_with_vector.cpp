// error: must be trivially copyable
#include <quell/quell.hpp>

#include <vector>

struct Remembering {
#ifdef CORRECT
    float alphas[4] = {};
#else
    std::vector<float> alphas; // a policy is copied to every thread and device, and has no memory of its own
#endif
    QUELL_KERNEL auto blend(auto px, auto) const { return px.signal(); }
};

using Accumulate = quell::Temporal<quell::SurfaceMotion<>, Remembering>;
Accumulate accumulate;

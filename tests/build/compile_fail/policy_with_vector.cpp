// error: Temporal{motion, blend}: a policy must be trivially copyable, so that it can be sent to a device: plain numbers only
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

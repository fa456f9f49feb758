// error: SteadyGuides<Channels<...>>: guides that may be negative, such as normals, positions and motion, cannot be accumulated so
// error: SteadyGuides: apply(frame) writes the frame's guides: it must have images of its own, and not Borrowed ones
#include <quell/pipeline/steady_guides.hpp>
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
using Places = Channels<Depth>;
using Vectors = Channels<Roughness>;
using Directions = Channels<Albedo>;
using Memory = Planar<>;
#else
using Places = Channels<Depth, Position>;
using Vectors = Channels<Sweep>;
using Directions = Channels<Normal>;
using Memory = Borrowed<>;
#endif

int main() {
    SteadyGuides<Places> places({8, 8});
    SteadyGuides<Vectors> vectors({8, 8});
    SteadyGuides<Directions> directions({8, 8});
    SteadyGuides<Channels<Depth>> depths({8, 8});
    Frame<Channels<Depth, Motion>, Memory> frame({8, 8});
    depths.apply(frame);
}

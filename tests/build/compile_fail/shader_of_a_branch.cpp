// error: a policy branches on what it computes of a pixel, which cannot be recorded: use select(mask, a, b) or masked(mask, a)
// error: a policy takes a column, a row, a size or bits for a number of the host, which cannot be recorded: use to_real(integer)
// error: a policy takes what it computes of a pixel for a number of the host, which cannot be recorded
#include <quell/quell.hpp>
#include <quell/shader/record.hpp>

using namespace quell;

// What a CPU runs one pixel at a time, and a recording cannot.
struct Branches {
    static constexpr int farthest_tap = 0;
    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const value = px.signal();
#ifdef CORRECT
        auto const width = select(px.columns() < Real(3.f), to_real(px.size().width), Real(1.f));
        auto const darker = Real(0.5f) * width;
#else
        auto width = Real(1.f);
        if (px.columns() < Real(3.f)) width = Real(static_cast<float>(px.size().width));
        auto const darker = Real(0.5f * static_cast<float>(width)) * width;
#endif
        return scale(value, darker);
    }
};
int main() { return static_cast<int>(record(Pipeline{radiance, Spatial{Branches{}}}).passes.size()); }

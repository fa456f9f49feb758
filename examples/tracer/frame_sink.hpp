#pragma once

#include <quell/frame/frame.hpp>

namespace quell::tracer {

/// Lets the tracer write straight into a quell::Frame.
template <class FrameT> struct FrameSink {
    FrameT& frame;

    template <class C, class Value> void put(C channel, int x, int y, Value const& value) { frame[channel].set(x, y, value); }
};

} // namespace quell::tracer

#pragma once

#include <quell/image/interleaved.hpp>

#include <new>

namespace quell::tests {

/// A storage whose memory runs out after `left` images; -1: never.
struct Failing {
    using Exact = Failing;
    inline static int left = -1;
    template <int N> struct Image : Interleaved<>::Image<N> {
        explicit Image(Extent image_size) : Interleaved<>::Image<N>(checked(image_size)) {}
        static Extent checked(Extent image_size) {
            if (left == 0) throw std::bad_alloc{};
            if (left > 0) --left;
            return image_size;
        }
    };
};

} // namespace quell::tests

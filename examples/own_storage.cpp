// An image storage of your own: get and set are all that a view needs. Kernels put packs together from them.
#include <quell/quell.hpp>

#include <cstdio>
#include <map>
#include <memory>

/// Only pixels that aren't black take memory: for histories that are mostly empty. (Slow; one thread only.)
struct Sparse {
    using Exact = Sparse;
    template <int N> struct Image {
        std::shared_ptr<std::map<long, float>> pixels = std::make_shared<std::map<long, float>>();
        quell::Extent extent;

        explicit Image(quell::Extent size = {}) : extent(size) {}
        [[nodiscard]] std::size_t bytes() const { return pixels->size() * sizeof(float); }

        struct View {
            static constexpr int components = N;
            std::map<long, float>* pixels = nullptr;
            quell::Extent size;
            [[nodiscard]] long at(int c, int x, int y) const { return (long(c) * size.height + y) * size.width + x; }
            [[nodiscard]] float get(int c, int x, int y) const { return pixels->count(at(c, x, y)) ? pixels->at(at(c, x, y)) : 0.f; }
            void set(int c, int x, int y, float a) const { a == 0.f ? void(pixels->erase(at(c, x, y))) : void((*pixels)[at(c, x, y)] = a); }
        };
        [[nodiscard]] View view() const { return {pixels.get(), extent}; }
    };
};

int main() {
    using namespace quell;
    constexpr auto denoise = Pipeline{radiance, Temporal{StillMotion{}, Exponential{.alpha = 0.5f}}};
    Frame frame{{64, 32}, denoise};
    History history{{64, 32}, denoise, Sparse{}};
    frame[radiance].set(10, 10, {1.f, 2.f, 3.f});
    std::printf("%.2f\n", run(denoise, frame, history).get(2, 10, 10));
}

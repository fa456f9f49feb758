// All memory is the host's: quell reads the host's images in place, keeps its history in the host's arena, and writes into the host's
// picture. From the third frame on nothing is allocated at all.
#include <quell/quell.hpp>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

/// Everything that asks for memory in this program is counted. Outlined: g++ takes a pair of which it inlines one half for a mismatch.
static std::size_t calls = 0;
QUELL_OUTLINED void* operator new(std::size_t size, std::align_val_t align) {
    ++calls;
    auto const step = static_cast<std::size_t>(align);
    if (void* const memory = std::aligned_alloc(step, (size + step) / step * step)) return memory;
    throw std::bad_alloc();
}
QUELL_OUTLINED void* operator new(std::size_t size) { return operator new (size, std::align_val_t{16}); }
QUELL_OUTLINED void operator delete(void* memory) noexcept { std::free(memory); }
QUELL_OUTLINED void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
QUELL_OUTLINED void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

/// A block of floats that the host sets apart for quell. A storage has no state, so it is found by name.
struct Arena {
    static inline std::vector<float> floats = std::vector<float>(1 << 16);
    static inline std::size_t used = 0;
    static float* take(std::size_t count) {
        if (count > floats.size() - used) throw std::bad_alloc();
        return floats.data() + std::exchange(used, used + count);
    }
};

/// Keeps images in the arena, for as long as the program runs.
struct InArena {
    using Exact = InArena;
    template <int N> struct Image {
        /// A view with `load` and `store` of whole packs would be faster: see quell/image/image_storage.hpp.
        struct View {
            static constexpr int components = N;
            float* data = nullptr;
            quell::Extent size;
            [[nodiscard]] float get(int c, int x, int y) const { return data[(c * size.height + y) * size.width + x]; }
            void set(int c, int x, int y, float a) const { data[(c * size.height + y) * size.width + x] = a; }
        };
        View pixels;
        explicit Image(quell::Extent size = {}) : pixels{Arena::take(static_cast<std::size_t>(size.pixels()) * N), size} {}
        [[nodiscard]] View view() const { return pixels; }
        [[nodiscard]] std::size_t bytes() const { return static_cast<std::size_t>(pixels.size.pixels()) * N * sizeof(float); }
    };
};

/// The host's picture: RGBA, of which alpha stays as it is.
struct Rgba {
    static constexpr int components = 3;
    float* data;
    quell::Extent size;
    [[nodiscard]] float get(int c, int x, int y) const { return data[(y * size.width + x) * 4 + c]; }
    void set(int c, int x, int y, float a) const { data[(y * size.width + x) * 4 + c] = a; }
};

int main() {
    constexpr auto denoise = quell::presets::surface(quell::radiance);
    quell::Extent const size{64, 32};
    std::vector<float> rgba(64 * 32 * 4, 0.5f), normals(64 * 32 * 3, 0.57735f), depths(64 * 32, 2.f), motions(64 * 32 * 2, 0.f);
    std::vector<float> picture(64 * 32 * 4, -1.f);

    quell::Frame frame{size, denoise, quell::Borrowed<>{}};
    frame[quell::radiance] = {rgba.data() + 31 * 64 * 4, size, 4, -4 * 64}; // bottom row first
    frame[quell::normal] = {normals.data(), size, 3, 3 * 64};
    frame[quell::depth] = {depths.data(), size, 1, 64};
    frame[quell::motion] = {motions.data(), size, 2, 2 * 64};
    quell::History history{size, denoise, InArena{}};
    for (int i = 1; i <= 4; ++i) {
        auto const before = calls, used = Arena::used;
        run_into(Rgba{picture.data(), size}, denoise, frame, history);
        std::printf("frame %d: %s of the arena, %s of operator new\n", i, Arena::used > used ? "more" : "no more",
                    calls > before ? "some use" : "no use");
    }
    std::printf("%.2f, alpha %.0f\n", picture[0], picture[3]);
}

#include "../frames.hpp"

#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>

#include <cstring>
#include <functional>
#include <limits>
#include <vector>

using namespace quell;

// An executor with a queue computes what Serial does, although the host knows no counts when it enqueues the passes.
namespace {
/// A queue that the host runs where it waits. Its grid is one thread.
struct Later {
    std::vector<std::function<void()>>* queue;

    void for_each_pixel(Region region, auto const& job) const {
        enqueue(region, job);
        wait();
    }
    void enqueue(Region region, auto const& job) const {
        queue->push_back([region, job] { Serial{}.for_each_pixel(region, job); });
    }
    void enqueue_grid(Region region, auto const& work) const {
        queue->push_back([region, work] { work([&](auto const& job) { Serial{}.for_each_pixel(region, job); }); });
    }
    void clear(void* memory, std::size_t bytes) const {
        queue->push_back([memory, bytes] { std::memset(memory, 0, bytes); });
    }
    void read(void* to, void const* from, std::size_t bytes) const {
        wait();
        std::memcpy(to, from, bytes);
    }
    void submit() const {}
    void drop() const { queue->clear(); }
    void wait() const {
        for (auto const& each : *queue) each();
        queue->clear();
    }
};
static_assert(QueueExecutor<Later> && !QueueExecutor<Serial> && !QueueExecutor<Simd>);

/// Some samples are missing, in the second frame all, in the third most, so that there are holes. Some guides are impossible.
template <class F> void fill(F& frame, unsigned number) {
    tests::fill_randomly(frame, number);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x)
            if (number == 1 || (number == 2 && x + y > 9) || (x + 3 * y) % 17 == 0) frame[radiance].set(x, y, glm::vec3(nan));
    if (number != 3) return;
    if constexpr (F::template has<Albedo>) frame[albedo].set(5, 4, glm::vec3(7.f, -1.f, 0.f));
    frame[normal].set(2, 7, glm::vec3(9.f, 0.f, nan));
    frame[depth].set(11, 3, -4.f);
}

template <class P> void check_same(P const& denoise) {
    constexpr Extent size{37, 21};
    std::vector<std::function<void()>> queue;
    Later const later{&queue};
    Frame frame{size, denoise};
    History expected{size, denoise}, history{size, denoise};
    for (unsigned i = 0; i < 5; ++i) {
        fill(frame, i);
        auto const a = run(denoise, frame, expected, Serial{}), b = run(denoise, frame, history, later);
        CHECK(!queue.empty());
        auto const counts = expected.statistics(), same = history.statistics();
        CHECK(queue.empty());
        CHECK(counts.missing_samples == same.missing_samples);
        CHECK(counts.repaired_guides.pixels == same.repaired_guides.pixels);
        CHECK(counts.repaired_guides.of(depth) == (i == 3 ? 1 : 0));
        CHECK(counts.suppressed == same.suppressed);
        bool equal = true;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (int c = 0; c < a.components; ++c) equal = equal && a.get(c, x, y) == b.get(c, x, y);
        CHECK(equal);
    }
}
} // namespace

TEST_CASE("a queue gives the bits of Serial, with missing samples, holes and impossible guides") {
    check_same(presets::general(radiance, Demodulate{}));
    check_same(presets::svgf(radiance, SuppressFireflies{}));
    check_same(presets::surface(radiance));
}

TEST_CASE("the first frames of a queue see nothing") {
    constexpr auto denoise = presets::surface(radiance);
    constexpr Extent size{9, 5};
    std::vector<std::function<void()>> queue;
    Frame frame{size, denoise};
    History expected{size, denoise}, history{size, denoise};
    for (unsigned const i : {1u, 1u, 0u, 1u}) {
        fill(frame, i);
        auto const a = run(denoise, frame, expected, Serial{}), b = run(denoise, frame, history, Later{&queue});
        CHECK(expected.statistics().missing_samples == history.statistics().missing_samples);
        CHECK(expected.statistics().resets == history.statistics().resets);
        for (int x = 0; x < size.width; ++x) CHECK(a.get(1, x, 2) == b.get(1, x, 2));
    }
}

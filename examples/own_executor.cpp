// An executor of your own: a host's job system runs strips or tiles of each pass, and the image has the same bits as on one thread.
#include <quell/execute/outlined.hpp>
#include <quell/quell.hpp>

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <functional>
#include <latch>
#include <mutex>
#include <thread>
#include <vector>

/// Stands in for a host's job system: workers that take jobs from one queue.
class JobSystem {
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<std::function<void()>> jobs; // an empty one ends its worker
    std::vector<std::thread> workers;

    std::function<void()> next() {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return !jobs.empty(); });
        auto job = std::move(jobs.front());
        jobs.pop_front();
        return job;
    }

public:
    explicit JobSystem(std::size_t count) {
        while (workers.size() < count)
            workers.emplace_back([this] {
                while (auto const job = next()) job();
            });
    }
    ~JobSystem() {
        for (std::size_t i = 0; i < workers.size(); ++i) start({});
        for (auto& worker : workers) worker.join();
    }
    void start(std::function<void()> job) {
        std::scoped_lock const lock(mutex);
        jobs.push_back(std::move(job));
        wake.notify_one();
    }
};

/// Cuts each pass into tiles, one job each, and waits for all of them. quell starts the next pass when this returns.
struct OnJobs {
    JobSystem* system;
    quell::Extent tile;       ///< pixels; whole packs wide, so that no lane is idle
    quell::Outlined<> each{}; ///< shares the kernels' code with other executors: compiled once

    void for_each_pixel(quell::Region r, auto const& job) const {
        std::latch left(((r.x1 - r.x0 + tile.width - 1) / tile.width) * std::ptrdiff_t((r.y1 - r.y0 + tile.height - 1) / tile.height));
        for (int y = r.y0; y < r.y1; y += tile.height)
            for (int x = r.x0; x < r.x1; x += tile.width)
                system->start([&, x, y] {
                    each.for_each_pixel({x, y, std::min(x + tile.width, r.x1), std::min(y + tile.height, r.y1)}, job);
                    left.count_down();
                });
        left.wait();
    }
};

/// The last of four noisy frames of a wall, denoised.
std::vector<float> denoised(auto const& executor) {
    constexpr auto denoise = quell::presets::surface_clamp(quell::radiance);
    quell::Frame frame{quell::Extent{101, 67}, denoise};
    quell::History history{frame.size, denoise};
    std::vector<float> last;
    for (int n = 0; n < 4; ++n) {
        for (int y = 0; y < 67; ++y)
            for (int x = 0; x < 101; ++x) {
                frame[quell::radiance].set(x, y, glm::vec3(static_cast<float>((n * 263 + y * 523 + x * 7919) % 1009)));
                frame[quell::normal].set(x, y, {0.f, 0.f, 1.f}), frame[quell::depth].set(x, y, 4.f);
            }
        auto const clean = run(denoise, frame, history, executor);
        last.clear();
        for (int i = 0; i < 101 * 67 * 3; ++i) last.push_back(clean.get(i % 3, i / 3 % 101, i / 303));
    }
    return last;
}

int main() {
    JobSystem system(3);
    auto const reference = denoised(quell::Outlined<>{});
    std::printf("strips: %s\n", denoised(OnJobs{&system, {101, 8}}) == reference ? "the same bits" : "other bits");
    std::printf("tiles: %s\n", denoised(OnJobs{&system, {32, 16}}) == reference ? "the same bits" : "other bits");
}

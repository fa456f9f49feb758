#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace quell::live {

/// Threads that take turns of a loop, as the caller does. The caller never waits for one that has taken none: a browser may start a thread
/// late, and its main thread must not sleep.
class Workers {
    std::mutex mutex; // guards the loop and `is_over`
    std::condition_variable wake;
    std::function<void(int)> const* turn = nullptr; // of the loop that runs; none: there is none to enter
    int turns = 0, invited = 0;
    unsigned loop = 0; // its number
    bool is_over = false;
    std::atomic<int> next{0}, inside{0}; // the next turn, and the workers within the loop
    std::vector<std::thread> threads;

    void take_turns(std::function<void(int)> const& take) {
        for (int i; (i = next.fetch_add(1, std::memory_order_relaxed)) < turns;) take(i);
    }
    void work(int number) {
        for (unsigned seen = 0;;) {
            std::function<void(int)> const* entered = nullptr;
            {
                std::unique_lock lock(mutex);
                wake.wait(lock, [&] { return is_over || loop != seen; });
                if (is_over) return;
                seen = loop;
                if (turn == nullptr || number >= invited) continue;
                entered = turn;
                inside.fetch_add(1, std::memory_order_relaxed);
            }
            take_turns(*entered);
            inside.fetch_sub(1, std::memory_order_release); // whoever sees it sees what the turns have written
        }
    }

public:
    /// @param count how many, beside the caller
    explicit Workers(int count) {
        for (int i = 0; i < count; ++i) threads.emplace_back([this, i] { work(i); });
    }
    ~Workers() {
        {
            std::scoped_lock const lock(mutex);
            is_over = true;
        }
        wake.notify_all();
        for (auto& thread : threads) thread.join();
    }
    Workers(Workers const&) = delete;
    Workers& operator=(Workers const&) = delete;

    [[nodiscard]] int count() const { return static_cast<int>(threads.size()); }

    /// Calls task(0) to task(count - 1), each once and in any order; returns when all are done.
    /// @param helpers how many workers may take turns
    void share(int count, std::function<void(int)> const& task, int helpers) {
        {
            std::scoped_lock const lock(mutex);
            turn = &task, turns = count, invited = helpers, ++loop;
            next.store(0, std::memory_order_relaxed);
        }
        wake.notify_all();
        take_turns(task);
        {
            std::scoped_lock const lock(mutex);
            turn = nullptr; // nobody enters any more
        }
        while (inside.load(std::memory_order_acquire) > 0) std::this_thread::yield(); // the last turns, which are short
    }
};

} // namespace quell::live

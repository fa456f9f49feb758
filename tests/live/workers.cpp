#include <doctest/doctest.h>
#include <live/workers.hpp>

#include <chrono>

using quell::live::Workers;

TEST_CASE("workers and the caller take each turn once, whoever and however many they are") {
    for (int const count : {0, 1, 3}) {
        Workers workers(count);
        for (int const helpers : {0, 1, count})
            for (int const turns : {0, 1, 2, 97})
                for (int repeated = 0; repeated < 20; ++repeated) {
                    std::vector<int> taken(
                        static_cast<std::size_t>(turns)); // without atomics: nobody else writes a turn's own, and share() hands it over
                    workers.share(
                        turns, [&](int i) { ++taken[static_cast<std::size_t>(i)]; }, helpers);
                    CHECK(taken == std::vector<int>(taken.size(), 1));
                }
    }
}

TEST_CASE("as many threads take turns as may, and no more") {
    Workers workers(3);
    for (int const helpers : {0, 1, 2, 3}) {
        // The turns are over when enough are under way at once, or some time has passed.
        std::atomic<int> at_once{0}, most{0};
        auto const meet = [&](int) {
            int const now = at_once.fetch_add(1) + 1;
            for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
            }
            auto const end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
            while (most < helpers + 1 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
            at_once.fetch_sub(1);
        };
        workers.share(8, meet, helpers);
        CHECK(most == helpers + 1);
    }
}

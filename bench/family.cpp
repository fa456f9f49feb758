#include "family.hpp"

namespace quell::bench {

Seconds Workload::next(How how) {
    auto const& frames = sequence(size);
    taken.clear();
    auto const before = Seconds::now();
    run(frames[at], how);
    auto const whole = Seconds::now() - before;
    at = (at + 1) % frames.size();
    return whole;
}

void Workload::warm_up(Extent size_) {
    size = size_;
    for (int i = 0; i < 8; ++i) next({How::Kind::threads, most_threads()});
}

double Family::bound(std::size_t pass, Extent size, int threads) const {
    return cost(pass).bound(machine(threads), stored_size) * static_cast<double>(size.pixels());
}

double Family::bound(Extent size, int threads) const {
    double sum = 0.;
    for (std::size_t i = 0; i < passes.size(); ++i) sum += bound(i, size, threads);
    return sum;
}

Workload& workload(Family const& family, Extent size) {
    static std::unique_ptr<Workload> made;
    static std::string made_for;
    auto const wanted = family.preset + "/" + family.storage + "/" + to_string(size);
    if (made_for != wanted) {
        made_for.clear();
        made.reset();
        made = family.make(size);
        made->warm_up(size);
        made_for = wanted;
    }
    return *made;
}

} // namespace quell::bench

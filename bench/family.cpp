#include "family.hpp"

#include "sequence.hpp"

#include <quell/image/interleaved.hpp>
#include <quell/image/planar.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace quell::bench {

Seconds Workload::next(How how) {
    taken.clear();
    auto const before = Seconds::now();
    run(at, how);
    auto const whole = Seconds::now() - before;
    at = (at + 1) % sequence_frames;
    return whole;
}

void Workload::warm_up() {
    for (int i = 0; i < 8; ++i) next({How::Kind::threads, max_threads()});
}

namespace {
template <class Storage, std::size_t... unit> void append_families(std::vector<Family>& all, std::index_sequence<unit...>) {
    (std::ranges::move(families_of_unit<Storage, unit, sizeof...(unit)>(), std::back_inserter(all)), ...);
}
template <class... Storages> std::vector<Family> families_with() {
    std::vector<Family> all;
    (append_families<Storages>(all, std::make_index_sequence<QUELL_BENCH_UNITS>{}), ...);
    std::ranges::stable_sort(all, {}, &Family::order);
    return all;
}
} // namespace

std::vector<Family> families() { return families_with<QUELL_BENCH_STORAGES>(); }

Workload& workload(Family const& family, Extent size) {
    static std::unique_ptr<Workload> made;
    static std::string made_for;
    auto const wanted = family.preset + "/" + family.storage + "/" + to_string(size);
    if (made_for != wanted) {
        made_for.clear();
        made.reset();
        made = family.make(size);
        made->warm_up();
        made_for = wanted;
    }
    return *made;
}

} // namespace quell::bench

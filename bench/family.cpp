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
    if (how.kind == How::Kind::serial)
        serial->run(at, how);
    else
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
    std::vector<Family> others, all = compiled_families();
    (append_families<Storages>(others, std::make_index_sequence<QUELL_BENCH_UNITS>{}), ...);
    for (auto& family : others) {
        auto const same = [&](Family const& f) { return f.preset == family.preset && f.storage == family.storage; };
        auto const behind = std::ranges::find(all.rbegin(), all.rend(), family.preset, &Family::preset).base();
        if (auto const found = std::ranges::find_if(all, same); found != all.end())
            found->make_serial = family.make_serial;
        else if (behind != all.begin()) // QUELL_PRESETS has the preset
            all.insert(behind, std::move(family));
    }
    return all;
}
} // namespace

std::vector<std::string> pass_names(std::vector<std::string> const& passes) {
    auto names = passes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::ranges::replace(names[i], ' ', '-');
        if (std::ranges::count(passes, passes[i]) > 1)
            names[i] += "/" + std::to_string(std::count(passes.begin(), passes.begin() + static_cast<std::ptrdiff_t>(i), passes[i]));
    }
    return names;
}

std::vector<Family> families() { return families_with<QUELL_BENCH_STORAGES>(); }

Workload& workload(Family const& family, Extent size) {
    static std::unique_ptr<Workload> made;
    static std::string made_for;
    auto const wanted = family.preset + "/" + family.storage + "/" + to_string(size);
    if (made_for != wanted) {
        made_for.clear();
        made.reset();
        made = family.make(size);
        if (family.make_serial != nullptr) made->serial = family.make_serial(size);
        made->warm_up();
        made_for = wanted;
    }
    return *made;
}

} // namespace quell::bench

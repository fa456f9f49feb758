#pragma once

#include "job_parts.hpp"
#include "layouts.hpp"

// How the host's compiler lays out what kernels are given, and a kernel that says how the device's does. That kernel never runs: its code
// is a row of stores of constants, which check_layouts() reads in PTX.
namespace quell::bench {

/// Calls put(number) with the numbers of Job's layout.
template <class Job> constexpr void for_each_number(auto&& put) {
    constexpr unsigned hash = [] {
        unsigned sum = 2166136261u;
        for (char const* c = Job::name; *c != 0; ++c) sum = (sum ^ static_cast<unsigned char>(*c)) * 16777619u;
        return sum;
    }();
    put(hash);
    put(static_cast<unsigned>(alignof(Job)));
    // Only a place for a job: not an argument, of which a compiler would ask whether it is null.
    alignas(Job) unsigned char memory[sizeof(Job)];
    auto const* const job = static_cast<Job const*>(static_cast<void const*>(memory));
    visit_parts(*job, [&](auto const& part) {
        auto const address = [](void const* p) { return static_cast<char const*>(p); };
        put(static_cast<unsigned>(address(&part) - address(job)));
        put(static_cast<unsigned>(sizeof(part)));
    });
}
template <class Job> __global__ void layout_for_device(unsigned volatile* out) {
    for_each_number<Job>([&](unsigned number) { *out++ = number; });
}

template <class Job> bool list_layout() {
    KnownLayout known{Job::name, {}};
    for_each_number<Job>([&](unsigned number) { known.layout.push_back(number); });
    // Naming the kernel is what makes it.
    static_cast<void>(static_cast<void (*)(unsigned volatile*)>(layout_for_device<Job>));
    known_layouts().push_back(std::move(known));
    return true;
}
/// Naming it puts Job into known_layouts() before main().
template <class Job> inline bool const is_listed = list_layout<Job>();

} // namespace quell::bench

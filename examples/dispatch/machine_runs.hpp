#pragma once

#include <string_view>

/// Whether this machine, and its operating system, run code that is compiled with -march=NAME: x86-64 and its levels v3 and v4. False for
/// other names. By single features, since clang++ 14 does not know the levels: a machine with these has the rest of its level too.
inline bool machine_runs(std::string_view name) {
    __builtin_cpu_init();
    bool const v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
    if (name == "x86-64-v3") return v3;
    if (name == "x86-64-v4")
        return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return name == "x86-64";
}

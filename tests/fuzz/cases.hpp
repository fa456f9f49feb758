#pragma once

#include <functional>
#include <string>
#include <vector>

namespace quell::fuzz {

class Bytes;

/// A preset that the fuzzer's program runs: it has those that are linked into it.
struct FuzzedPreset {
    std::string name;
    std::function<void(Bytes&)> run;
};
std::vector<FuzzedPreset>& cases();

/// Makes a case known before main().
struct Known {
    explicit Known(FuzzedPreset made) { cases().push_back(std::move(made)); }
};

} // namespace quell::fuzz

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace quell::fuzz {

class Bytes;

/// A preset that the fuzzer's program runs: it has those that are linked into it.
struct Case {
    std::string name;
    std::function<void(Bytes&)> run;
};
std::vector<Case>& cases();

/// Makes a case known before main().
struct Known {
    explicit Known(Case made) { cases().push_back(std::move(made)); }
};

} // namespace quell::fuzz

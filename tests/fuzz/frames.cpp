#include "cases.hpp"
#include "input.hpp"

#include <algorithm>

// libFuzzer's program for whole frames: the input's first byte chooses the preset.
namespace quell::fuzz {

std::vector<FuzzedPreset>& cases() {
    static std::vector<FuzzedPreset> all;
    return all;
}

} // namespace quell::fuzz

using namespace quell::fuzz;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    // What a byte means must not depend on the order of linking.
    std::ranges::sort(cases(), {}, &FuzzedPreset::name);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    Bytes in({data, size});
    cases()[in.byte() % cases().size()].run(in);
    return 0;
}

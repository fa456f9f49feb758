#include "cases.hpp"
#include "input.hpp"

#include <doctest/doctest.h>

#include <random>

// Every preset under -ffast-math, over frames of arbitrary bits. What must hold is tested by bits, in tests/fuzz/arbitrary_frames.hpp: a
// number that is not finite ends the program with a line that names the preset, the channel and the pixel.

namespace quell::fuzz {
std::vector<FuzzedPreset>& cases() {
    static std::vector<FuzzedPreset> all;
    return all;
}
} // namespace quell::fuzz

TEST_CASE("under -ffast-math, output and history of every policy are finite for any bits") {
    REQUIRE(quell::fuzz::cases().size() > 13);
    for (auto const& preset : quell::fuzz::cases()) {
        CAPTURE(preset.name);
        std::mt19937 random(7);
        for (int i = 0; i < 200; ++i) {
            std::vector<std::uint8_t> bytes(200);
            for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
            quell::fuzz::Bytes in(bytes);
            CHECK_NOTHROW(preset.run(in));
        }
    }
}

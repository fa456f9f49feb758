#pragma once

#include <quell/core/error.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

/// Walks over the attributes of a file's headers without reading them. The OpenEXR library allocates an attribute's length before it checks
/// it: four damaged bytes can ask for 2 GB.
class HeaderCheck {
    std::ifstream in;
    std::int64_t end;
    std::int32_t version = 0;
    int newest = 0;

public:
    explicit HeaderCheck(std::filesystem::path const& path) : in(path, std::ios::binary) {
        in.seekg(0, std::ios::end);
        end = in.tellg();
        in.seekg(4); // after the magic number
    }

    /// Whether every attribute lies within the file.
    [[nodiscard]] bool passes() {
        version = number();
        bool const several_parts = (version & 0x1000) != 0;
        do {
            for (auto name = text(); !name.empty(); name = text()) { // an empty one ends the header
                auto const type = text();
                auto const length = number();
                if (name == "compression" && type == name && length == 1) newest = std::max(newest, in.peek());
                if (!skip(length)) return false;
            }
        } while (several_parts && in.good() && in.peek() != 0); // an empty header ends them all
        return in.good();
    }

    /// After passes(): the largest number of a compression in any part. Later versions of OpenEXR add numbers.
    [[nodiscard]] int newest_compression() const { return newest; }
    /// After passes(): the version of the file's format.
    [[nodiscard]] int format() const { return version & 0xff; }

private:
    std::int32_t number() {
        std::array<char, 4> bytes{};
        in.read(bytes.data(), 4);
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
        return static_cast<std::int32_t>(value);
    }
    /// Names have at most 255 characters.
    std::string text() {
        std::string characters;
        while (characters.size() < 256) {
            auto const character = in.get();
            if (character <= 0) return characters;
            characters.push_back(static_cast<char>(character));
        }
        in.setstate(std::ios::failbit);
        return {};
    }
    bool skip(std::int32_t length) {
        bool const inside = in.good() && length >= 0 && length <= end - in.tellg();
        if (inside) in.seekg(length, std::ios::cur);
        return inside;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail

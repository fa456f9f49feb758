#pragma once

#include <quell/core/error.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace quell::inline QUELL_INSTRUCTION_SET::io::detail {

/// Walks over the attributes of a file's headers without reading them. The OpenEXR library allocates an attribute's length before it checks
/// it: four damaged bytes can ask for 2 GB.
class HeaderCheck {
    std::ifstream in;
    std::int64_t end;

public:
    explicit HeaderCheck(std::filesystem::path const& path) : in(path, std::ios::binary) {
        in.seekg(0, std::ios::end);
        end = in.tellg();
        in.seekg(4); // after the magic number
    }

    /// Whether every attribute lies within the file.
    [[nodiscard]] bool passes() {
        bool const several_parts = (number() & 0x1000) != 0;
        do {
            while (skip_text() > 0) // attribute's name; an empty one ends the header
                if (skip_text(); !skip(number())) return false;
        } while (several_parts && in.good() && in.peek() != 0); // an empty header ends them all
        return in.good();
    }

private:
    std::int32_t number() {
        std::array<char, 4> bytes{};
        in.read(bytes.data(), 4);
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
        return static_cast<std::int32_t>(value);
    }
    /// Returns its length. Names have at most 255 characters.
    int skip_text() {
        for (int length = 0; length < 256; ++length)
            if (auto const character = in.get(); character <= 0) return length;
        in.setstate(std::ios::failbit);
        return 0;
    }
    bool skip(std::int32_t length) {
        bool const inside = in.good() && length >= 0 && length <= end - in.tellg();
        if (inside) in.seekg(length, std::ios::cur);
        return inside;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::io::detail

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

namespace quell::tracer {

/// A hash of whatever is added to it, in order (FNV-1a, 64 bits). Good against accidents, not against malice.
class Digest {
public:
    void add_bytes(void const* data, std::size_t size) {
        auto const* bytes = static_cast<unsigned char const*>(data);
        for (std::size_t i = 0; i < size; ++i) state = (state ^ bytes[i]) * 0x100000001b3u;
    }
    /// Only for types without padding, whose bytes are their value.
    template <class Value>
        requires std::is_trivially_copyable_v<Value>
    void add(Value const& value) { add_bytes(&value, sizeof value); }
    void add(std::string_view text) {
        add(text.size());
        add_bytes(text.data(), text.size());
    }
    template <class Value> void add(std::vector<Value> const& values) {
        add(values.size());
        add_bytes(values.data(), values.size() * sizeof(Value));
    }
    [[nodiscard]] std::uint64_t value() const { return state; }

private:
    std::uint64_t state = 0xcbf29ce484222325u;
};

} // namespace quell::tracer

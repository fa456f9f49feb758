#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// What the library's own code and its code for one instruction set say to each other. No header of quell's is included: these types are the
// same for all instruction sets.
namespace quell_library {

/// An image of the caller's. Strides are in bytes.
struct Image {
    std::byte* data = nullptr;
    std::ptrdiff_t component_stride = 0, pixel_stride = 0, row_stride = 0;
    bool is_half = false;
};

struct Channel {
    std::string name{};
    int components = 0;
};

struct Camera {
    float view[16], projection[16], jitter[2];
};

struct Frame {
    std::vector<Image> channels{}; ///< in the preset's order
    Image output{};
    Camera const* camera = nullptr;
    long long number = 0;
    bool has_number = false;
    float shutter = 0.5f;
};

/// Runs tasks side by side.
struct Parallel {
    void (*run)(void* user, std::int32_t count, void (*task)(void* context, std::int32_t index), void* context) = nullptr;
    void* user = nullptr;
};
/// Where images lie.
struct Memory {
    void* (*allocate)(void* user, std::size_t bytes, std::size_t alignment) = nullptr;
    void (*release)(void* user, void* memory) = nullptr;
    void* user = nullptr;
};

struct Statistics {
    long long frames = 0, resets = 0, missing_samples = 0, repaired_guides = 0;
    std::size_t bytes = 0;
};

enum class Outcome { ok, invalid, no_memory, failed };

/// A preset with its history.
class Instance {
public:
    Instance() = default;
    Instance(Instance const&) = delete;
    Instance& operator=(Instance const&) = delete;
    virtual ~Instance() = default;
    /// @param error what is wrong, where it is not ok
    virtual Outcome run(Frame const& frame, std::string& error) noexcept = 0;
    virtual void forget() noexcept = 0;
    [[nodiscard]] virtual Statistics statistics() const noexcept = 0;
};

/// A preset as code.
struct PresetCode {
    std::string name{};
    std::vector<Channel> channels{};
    int output_components = 0;
    bool needs_camera = false;
    std::string (*plan)() = nullptr;
    /// Null, and what is wrong, where it can't be made.
    std::unique_ptr<Instance> (*make)(int width, int height, Parallel const&, Memory const&, Outcome& outcome,
                                      std::string& error) noexcept = nullptr;
};

/// All presets, compiled for one instruction set.
using PresetCodes = std::vector<PresetCode> const&();

} // namespace quell_library

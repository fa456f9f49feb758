#pragma once

#include <vulkan/vulkan_raii.hpp>

namespace quell::vulkan {

/// A buffer with memory of its own.
struct Buffer {
    vk::raii::Buffer buffer = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    void* mapped = nullptr; ///< of one that the host reaches
};

/// The first device that has a queue for compute shaders.
class Device {
    vk::raii::Context context;
    vk::raii::Instance instance;
    vk::raii::PhysicalDevice physical = nullptr;

public:
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::CommandPool commands = nullptr;

    /// @throws Failure where there is none
    Device();
    /// @param by_host whether the host writes or reads it; else it lies where the device is fastest
    [[nodiscard]] Buffer make_buffer(vk::DeviceSize bytes, vk::BufferUsageFlags usage, bool by_host) const;
    [[nodiscard]] vk::PhysicalDeviceProperties properties() const { return physical.getProperties(); }
};

} // namespace quell::vulkan

#pragma once

#include <vulkan/vulkan.h>

#include <string>

namespace quell::vulkan {

/// Raises what a call has returned as one sentence, unless it is success.
void check(VkResult result, char const* call);

/// A buffer with memory of its own.
struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* mapped = nullptr; ///< of one that the host reaches
};

/// The first device that has a queue for compute shaders.
class Device {
public:
    /// @throws Failure where there is none
    Device();
    ~Device();
    Device(Device const&) = delete;
    Device& operator=(Device const&) = delete;

    /// @param by_host whether the host writes or reads it; else it lies where the device is fastest
    [[nodiscard]] Buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, bool by_host) const;
    void destroy(Buffer& buffer) const;

    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool commands = VK_NULL_HANDLE;
    std::string name;
    std::uint32_t most_texels = 0; ///< of a view of a buffer

private:
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;

    void choose();
    [[nodiscard]] std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;
};

} // namespace quell::vulkan

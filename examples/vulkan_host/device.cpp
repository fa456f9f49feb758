#include "device.hpp"

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::vulkan {

namespace {
vk::raii::Instance make_instance(vk::raii::Context const& context) {
    try {
        vk::ApplicationInfo const application(nullptr, 0, nullptr, 0, VK_API_VERSION_1_1);
        return context.createInstance({{}, &application});
    } catch (vk::SystemError const&) {
        raise_error<Failure>("Vulkan", "there is no driver", "install one; mesa-vulkan-drivers has one for CPUs");
    }
}

constexpr bool computes(vk::QueueFamilyProperties const& family) {
    return static_cast<bool>(family.queueFlags & vk::QueueFlagBits::eCompute);
}

std::uint32_t memory_type(vk::raii::PhysicalDevice const& physical, std::uint32_t allowed, vk::MemoryPropertyFlags wanted) {
    auto const all = physical.getMemoryProperties();
    for (std::uint32_t type = 0; type < all.memoryTypeCount; ++type)
        if ((allowed >> type & 1) != 0 && (all.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    raise_error<Failure>("Vulkan", "the device has no memory of the kind that a buffer needs", "take another device");
}
} // namespace

Device::Device() : instance(make_instance(context)) {
    for (auto& candidate : vk::raii::PhysicalDevices(instance)) {
        auto const families = candidate.getQueueFamilyProperties();
        auto const found = std::ranges::find_if(families, computes);
        if (found == families.end()) continue;
        auto const family = static_cast<std::uint32_t>(found - families.begin());
        float const priority = 1.f;
        vk::DeviceQueueCreateInfo const of_queue({}, family, 1, &priority);
        physical = std::move(candidate);
        device = physical.createDevice({{}, of_queue});
        queue = device.getQueue(family, 0);
        commands = device.createCommandPool({vk::CommandPoolCreateFlagBits::eResetCommandBuffer, family});
        return;
    }
    raise_error<Failure>("Vulkan", "no device has a queue for compute shaders", "install a driver; mesa-vulkan-drivers has one for CPUs");
}

Buffer Device::make_buffer(vk::DeviceSize bytes, vk::BufferUsageFlags usage, bool by_host) const {
    using enum vk::MemoryPropertyFlagBits;
    auto const wanted = by_host ? eHostVisible | eHostCoherent : vk::MemoryPropertyFlags(eDeviceLocal);
    Buffer made{.buffer = device.createBuffer({{}, bytes, usage})};
    auto const needs = made.buffer.getMemoryRequirements();
    made.memory = device.allocateMemory({needs.size, memory_type(physical, needs.memoryTypeBits, wanted)});
    made.buffer.bindMemory(*made.memory, 0);
    if (by_host) made.mapped = made.memory.mapMemory(0, VK_WHOLE_SIZE);
    return made;
}

} // namespace quell::vulkan

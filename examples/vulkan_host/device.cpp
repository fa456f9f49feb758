#include "device.hpp"

#include <quell/core/error.hpp>

#include <vector>

namespace quell::vulkan {

void check(VkResult result, char const* call) {
    if (result == VK_SUCCESS) return;
    auto const fails = [&](char const* found, char const* remedy) { raise_error<Failure>(call, found, remedy); };
    switch (result) {
    case VK_ERROR_DEVICE_LOST:
        return fails("the device is lost", "make the device and all buffers again, and call forget(): there is no past");
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return fails("the device has too little memory", "take smaller frames");
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return fails("the host has too little memory", "take smaller frames");
    default:
        return fails(("VkResult " + std::to_string(result)).c_str(), "see the Vulkan specification");
    }
}

namespace {
VkInstance make_instance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    return vkCreateInstance(&info, nullptr, &instance) == VK_SUCCESS ? instance : VK_NULL_HANDLE;
}
std::vector<VkPhysicalDevice> devices_of(VkInstance instance) {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance, &count, all.data());
    return all;
}
} // namespace

Device::Device() : instance(make_instance()) {
    if (instance == VK_NULL_HANDLE)
        raise_error<Failure>("Vulkan", "there is no driver", "install one; mesa-vulkan-drivers has one for CPUs");
    try {
        choose();
    } catch (...) { // then there is no ~Device
        if (device != VK_NULL_HANDLE) vkDestroyDevice(device, nullptr);
        vkDestroyInstance(instance, nullptr);
        throw;
    }
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    name = properties.deviceName, most_texels = properties.limits.maxTexelBufferElements;
}
Device::~Device() {
    vkDestroyCommandPool(device, commands, nullptr);
    vkDestroyDevice(device, nullptr);
    vkDestroyInstance(instance, nullptr);
}

void Device::choose() {
    for (auto const candidate : devices_of(instance)) {
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(candidate, &count, families.data());
        for (std::uint32_t family = 0; family < count; ++family) {
            if ((families[family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
            physical = candidate;
            float const priority = 1.f;
            VkDeviceQueueCreateInfo of_queue{};
            of_queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
            of_queue.queueFamilyIndex = family, of_queue.queueCount = 1, of_queue.pQueuePriorities = &priority;
            VkDeviceCreateInfo info{};
            info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
            info.queueCreateInfoCount = 1, info.pQueueCreateInfos = &of_queue;
            check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
            vkGetDeviceQueue(device, family, 0, &queue);
            VkCommandPoolCreateInfo of_pool{};
            of_pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
            of_pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
            of_pool.queueFamilyIndex = family;
            check(vkCreateCommandPool(device, &of_pool, nullptr, &commands), "vkCreateCommandPool");
            return;
        }
    }
    raise_error<Failure>("Vulkan", "no device has a queue for compute shaders", "install a driver; mesa-vulkan-drivers has one for CPUs");
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    VkPhysicalDeviceMemoryProperties all;
    vkGetPhysicalDeviceMemoryProperties(physical, &all);
    for (std::uint32_t type = 0; type < all.memoryTypeCount; ++type)
        if ((allowed >> type & 1) != 0 && (all.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    raise_error<Failure>("Vulkan", "the device has no memory of the kind that a buffer needs", "take another device");
}

Buffer Device::make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, bool by_host) const {
    Buffer made;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes, info.usage = usage;
    check(vkCreateBuffer(device, &info, nullptr, &made.buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, made.buffer, &needs);
    VkMemoryAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex =
        memory_type(needs.memoryTypeBits, by_host ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                                  : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkAllocateMemory(device, &allocation, nullptr, &made.memory), "vkAllocateMemory");
    check(vkBindBufferMemory(device, made.buffer, made.memory, 0), "vkBindBufferMemory");
    if (by_host) check(vkMapMemory(device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "vkMapMemory");
    return made;
}
void Device::destroy(Buffer& buffer) const {
    vkDestroyBuffer(device, buffer.buffer, nullptr);
    vkFreeMemory(device, buffer.memory, nullptr);
    buffer = {};
}

} // namespace quell::vulkan

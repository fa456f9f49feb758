#pragma once

#include <quell/execute/device.cuh>
#include <quell/image/managed.cuh>

#include <stdexcept>
#include <string>

namespace quell_library::inline QUELL_INSTRUCTION_SET {

namespace detail {
inline void check(cudaError_t status, char const* what, char const* remedy) {
    if (status == cudaSuccess) return;
    cudaGetLastError(); // forgets it: later calls don't fail for it
    quell::raise_error<quell::Failure>(what, cudaGetErrorString(status), quell::detail::cuda_remedy(status, remedy));
}
inline int current_device() {
    int device = 0;
    check(cudaGetDevice(&device), "the device", "select a device by cudaSetDevice()");
    return device;
}
} // namespace detail

/// The device has too little memory. A sentence.
struct NoDeviceMemory : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Memory of the device, for images of quell's own. It tells a lack of memory from other errors. Where images may move, what the device
/// has no room for lies in managed memory, which the driver moves to and from it as passes use it.
struct LibraryMemory : quell::DeviceMemory {
    /// Whether images that are made from now on in this thread may move.
    static bool& may_move() {
        static thread_local bool value = false;
        return value;
    }
    static void* allocate(std::size_t bytes) {
        try {
            return may_move() && !has_room(bytes) ? quell::ManagedMemory::allocate(bytes) : quell::DeviceMemory::allocate(bytes);
        } catch (quell::Error const& error) {
            if (error.found != cudaGetErrorString(cudaErrorMemoryAllocation)) throw;
            throw NoDeviceMemory("memory of the device: there is none for " + std::to_string(bytes) +
                                 " bytes; give smaller frames, or let go of other memory there");
        }
    }

private:
    /// An eighth of the device stays free, for what moves.
    static bool has_room(std::size_t bytes) {
        std::size_t free = 0, all = 0;
        detail::check(cudaMemGetInfo(&free, &all), "the device's memory", "look for an error of an earlier call of CUDA");
        return bytes + all / 8 <= free;
    }
};

/// For as long as it lives, images that are made in this thread may move, or may not.
class MayMove {
    bool before;

public:
    explicit MayMove(bool may) : before(LibraryMemory::may_move()) { LibraryMemory::may_move() = may; }
    ~MayMove() { LibraryMemory::may_move() = before; }
    MayMove(MayMove const&) = delete;
    MayMove& operator=(MayMove const&) = delete;
};

/// For as long as it lives, calls of CUDA are about this device.
class OnDevice {
    int before;
    bool differs;

public:
    explicit OnDevice(int device) : before(detail::current_device()), differs(before != device) {
        if (differs) detail::check(cudaSetDevice(device), "the denoiser's device", "look for an error of an earlier call of CUDA");
    }
    ~OnDevice() {
        if (differs) cudaSetDevice(before);
    }
    OnDevice(OnDevice const&) = delete;
    OnDevice& operator=(OnDevice const&) = delete;
};

/// Whether kernels on this device reach an image of the caller's where it lies.
/// @param what names it in errors
/// @throws quell::Error where it lies on another device
inline bool is_reached(std::byte const* image, int device, std::string const& what) {
    cudaPointerAttributes attributes{};
    detail::check(cudaPointerGetAttributes(&attributes, image), what.c_str(), "give memory of the host or of the device");
    if (attributes.type == cudaMemoryTypeManaged) return true;
    if (attributes.type != cudaMemoryTypeDevice) return false;
    if (attributes.device != device)
        quell::raise_error(
            what, "its memory is of device " + std::to_string(attributes.device) + ", the denoiser is of device " + std::to_string(device),
            "make the denoiser where that device is the current one, or copy the image");
    return true;
}

/// Whether the device can use more managed memory than it has.
inline bool can_move(int device) {
    int can = 0;
    detail::check(cudaDeviceGetAttribute(&can, cudaDevAttrConcurrentManagedAccess, device), "the device",
                  "select a device by cudaSetDevice()");
    return can != 0;
}

/// @throws NoDeviceMemory where so many bytes are not free
inline void check_free_memory(std::size_t needed, quell::Extent size) {
    std::size_t free = 0, all = 0;
    detail::check(cudaMemGetInfo(&free, &all), "the device's memory", "look for an error of an earlier call of CUDA");
    if (needed <= free) return;
    throw NoDeviceMemory("memory of the device: history and scratch of " + to_string(size) + " pixels take " + std::to_string(needed) +
                         " bytes, and " + std::to_string(free) + " are free; give smaller frames, or let go of other memory there");
}

} // namespace quell_library::inline QUELL_INSTRUCTION_SET

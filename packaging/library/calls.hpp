#pragma once

// What the functions of C interfaces have in common. Includes no header of quell's.
#include "preset_code.hpp"
#include "quell.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace quell_library {

/// What was wrong with the last call in this thread.
inline std::string& last_error() {
    static thread_local std::string text;
    return text;
}
inline quell_status fail(quell_status status, std::string const& sentence) {
    last_error() = sentence;
    return status;
}
/// Calls f, which may run out of memory.
template <class F> quell_status guarded(F&& f) noexcept {
    try {
        last_error().clear();
        return f();
    } catch (std::bad_alloc const&) {
        return QUELL_NO_MEMORY; // no memory for a sentence either
    } catch (std::exception const& thrown) {
        try {
            return fail(QUELL_FAILED, thrown.what());
        } catch (...) {
            return QUELL_FAILED;
        }
    }
}

/// Takes a structure that begins with its size. What an earlier version of it lacks keeps its default; of a later version's further members
/// none may be set.
/// @param first size of the first version
template <class T>
std::string take_struct(T& to, std::byte const* from, std::string const& name, std::string const& start, std::size_t first,
                        std::string const& header = "quell.h") {
    std::size_t size = 0;
    std::memcpy(&size, from, sizeof(size));
    auto const known = std::min(size, sizeof(T));
    bool const is_set =
        size < sizeof(T) + 4096 && std::any_of(from + known, from + std::max(size, known), [](std::byte b) { return b != std::byte{}; });
    if (size < first || size >= sizeof(T) + 4096 || is_set)
        return name + ".struct_size: " + std::to_string(size) + (is_set ? ", with members that this library does not know" : "") +
               "; start from " + start + " of this library's " + header;
    std::memcpy(&to, from, known);
    to.struct_size = sizeof(T);
    return {};
}

/// Takes an image of the caller's; a sentence where it can't be.
/// @param components that it must have at least
/// @param width of the image in pixels
inline std::string take(Image& image, quell_image const& given, std::string const& what, int components, int width) {
    if (given.data == nullptr) return what + ": no memory (null); point it at its pixels";
    if (given.format != QUELL_FLOAT32 && given.format != QUELL_FLOAT16)
        return what + ": format " + std::to_string(given.format) + "; give QUELL_FLOAT32 or QUELL_FLOAT16";
    if (given.components < components)
        return what + ": " + std::to_string(given.components) + " components; it has " + std::to_string(components);
    image.is_half = given.format == QUELL_FLOAT16;
    std::ptrdiff_t const element = image.is_half ? 2 : 4;
    image.data = static_cast<std::byte*>(given.data);
    image.component_stride = given.component_stride != 0 ? given.component_stride : element;
    image.pixel_stride = given.pixel_stride != 0 ? given.pixel_stride : element * given.components;
    image.row_stride = given.row_stride != 0 ? given.row_stride : image.pixel_stride * width;
    for (auto const stride : {image.component_stride, image.pixel_stride, image.row_stride})
        if (stride % element != 0)
            return what + ": a stride of " + std::to_string(stride) + " bytes; give a multiple of " + std::to_string(element) +
                   ", the size of a component";
    if (reinterpret_cast<std::uintptr_t>(image.data) % static_cast<std::uintptr_t>(element) != 0)
        return what + ": its memory is not aligned to " + std::to_string(element) + " bytes, the size of a component; align it";
    return {};
}

} // namespace quell_library

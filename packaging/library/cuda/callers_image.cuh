#pragma once

#include "../preset_code.hpp"

#include <quell/execute/device.cuh>
#include <quell/image/sample_pattern.hpp>
#include <quell/image/subsampled.hpp>

namespace quell_library::inline QUELL_INSTRUCTION_SET {

/// An image of the caller's, of any layout, for a kernel or for the host: wherever its memory lies.
struct CallersImage {
    Image image;
    quell::Extent size; ///< of the frame

    /// A component, converted to what the preset wants.
    __host__ __device__ float get(int c, int x, int y) const {
        auto const value = image.samples.columns > 0 ? sample(c, x, y) : at(c, x, y);
        return c < 2 ? value * image.scale[c] + image.offset[c] : value; // of vectors
    }
    __host__ __device__ void set(int c, int x, int y, float value) const {
        auto* const to = address(c, x, y);
        if (image.is_half)
            quell::Float16::set(reinterpret_cast<std::uint16_t*>(to), value);
        else
            *reinterpret_cast<float*>(to) = value;
    }
    /// Whether kernels can read it as it is, by strides in floats.
    [[nodiscard]] bool is_floats() const {
        bool is_scaled = false;
        for (int c = 0; c < 2; ++c) is_scaled = is_scaled || image.scale[c] != 1.f || image.offset[c] != 0.f;
        return !image.is_half && !is_scaled && image.samples.columns == 0;
    }

private:
    __host__ __device__ std::byte* address(int c, int x, int y) const {
        return image.data + (c * image.component_stride + x * image.pixel_stride + y * image.row_stride);
    }
    __host__ __device__ float at(int c, int x, int y) const {
        auto const* const from = address(c, x, y);
        return image.is_half ? quell::Float16::get(reinterpret_cast<std::uint16_t const*>(from)) : *reinterpret_cast<float const*>(from);
    }
    /// Of an image of fewer samples than pixels.
    __host__ __device__ float sample(int c, int x, int y) const {
        auto const& samples = image.samples;
        quell::SamplePattern const pattern{samples.columns, samples.rows, samples.staggered != 0};
        int const column = x / pattern.columns, row = y / pattern.rows;
        auto const pixel = pattern.pixel(column, row, {samples.phase_x, samples.phase_y});
        int const from_x = samples.side_by_side ? column : pixel.x, from_y = samples.side_by_side ? row : pixel.y;
        bool const has = pixel.x == x && pixel.y == y && from_x < samples.width && from_y < samples.height;
        if (!has && !samples.repeats) return quell::detail::no_sample;
        return at(c, from_x < samples.width ? from_x : samples.width - 1, from_y < samples.height ? from_y : samples.height - 1);
    }
};

/// Makes planes of floats of an image of the caller's in the device's memory.
template <class View> struct TakeImage {
    static constexpr auto name = "take";
    CallersImage from;
    View to;

    QUELL_KERNEL void operator()(quell::AtOnce<float>, int x, int y, int) const {
        for (int c = 0; c < View::components; ++c) to.set(c, x, y, from.get(c, x, y));
    }
};
/// Writes what was denoised to an image of the caller's in the device's memory.
template <class View> struct GiveImage {
    static constexpr auto name = "give";
    View from;
    CallersImage to;

    QUELL_KERNEL void operator()(quell::AtOnce<float>, int x, int y, int) const {
        for (int c = 0; c < View::components; ++c) to.set(c, x, y, from.get(c, x, y));
    }
};

} // namespace quell_library::inline QUELL_INSTRUCTION_SET

#pragma once

#include <math.h>

/// Marks what a CPU, WebAssembly and a GPU compile alike.
#if defined(__CUDACC__)
#define QUELL_LIVE __host__ __device__ inline
#else
#define QUELL_LIVE inline
#endif

// The core of the live page: a path tracer that needs nothing but <math.h>, so that any compiler for any device takes it. No containers, no
// exceptions, no memory from the heap.
namespace quell::live {

constexpr float pi = 3.14159265f;

/// Three numbers: a point, a direction, or a linear colour. Aligned for loads of four floats.
struct alignas(16) Vector {
    float x = 0, y = 0, z = 0; ///< or red, green, blue
};

QUELL_LIVE Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
QUELL_LIVE Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
QUELL_LIVE Vector operator*(Vector a, Vector b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
QUELL_LIVE Vector operator*(Vector a, float b) { return {a.x * b, a.y * b, a.z * b}; }
QUELL_LIVE Vector operator*(float a, Vector b) { return b * a; }
QUELL_LIVE Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
QUELL_LIVE Vector& operator+=(Vector& a, Vector b) { return a = a + b; }

QUELL_LIVE float smaller(float a, float b) { return a < b ? a : b; }
QUELL_LIVE float larger(float a, float b) { return a > b ? a : b; }
QUELL_LIVE float dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
QUELL_LIVE Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
QUELL_LIVE float length(Vector a) { return sqrtf(dot(a, a)); }
QUELL_LIVE Vector normalized(Vector a) { return a * (1 / length(a)); }
QUELL_LIVE Vector mix(Vector a, Vector b, float share_of_b) { return a + (b - a) * share_of_b; }
QUELL_LIVE Vector reflected(Vector direction, Vector normal) { return direction - normal * (2 * dot(direction, normal)); }
/// Of Rec. 709.
QUELL_LIVE float luminance(Vector a) { return 0.2126f * a.x + 0.7152f * a.y + 0.0722f * a.z; }

} // namespace quell::live

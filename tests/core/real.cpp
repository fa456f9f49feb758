#include <doctest/doctest.h>
#include <quell/core/half.hpp>
#include <quell/core/permute.hpp>
#include <quell/core/value.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#if defined(__SSE3__)
#include <pmmintrin.h>
#endif

using namespace quell;

namespace {
float const infinity = std::bit_cast<float>(0x7f800000u);
float const not_a_number = std::bit_cast<float>(0x7fc00000u);
constexpr float awkward[] = {0.f, -0.f, 1.f, -1.f, 0.5f, 3e38f, -3e38f, 1e-40f, 1e-38f, 123.456f, -7.25f, 65504.f};

/// Every lane of f(pack) equals f(float).
template <class F> void same_in_every_lane(F f) {
    for (float const a : awkward)
        for (float const b : awkward) {
            auto const packed = f(Pack(a), Pack(b));
            float const single = f(a, b);
            for (int i = 0; i < width_of<Pack>; ++i) CHECK(bits(lane(packed, i)) == bits(single));
        }
}
} // namespace

TEST_CASE("a pack computes what a float computes") {
    same_in_every_lane([](auto a, auto b) { return quell::min(a, b); });
    same_in_every_lane([](auto a, auto b) { return quell::max(a, b); });
    same_in_every_lane([](auto a, auto b) { return quell::abs(a) + b; });
    same_in_every_lane([](auto a, auto b) { return select(a < b, a, b); });
    same_in_every_lane([](auto a, auto b) { return masked(a < b, b); });
    same_in_every_lane([](auto a, auto b) { return masked(invert(a < b), a); });
    same_in_every_lane([](auto a, auto) { return quell::floor(quell::min(quell::max(a, 0.f), 1e6f)); });
    same_in_every_lane([](auto a, auto b) { return with_sign_bit(a) + without_sign_bit(b); });
    same_in_every_lane(
        [](auto a, auto b) { return quell::fma(quell::min(a, decltype(a)(1e9f)), decltype(a)(0.3f), quell::min(b, decltype(a)(1e9f))); });
}

#if defined(__AVX2__)
TEST_CASE("a permutation takes any lanes of two packs") {
    constexpr int width = width_of<Pack>;
    static_assert(detail::permutes<Pack>);
    auto const numbers = lanes<Pack>();
    for (int step = 0; step < 2 * width; ++step) {
        auto const at = truncate(numbers * static_cast<float>(step)) & (2 * width - 1);
        auto const chosen = detail::permuted(numbers, numbers + static_cast<float>(width), at);
        for (int i = 0; i < width; ++i) CHECK(lane(chosen, i) == static_cast<float>(i * step % (2 * width)));
    }
}
#endif

TEST_CASE("min and max give the second number where one is NaN, and clamp the lower bound") {
    constexpr float inf = std::numeric_limits<float>::infinity();
    float const signalling = std::bit_cast<float>(0x7f800001u);
    for (float const nan : {not_a_number, -not_a_number, signalling}) {
        for (float const a : {1.f, -0.f, inf}) {
            CHECK(bits(quell::min(nan, a)) == bits(a));
            CHECK(bits(quell::max(nan, a)) == bits(a));
            for (int i = 0; i < width_of<Pack>; ++i) {
                CHECK(bits(lane(quell::min(Pack(nan), Pack(a)), i)) == bits(a));
                CHECK(bits(lane(quell::max(Pack(nan), Pack(a)), i)) == bits(a));
                CHECK_FALSE(is_finite(lane(quell::min(Pack(a), Pack(nan)), i)));
                CHECK_FALSE(is_finite(lane(quell::max(Pack(a), Pack(nan)), i)));
            }
        }
        CHECK(quell::clamp(nan, -2.f, 3.f) == -2.f);
        CHECK(lane(quell::clamp(Pack(nan), Pack(-2.f), Pack(3.f)), 0) == -2.f);
    }
    CHECK(bits(lane(quell::min(Pack(0.f), Pack(-0.f)), 0)) == bits(quell::min(0.f, -0.f)));
    CHECK(bits(lane(quell::max(Pack(-0.f), Pack(0.f)), 0)) == bits(quell::max(-0.f, 0.f)));
}

TEST_CASE("square roots and quotients are rounded once and floors are exact, in packs too") {
    std::mt19937 random(7);
    for (float const a : {1.f, 3.f, 0x1p127f, 1e-30f})
        for (int i = 0; i < 500; ++i) {
            float const b = a * (1.f - static_cast<float>(random() % 1000u) / 1001.f);
            CHECK(bits(lane(Pack(a) / Pack(b), 1)) == bits(a / b));
            CHECK(bits(lane(b / Pack(a), 0)) == bits(b / a));
        }
    for (int i = 0; i < 2000; ++i) {
        float const a = std::bit_cast<float>(static_cast<std::uint32_t>(random() % 0x7f800000u));
        CHECK(bits(lane(quell::sqrt(Pack(a)), 1)) == bits(std::sqrt(a)));
        float const b = std::ldexp(1.f - 2.f * static_cast<float>(random() % 1000u) / 999.f, static_cast<int>(random() % 40u));
        CHECK(lane(quell::floor(Pack(b)), 1) == std::floor(b));
    }
    for (float const a : {0.f, infinity, 0x1p-149f, 3.4e38f}) CHECK(lane(quell::sqrt(Pack(a)), 0) == std::sqrt(a));
}

TEST_CASE("fma rounds once where the instruction set has it, for floats and packs alike") {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    constexpr bool fused = true;
#else
    constexpr bool fused = false;
#endif
    float const volatile a = 1.f + 0x1p-12f, one = 1.f;
    float const square = a * a; // rounded: 2^-24 is lost
    // Fused, 2^-24 remains of a * a - square.
    float const single = quell::fma(float(a), float(a), -square);
    CHECK((single == 0x1p-24f) == fused);
    CHECK((lane(quell::fma(Pack(a), Pack(a), Pack(-square)), 1) == 0x1p-24f) == fused);
    CHECK(quell::fma(float(a), float(one), 2.f) == 3.f + 0x1p-12f);
}

TEST_CASE("the inline namespace is named for the instruction set") {
#define text(name) text_of(name)
#define text_of(name) #name
    [[maybe_unused]] std::string_view const name = text(QUELL_INSTRUCTION_SET);
#if defined(__ARM_FEATURE_SVE)
    CHECK(name.starts_with("sve"));
#elif defined(__aarch64__)
    CHECK(name.starts_with("neon64"));
#elif defined(__AVX512F__)
    CHECK((name.starts_with("x86_64_v4") || name.starts_with("avx512")));
#elif defined(__AVX2__)
    CHECK((name.starts_with("x86_64_v3") || name.starts_with("avx2")));
#elif defined(__SSE2__) && !defined(__SSE3__)
    CHECK(name.starts_with("sse2"));
#endif
}

TEST_CASE("what no integer holds truncates to the least one") {
    // Constants, since there a compiler refuses what C++ leaves undefined.
    constexpr auto least = std::numeric_limits<std::int32_t>::min();
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    constexpr std::int32_t outside[] = {truncate(inf), truncate(-inf), truncate(nan), truncate(3e9f), truncate(-3e9f)};
    for (auto const each : outside) CHECK(each == least);
    constexpr std::int32_t inside[] = {truncate(2147483520.f), truncate(-2147483648.f), truncate(-1.75f), truncate(0.99f)};
    CHECK(inside[0] == 2147483520);
    CHECK(inside[1] == least);
    CHECK(inside[2] == -1);
    CHECK(inside[3] == 0);
    for (float const a : {2147483520.f, -2147483648.f, -1.75f, 0.99f}) CHECK(lane(truncate(Pack(a)), 1) == truncate(a));
}

TEST_CASE("finiteness is read from the bits") {
    for (float const a : awkward) {
        CHECK(is_finite(a));
        CHECK(all(is_finite(Pack(a))));
    }
    for (float const a : {infinity, -infinity, not_a_number}) {
        CHECK_FALSE(is_finite(a));
        CHECK_FALSE(any(is_finite(Pack(a))));
    }
    CHECK(sign_bit(-0.f));
    CHECK_FALSE(sign_bit(0.f));
    CHECK(all(sign_bit(Pack(-0.f))));
}

TEST_CASE("exp is right to 3e-7, for floats and packs alike") {
    for (float x = -86.f; x < 87.f; x += 0.0371f) {
        double const wanted = std::exp(static_cast<double>(x));
        CHECK(std::abs(quell::exp(x) / wanted - 1) < 3e-7);
        CHECK(std::abs(lane(quell::exp(Pack(x)), 1) / wanted - 1) < 3e-7);
    }
    CHECK(is_finite(quell::exp(1e30f)));
    CHECK(quell::exp(-1e30f) < 1e-37f);
}

TEST_CASE("the approximate reciprocal is within 0.2 %, the inverse root within 3.5 %") {
    for (float x = 1e-12f; x < 1e12f; x *= 1.0137f) CHECK(std::abs(approximate_reciprocal(x) * x - 1.f) < 2e-3f);
    for (float x = 1e-30f; x < 1e30f; x *= 1.0137f) CHECK(std::abs(approximate_inverse_sqrt(x) * std::sqrt(x) - 1.f) < 3.5e-2f);
    CHECK(is_finite(approximate_inverse_sqrt(0.f)));
}

TEST_CASE("half precision: every bit pattern survives the way to float and back") {
    for (unsigned i = 0; i < 0x10000u; ++i) {
        auto const half = static_cast<std::uint16_t>(i);
        bool const special = (half & 0x7c00) == 0x7c00;
        if (special) continue;
        CHECK(half_from_float(float_from_half(half)) == half);
    }
    CHECK(float_from_half(0x3c00) == 1.f);
    CHECK(float_from_half(0x0001) == 0x1p-24f);
    CHECK(float_from_half(0x7bff) == 65504.f);
}

#if defined(__SSE3__) || defined(__aarch64__)
namespace {
/// While it lives, its thread takes subnormal floats for zero.
class SubnormalsAreZero {
#if defined(__SSE3__)
    unsigned before = _mm_getcsr();

public:
    SubnormalsAreZero() {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~SubnormalsAreZero() { _mm_setcsr(before); }
#else
    std::uint64_t before = 0;

public:
    SubnormalsAreZero() {
        // FZ, and FZ16 for halves.
        asm volatile("mrs %0, fpcr" : "=r"(before));
        asm volatile("msr fpcr, %0" ::"r"(before | 1u << 24 | 1u << 19));
    }
    ~SubnormalsAreZero() { asm volatile("msr fpcr, %0" ::"r"(before)); }
#endif
};
} // namespace

TEST_CASE("halves keep their smallest values on threads that take subnormal floats for zero") {
    int wrong = 0;
    {
        SubnormalsAreZero const zero;
        for (std::uint16_t half = 0; half < 0x400; ++half) {
            auto const value = static_cast<float>(half) * 0x1p-24f;
            std::vector<std::uint16_t> const halves(width_of<Pack>, half);
            std::vector<std::uint16_t> stored(width_of<Pack>);
            store_half(stored.data(), Pack(value));
            wrong += (float_from_half(half) != value) + (half_from_float(value) != half);
            wrong += (lane(load_half<Pack>(halves.data()), 1) != value) + (stored != halves);
        }
    }
    CHECK(wrong == 0);
}
#endif

TEST_CASE("half precision rounds to nearest even and saturates") {
    CHECK(half_from_float(1.f + 0x1p-11f) == 0x3c00);            // tie goes to the even neighbour
    CHECK(half_from_float(1.f + 0x1p-11f + 0x1p-20f) == 0x3c01); // just above the tie
    CHECK(half_from_float(1.f + 3 * 0x1p-11f) == 0x3c02);        // tie, to the even one above
    CHECK(half_from_float(0x1p-25f) == 0);                       // tie with zero
    for (float const a : {1e6f, 65520.f, 3e38f, infinity}) CHECK(half_from_float(a) == 0x7bff);
    CHECK(half_from_float(-1e9f) == 0xfbff);
    CHECK((half_from_float(not_a_number) & 0x7fff) > 0x7c00);
}

TEST_CASE("halves stored in packs are those stored one by one") {
    for (float base = -70000.f; base < 70000.f; base += 977.77f) {
        float lanes_in[16];
        std::uint16_t packed[16], single[16];
        for (int i = 0; i < 16; ++i) lanes_in[i] = base * std::pow(0.37f, static_cast<float>(i));
        for (int i = 0; i + width_of<Pack> <= 16; i += width_of<Pack>) store_half(packed + i, Pack::load_unaligned(lanes_in + i));
        for (int i = 0; i < 16; ++i) store_half(single + i, lanes_in[i]);
        for (int i = 0; i < 16; ++i) CHECK(packed[i] == single[i]);
        auto const loaded = load_half<Pack>(single);
        for (int i = 0; i < width_of<Pack>; ++i) CHECK(lane(loaded, i) == float_from_half(single[i]));
    }
}

TEST_CASE("values of any number of components") {
    Components<24, float> cones{};
    cones.at[23] = 2.f;
    CHECK(scale(cones, 3.f).at[23] == 6.f);
    CHECK(luminance(cones) == doctest::Approx(2.0 / 24));
    CHECK(luminance(vec3<float>(1.f)) == doctest::Approx(1));
    vec3<float> const colour(0.3f, 0.7f, 0.2f);
    CHECK(luminance_plus(colour, -0.25f) == doctest::Approx(luminance(colour) - 0.25f));
    CHECK(luminance_plus(0.5f, 0.25f) == doctest::Approx(0.75));
    auto const half_way = mix(vec3<float>(0, 2, 4), vec3<float>(2, 4, 8), 0.5f);
    CHECK(half_way.x == 1.f);
    CHECK(half_way.z == 6.f);
    CHECK_FALSE(quell::all_finite(vec3<float>(1, infinity, 1)));
    CHECK_FALSE(quell::all_finite(vec3<float>(infinity, -infinity, 1)));
    CHECK(quell::all_finite(vec3<float>(3e38f, 3e38f, 3e38f)));
}

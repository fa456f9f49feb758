#include "../../bench/cuda/job_parts.hpp"
#include "../frames.hpp"

#include <map>

using namespace quell;

namespace {
/// Memory that knows its blocks, as memory of a device would be.
struct KnownMemory {
    static inline std::map<char const*, std::size_t> blocks;

    static void* allocate(std::size_t bytes) {
        auto* const block = static_cast<char*>(HostMemory::allocate(bytes));
        blocks[block] = bytes;
        return block;
    }
    static void release(void* block) {
        blocks.erase(static_cast<char*>(block));
        HostMemory::release(block);
    }
    static bool has(void const* p) {
        auto const* const place = static_cast<char const*>(p);
        auto const behind = blocks.upper_bound(place);
        return behind != blocks.begin() && place < std::prev(behind)->first + std::prev(behind)->second;
    }
};
using Known = Planar<Float32, KnownMemory>;

/// Looks whether all pointers in jobs lead there. Null ones are not followed.
struct PointersSeen {
    int *inside, *outside;

    template <class Job> void for_each_pixel(Region r, Job const& job) const {
        static_assert(std::is_trivially_copyable_v<Job>);
        bench::visit_parts(job, [&](auto const& part) {
            if constexpr (std::is_pointer_v<std::remove_cvref_t<decltype(part)>>)
                if (part) ++*(KnownMemory::has(part) ? inside : outside);
        });
        Serial{}.for_each_pixel(r, job);
    }
};
} // namespace

TEST_CASE("all that kernels reach through pointers lies in the memory of the storage, counts and sums included") {
    constexpr auto all = Composite{presets::surface(visibility), presets::none(glossy, SuppressFireflies{}), presets::surface(indirect)};
    {
        Extent const size{19, 7};
        Frame frame{size, all, Known{}};
        History history{size, all, Known{}};
        int inside = 0, outside = 0;
        for (unsigned i = 0; i < 3; ++i) {
            tests::fill_randomly(frame, i);
            frame[glossy].set(3, 3, glm::vec3(1e6f));
            run(all, frame, history, PointersSeen{&inside, &outside});
        }
        CHECK(inside > 100);
        CHECK(outside == 0);
        CHECK(history.statistics().suppressed > 0);
    }
    CHECK(KnownMemory::blocks.empty());
}

TEST_CASE("a class's members are found, arrays and base classes among them") {
    struct Part {
        float a;
        int b[3];
    };
    struct Whole {
        Part each[2];
        Extent size;
        bool yes;
        float* planes[2];
        Product<DepthEdge, NormalEdge> edges;
        Views<Planar<>, Channels<Depth, Normal>> views;
    };
    static_assert(bench::member_count<Whole> == 6);
    static_assert(bench::member_count<Part> == 2);
    int pointers = 0, floats = 0;
    Whole const whole{};
    bench::visit_parts(whole, [&](auto const& part) {
        using T = std::remove_cvref_t<decltype(part)>;
        pointers += std::is_pointer_v<T>, floats += std::is_same_v<T, float>;
    });
    CHECK(pointers == 2 + 1 + 3);
    CHECK(floats == 2 + 3);
}

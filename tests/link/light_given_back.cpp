#include "../threads.hpp"
#include "flat_surface.hpp"

#include <quell/pipeline/plan.hpp>

using namespace quell;
using namespace quell::tests;

namespace {
constexpr auto give_back = light_given_back(radiance, 4.f);
constexpr Extent size{61, 37};

/// Memory that counts how often it is asked for.
struct CountedMemory {
    inline static int count = 0;
    static void* allocate(std::size_t bytes) { return ++count, HostMemory::allocate(bytes); }
    static void release(void* memory) { HostMemory::release(memory); }
};

/// Three frames of stripes that stand still, in a unit of light.
template <class Storage = Planar<>> std::vector<Pixels> frames_of(float unit = 1.f, Storage const& storage = {}) {
    FlatSurface seen(give_back);
    History history{flat_size, give_back, storage};
    std::vector<Pixels> pictures;
    fill(seen.frame[denoised], [&](int, int) { return glm::vec3(unit); });
    for (unsigned i = 0; i < 3; ++i) {
        put(seen.frame[radiance], scaled(with_noise(stripes(), .3f, i), unit));
        pictures.push_back(copy_of(run(give_back, seen.frame, history)));
    }
    return pictures;
}
/// The last of three random frames whose images are of another storage: put_in(image, what it holds).
std::vector<float> last_of(auto const& storage, auto& history, auto const& executor, auto const& put_in) {
    Frame planar{size, give_back};
    Frame frame{size, give_back, storage};
    std::vector<float> last;
    for (unsigned i = 0; i < 3; ++i) {
        fill_randomly(planar, i);
        for_each_channel(typename decltype(frame)::channels{}, [&](auto c) { put_in(frame[c], planar[c]); });
        last = copy_of(run(give_back, frame, history, executor));
    }
    return last;
}
} // namespace

TEST_CASE("light given back: every executor makes the same picture, wherever a frame's images lie, and warm frames take no memory") {
    auto const wanted = sequence(give_back, size, Serial{}), in_packs = sequence(give_back, size, Simd{});
    CHECK(all_finite(wanted));
    CHECK(difference(wanted, in_packs) < 1e-4);
#ifdef QUELL_TEST_THREADS
    for (int const threads : {1, 2, 3}) {
        History history{size, give_back};
        auto const copy = [](auto& to, auto const& from) { fill(to, [&](int x, int y) { return from.get(x, y); }); };
        CHECK(last_of(Interleaved<>{}, history, Threads<>{.count = threads}, copy) == in_packs);
    }
#endif
    History history{size, give_back, Planar<Float32, CountedMemory>{}};
    auto const borrow = [](auto& to, auto const& from) {
        auto const view = from.view();
        auto const between = view.components > 1 ? view.planes[view.components - 1] - view.planes[0] : 0;
        to = {view.planes[0], view.size, 1, view.row_stride(), between / std::max(1, view.components - 1)};
    };
    CHECK(last_of(Borrowed<>{}, history, Simd{}, borrow) == in_packs);
    int const taken = CountedMemory::count;
    CHECK(taken > 0);
    history.forget();
    CHECK(last_of(Borrowed<>{}, history, Simd{}, borrow) == in_packs);
    CHECK(CountedMemory::count == taken);
}

TEST_CASE("light given back: stripes come back, with a frame before more of them; the unit of light changes no bit, and halves little") {
    auto const wanted = frames_of();
    CHECK(root_mean_square(wanted[0], stripes()) < .9 * root_mean_square(flat, stripes()));
    CHECK(root_mean_square(wanted[1], stripes()) < .8 * root_mean_square(wanted[0], stripes()));
    for (float const unit : {0x1p-12f, 0x1p12f}) {
        auto const made = frames_of(unit);
        for (std::size_t i = 0; i < made.size(); ++i) CHECK(scaled(made[i], 1.f / unit) == wanted[i]);
    }
    auto const in_halves = frames_of(1.f, Planar<Float16>{}); // what passes hand to each other stays in 32 bits
    for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(difference(in_halves[i], wanted[i]) < 2e-3);
}

TEST_CASE("light given back: it is what a residual gives back, and then what repeats itself of what is still lacking") {
    constexpr float samples = 4.f;
    FlatSurface both(light_given_back(radiance, samples, true));
    FlatSurface first(Pipeline{denoised, Spatial{ResidualFeedback<Radiance>{.samples = samples, .is_judged = true}}});
    FlatSurface second(Pipeline{denoised, Spatial{RepeatedResidual<Radiance>{.samples = samples}}});
    for (unsigned i = 0; i < 3; ++i) {
        auto const seen = with_noise(stripes(), .3f, i);
        put(second.frame[denoised], first.run(seen));
        CHECK(difference(second.run(seen), both.run(seen)) < 1e-5);
    }
}

TEST_CASE("light given back: the memory is that of the plan") {
    FlatSurface seen(give_back, {1024, 16});
    for (int i = 0; i < 2; ++i) run(give_back, seen.frame, seen.history);
    CHECK(seen.history.bytes_per_pixel() == doctest::Approx(plan_of(give_back).bytes_per_pixel));
}

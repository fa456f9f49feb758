#include "method.hpp"

#include <baselines/presets.hpp>
#include <quell/execute/threads.hpp>
#include <quell/quell.hpp>
#include <tracer/trace_frame.hpp>

#include <chrono>

namespace quell::examples {

namespace {

/// Frames of a pipeline's own, with the noisy image too, to be shown beside the clean one; their histories; and what comes out.
template <class P> class Denoised {
    using Rendered = Frame<decltype(typename P::reads{} | Channels<Radiance>{})>;
    P pipeline;
    Rendered rendered;
    History<P> history;
    Threads<> threads;

public:
    double milliseconds = 0;

    Denoised(P const& p, Extent size, int thread_count) : pipeline(p), rendered(size), history(size, p), threads{.count = thread_count} {}

    [[nodiscard]] metrics::Picture frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) {
        tracer::trace_frame(scene, settings, rendered);
        auto const begin = std::chrono::steady_clock::now();
        auto const clean = run(pipeline, rendered, history, threads);
        milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        return metrics::picture_of(clean);
    }
    [[nodiscard]] metrics::Picture noisy() const { return metrics::picture_of(rendered[radiance].view()); }
    [[nodiscard]] double bytes_per_pixel() const { return history.bytes_per_pixel(); }
};

class AllEffects final : public DemoMethod {
    Denoised<decltype(presets::trmv())> trmv;

public:
    AllEffects(Extent size, int threads) : trmv(presets::trmv(), size, threads) {}
    std::vector<Kind> kinds() const override { return {{"noisy", "one path per pixel"}, {"denoised", "preset trmv"}}; }
    std::vector<metrics::Picture> frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) override {
        auto clean = trmv.frame(scene, settings);
        return {trmv.noisy(), std::move(clean)};
    }
    double milliseconds() const override { return trmv.milliseconds; }
    double bytes_per_pixel() const override { return trmv.bytes_per_pixel(); }
};

class MotionBlur final : public DemoMethod {
    Denoised<decltype(presets::blur(radiance))> blur;
    Denoised<decltype(presets::gather_blur(radiance))> gather;
    Denoised<decltype(presets::tilemax_blur(radiance))> tile_max;

public:
    MotionBlur(Extent size, int threads)
        : blur(presets::blur(radiance), size, threads), gather(presets::gather_blur(radiance), size, threads),
          tile_max(presets::tilemax_blur(radiance), size, threads) {}
    std::vector<Kind> kinds() const override {
        return {{"noisy", "one sample per pixel, at a random time of the open shutter"},
                {"denoised", "preset blur"},
                {"gather-blur", "a sharp picture, blurred along each pixel's own motion (GPU Gems 3, ch. 27)"},
                {"tilemax-blur", "a sharp picture, blurred along the longest motion around (McGuire 2012)"}};
    }
    std::vector<metrics::Picture> frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) override {
        auto clean = blur.frame(scene, settings);
        auto frozen = settings;
        frozen.frozen_at = 0.5f;
        return {blur.noisy(), std::move(clean), gather.frame(scene, frozen), tile_max.frame(scene, frozen)};
    }
    double milliseconds() const override { return blur.milliseconds; }
    double bytes_per_pixel() const override { return blur.bytes_per_pixel(); }
};

} // namespace

std::unique_ptr<DemoMethod> all_effects(Extent size, int threads) { return std::make_unique<AllEffects>(size, threads); }
std::unique_ptr<DemoMethod> motion_blur(Extent size, int threads) { return std::make_unique<MotionBlur>(size, threads); }

} // namespace quell::examples

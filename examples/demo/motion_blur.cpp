#include "denoised.hpp"

#include <baselines/presets.hpp>

namespace quell::examples {

namespace {
class MotionBlur final : public DemoMethod {
    Denoised<decltype(presets::blur(radiance))> blur;
    Denoised<decltype(presets::gather_blur(radiance))> gather;
    Denoised<decltype(presets::tilemax_blur(radiance))> tile_max;

public:
    explicit MotionBlur(DemoOptions const& options)
        : blur(presets::blur(radiance), options), gather(presets::gather_blur(radiance), options),
          tile_max(presets::tilemax_blur(radiance), options) {}
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

std::unique_ptr<DemoMethod> motion_blur(DemoOptions const& options) { return std::make_unique<MotionBlur>(options); }

} // namespace quell::examples

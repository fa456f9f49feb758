#include "denoised.hpp"

namespace quell::examples {

namespace {
class AllEffects final : public DemoMethod {
    Denoised<decltype(presets::trmv())> trmv;

public:
    explicit AllEffects(DemoOptions const& options) : trmv(presets::trmv(), options) {}
    std::vector<Kind> kinds() const override { return {{"noisy", "one path per pixel"}, {"denoised", "preset trmv"}}; }
    std::vector<metrics::Picture> frame(tracer::PreparedScene& scene, tracer::RenderSettings const& settings) override {
        auto clean = trmv.frame(scene, settings);
        return {trmv.noisy(), std::move(clean)};
    }
    double milliseconds() const override { return trmv.milliseconds; }
    double bytes_per_pixel() const override { return trmv.bytes_per_pixel(); }
};
} // namespace

std::unique_ptr<DemoMethod> all_effects(DemoOptions const& options) { return std::make_unique<AllEffects>(options); }

} // namespace quell::examples

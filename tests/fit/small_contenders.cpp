#include "small_contenders.hpp"

#include <quell/presets/published.hpp>

namespace quell::bench {
namespace {

/// Takes the time that it is given, whatever the machine does.
class TimedMethod final : public Method<FitFrame> {
    std::unique_ptr<Method<FitFrame>> method;

public:
    TimedMethod(std::unique_ptr<Method<FitFrame>> timed, double ms) : method(std::move(timed)) { milliseconds = {ms}; }
    metrics::Picture run(FitFrame const& frame) override { return method->run(frame); }
    [[nodiscard]] double bytes_per_pixel() const override { return method->bytes_per_pixel(); }
};

template <int ms, class Make> Contender taking(std::string name, bool follows, char const* code, Make make) {
    auto one = contender(std::move(name), follows, code, make);
    one.start = [](ChartOptions const& options, Precision memory) -> std::unique_ptr<Method<FitFrame>> {
        return std::make_unique<TimedMethod>(contender("", false, "", Make{}).start(options, memory), ms);
    };
    return one;
}

} // namespace
} // namespace quell::bench

std::vector<quell::bench::Contender> quell::bench::small_contenders() {
    return {
        taking<1>("none", false, QUELL_FIT_CODE(presets::none(radiance))),
        taking<2>("surface", false, QUELL_FIT_CODE(presets::surface(radiance, Demodulate{}))),
        taking<8>("blurred", true, QUELL_FIT_CODE(presets::gather_blur(radiance))),
        taking<16>("none", false, QUELL_FIT_CODE(presets::none(visibility))),
        taking<32>("follower", true, QUELL_FIT_CODE(presets::surface(visibility))),
        taking<64>("short", false, QUELL_FIT_CODE([] {
                       auto pipeline = presets::surface(visibility);
                       std::get<0>(pipeline.stages).blending.alpha = 0.25f;
                       return pipeline;
                   }())),
    };
}

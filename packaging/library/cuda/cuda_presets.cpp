#include "cuda_presets.hpp"

#include "cuda_code.hpp"

#include <quell/core/error.hpp>

#include <algorithm>
#include <cstring>

namespace quell_library {

namespace {

/// Throws what a sentence of libquell's code says: "subject: found; remedy".
[[noreturn]] void raise(std::string const& sentence, Outcome outcome) {
    auto const colon = sentence.find(": "), semicolon = sentence.rfind("; ");
    bool const has_parts = colon != sentence.npos && semicolon != sentence.npos && colon < semicolon;
    auto const subject = has_parts ? sentence.substr(0, colon) : "the device",
               found = has_parts ? sentence.substr(colon + 2, semicolon - colon - 2) : sentence,
               remedy = has_parts ? sentence.substr(semicolon + 2) : "use the CPU";
    if (outcome == Outcome::failed) throw quell::Failure(subject, found, remedy);
    throw quell::Error(subject, found, remedy);
}

class CudaDenoiser final : public CompiledDenoiser {
    std::unique_ptr<Instance> instance;
    std::vector<Frame> frames{1};
    Camera camera{};

public:
    explicit CudaDenoiser(std::unique_ptr<Instance> made) : instance(std::move(made)) {}

    void run(std::span<FrameImages const> window, Image const& output) override {
        auto const& given = window.front();
        auto& frame = frames.front();
        frame.width = given.size.width, frame.height = given.size.height, frame.channels = given.channels;
        static_assert(sizeof(camera.view) == sizeof(given.camera.view) && sizeof(camera.projection) == sizeof(given.camera.projection));
        std::memcpy(camera.view, &given.camera.view, sizeof(camera.view));
        std::memcpy(camera.projection, &given.camera.projection, sizeof(camera.projection));
        camera.jitter[0] = given.camera.jitter.x, camera.jitter[1] = given.camera.jitter.y;
        frame.camera = &camera, frame.shutter = given.shutter;
        frame.has_number = given.number.has_value(), frame.number = given.number.value_or(0);
        std::string error;
        if (auto const outcome = instance->run(frames, output, error); outcome != Outcome::ok) raise(error, outcome);
    }
    void forget() override { instance->forget(); }
    void release_scratch() override {} // a history has it on the device
    [[nodiscard]] quell::Statistics statistics() const override {
        auto const counted = instance->statistics();
        quell::Statistics all;
        all.frames = counted.frames, all.resets = counted.resets;
        all.missing_samples = counted.missing_samples, all.repaired_guides.pixels = counted.repaired_guides;
        return all;
    }
    [[nodiscard]] std::size_t bytes() const override { return instance->statistics().bytes; }
    [[nodiscard]] quell::detail::Observation observe(FrameImages const&) override {
        throw quell::Error("diagnosis", "frames are denoised on a device", "denoise on the CPU");
    }
    [[nodiscard]] bool has_debug_view(std::string_view) const override { return false; }
    [[nodiscard]] std::vector<quell::DebugImage> debug_images(std::string_view) override { return {}; }
    [[nodiscard]] std::optional<quell::HistoryContents> remembered() const override { return std::nullopt; }
    void remember(quell::HistoryContents const&) override {}
    void tell(quell::detail::KnownPast& to) const override { to.drop(); }
    void learn(quell::detail::KnownPast const&) override {}
};

/// What is compiled for a CPU, but for what makes the denoiser.
CompiledPreset on_cuda(CompiledPreset preset, std::shared_ptr<PresetWay const> const& way) {
    preset.usual.make = [way](quell::Extent size, Parallel const& parallel, Memory const&) -> std::unique_ptr<CompiledDenoiser> {
        Outcome outcome = Outcome::ok;
        std::string error;
        auto made = way->make({size.width, size.height, size.width, size.height}, 1.f, {}, parallel, {.may_move = true}, outcome, error);
        if (outcome != Outcome::ok) raise(error, outcome);
        return std::make_unique<CudaDenoiser>(std::move(made));
    };
    preset.usual.signal = {}; // its history stays on the device, where nothing is chosen
    preset.two_sided = {}, preset.two_sided_alpha = {}, preset.watched = {}, preset.stages = {};
    return preset;
}

} // namespace

std::vector<CompiledPreset> const& cuda_presets() {
    auto const* const codes = cuda_codes();
    if (codes == nullptr) throw quell::Error("--device", "'cuda', and this program was built without CUDA", build_with_cuda);
    static auto const all = [&] {
        std::vector<CompiledPreset> made;
        for (auto const& preset : compiled_presets()) {
            auto const code = std::ranges::find(codes->presets, preset.name, &PresetCode::name);
            std::string refusal;
            if (code != codes->presets.end() && !preset.picture && preset.usual.guides.empty())
                made.push_back(on_cuda(preset, code->with({}, false, refusal)));
        }
        return made;
    }();
    return all;
}

} // namespace quell_library

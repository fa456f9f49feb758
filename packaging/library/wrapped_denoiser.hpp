#pragma once

#include "compiled_preset.hpp"

namespace quell_library {

/// A compiled denoiser with something before or behind it, which is asked for everything else.
class WrappedDenoiser : public CompiledDenoiser {
protected:
    std::unique_ptr<CompiledDenoiser> denoiser;

    explicit WrappedDenoiser(std::unique_ptr<CompiledDenoiser> wrapped) : denoiser(std::move(wrapped)) {}

public:
    [[nodiscard]] quell::Statistics statistics() const override { return denoiser->statistics(); }
    [[nodiscard]] quell::detail::Observation observe(FrameImages const& given) override { return denoiser->observe(given); }
    [[nodiscard]] bool has_debug_view(std::string_view view) const override { return denoiser->has_debug_view(view); }
    [[nodiscard]] std::vector<quell::DebugImage> debug_images(std::string_view view) override { return denoiser->debug_images(view); }
    bool copy_guide(std::string_view name, Image const& output) override { return denoiser->copy_guide(name, output); }
    [[nodiscard]] std::optional<quell::HistoryContents> remembered() const override { return denoiser->remembered(); }
    void remember(quell::HistoryContents const& contents) override { denoiser->remember(contents); }
    void tell(quell::detail::KnownPast& to) const override { denoiser->tell(to); }
    void learn(quell::detail::KnownPast const& past) override { denoiser->learn(past); }
};

} // namespace quell_library

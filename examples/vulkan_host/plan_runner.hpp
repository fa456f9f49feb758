#pragma once

#include "device.hpp"

#include <quell/shader/shader_plan.hpp>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace quell::vulkan {

/// Runs the shaders of a folder that `quell-shaders --language spirv` has written. It knows nothing of presets: plan.json says everything.
class PlanRunner {
public:
    /// @throws Error for a folder without plan.json, or with one that is another program's
    PlanRunner(Device const& device, std::filesystem::path const& folder);

    /// Makes buffers for frames of a size. There is no past then.
    void resize(Extent size);
    /// The next frame has no past: for cuts.
    void forget() { has_past = false; }
    /// Denoises what `input` was filled with. Waits until the device is done.
    /// @throws vk::DeviceLostError: make the device and this again then; there is no past
    void run(FrameBlock const& frame);

    /// A component of a channel, to fill; empty where the plan does not read it.
    [[nodiscard]] std::span<float> input(std::string_view channel, int component) const;
    /// A component of the picture of the last run().
    [[nodiscard]] std::span<float const> picture(int component) const;

private:
    static constexpr std::size_t buffer_count = shader_buffer_names.size();
    struct Pass {
        vk::raii::Pipeline later = nullptr, first = nullptr;
        int fraction = 1;
    };

    Device const& on;
    std::vector<HostPlane> inputs;
    std::array<vk::DeviceSize, buffer_count> slot_counts{};
    /// Of a buffer that shaders load from as one of texels.
    struct View {
        std::uint32_t binding = 0;
        vk::Format format = vk::Format::eUndefined;
        vk::raii::BufferView view = nullptr;

        [[nodiscard]] bool is_used() const { return format != vk::Format::eUndefined; }
    };
    std::array<View, buffer_count> views{};
    Extent workgroup;
    std::vector<Pass> passes;
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::DescriptorPool pool = nullptr;
    std::vector<vk::raii::DescriptorSet> sets; ///< two: the second has the two buffers of the history the other way round
    vk::raii::CommandBuffer commands = nullptr;
    Buffer uniforms;
    std::array<Buffer, buffer_count> buffers;
    Extent size;
    std::size_t turn = 0;
    bool has_past = false;

    void make_layouts();
    void bind_buffers();
    void make_view(View& view, std::size_t buffer) const;
    [[nodiscard]] vk::raii::Pipeline pipeline(std::filesystem::path const& shader) const;
    void record(FrameBlock const& frame);
    [[nodiscard]] std::span<float> slot(ShaderBuffer buffer, std::size_t number) const;
};

} // namespace quell::vulkan

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
    ~PlanRunner();
    PlanRunner(PlanRunner const&) = delete;
    PlanRunner& operator=(PlanRunner const&) = delete;

    /// Makes buffers for frames of a size. There is no past then.
    void resize(Extent size);
    /// The next frame has no past: for cuts.
    void forget() { has_past = false; }
    /// Denoises what `input` was filled with. Waits until the device is done.
    void run(FrameBlock const& frame);

    /// A component of a channel, to fill; empty where the plan does not read it.
    [[nodiscard]] std::span<float> input(std::string_view channel, int component) const;
    /// A component of the picture of the last run().
    [[nodiscard]] std::span<float const> picture(int component) const;

private:
    static constexpr std::size_t buffer_count = shader_buffer_names.size();
    struct Pass {
        VkPipeline later = VK_NULL_HANDLE, first = VK_NULL_HANDLE;
        int fraction = 1;
    };

    Device const& on;
    std::vector<HostPlane> inputs;
    std::array<VkDeviceSize, buffer_count> slot_counts{};
    /// Of a buffer that shaders load from as one of texels.
    struct View {
        std::uint32_t binding = 0;
        VkFormat format = VK_FORMAT_UNDEFINED; ///< undefined: there is none
        VkBufferView view = VK_NULL_HANDLE;
    };
    std::array<View, buffer_count> views{};
    Extent workgroup;
    std::vector<Pass> passes;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, 2> sets{}; ///< the second has the two buffers of the history the other way round
    VkCommandBuffer commands = VK_NULL_HANDLE;
    Buffer uniforms;
    std::array<Buffer, buffer_count> buffers;
    Extent size;
    std::size_t turn = 0;
    bool has_past = false;

    void make_layouts();
    void make_sets();
    void bind_buffers();
    void make_view(View& view, std::size_t buffer) const;
    void drop_buffers();
    [[nodiscard]] VkPipeline pipeline(std::filesystem::path const& shader) const;
    void record(FrameBlock const& frame);
    [[nodiscard]] std::span<float> slot(ShaderBuffer buffer, std::size_t number) const;
};

} // namespace quell::vulkan

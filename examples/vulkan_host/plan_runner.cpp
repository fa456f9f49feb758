#include "plan_runner.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <fstream>

namespace quell::vulkan {

namespace {
nlohmann::json read_plan(std::filesystem::path const& file) {
    std::ifstream stream(file);
    auto plan = nlohmann::json::parse(stream, nullptr, false);
    if (plan.is_discarded() || !plan.contains("passes"))
        raise_error(file.string(), "it is no plan of shaders", "write one by quell-shaders --language spirv --out FOLDER");
    if (auto const shader = plan["passes"][0]["shader"].get<std::string>(); !shader.ends_with(".spv"))
        raise_error(file.string(), "its shaders are not SPIR-V: " + shader, "write them by quell-shaders --language spirv");
    if (plan["buffers"].size() != shader_buffer_names.size())
        raise_error(file.string(), "its buffers are in parts", "write them without --buffer-slots: this host binds each as one");
    return plan;
}
/// Of the block and the buffers; those of views come behind them.
constexpr VkDescriptorType type_of(std::size_t binding) {
    if (binding > shader_buffer_names.size()) return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    return binding == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}
constexpr bool is_of_host(ShaderBuffer buffer) { return buffer == ShaderBuffer::inputs || buffer == ShaderBuffer::output; }
} // namespace

PlanRunner::PlanRunner(Device const& device, std::filesystem::path const& folder) : on(device) {
    auto const plan = read_plan(folder / "plan.json");
    for (auto const& each : plan["inputs"]) inputs.push_back({each["channel"], each["component"], each["fraction"]});
    workgroup = {plan["workgroup"][0], plan["workgroup"][1]};
    for (std::size_t i = 0; i < buffer_count; ++i) {
        auto const& buffer = plan["buffers"][i];
        slot_counts[i] = buffer["slots"];
        if (buffer.contains("view"))
            views[i] = {buffer["view"]["binding"], buffer["view"]["format"] == "R32_UINT" ? VK_FORMAT_R32_UINT : VK_FORMAT_R32_SFLOAT};
    }
    make_layouts();
    for (auto const& each : plan["passes"]) {
        auto& pass = passes.emplace_back();
        pass.fraction = each["fraction"];
        pass.later = pipeline(folder / each["shader"].get<std::string>());
        if (each.contains("first")) pass.first = pipeline(folder / each["first"].get<std::string>());
    }
    make_sets();
    uniforms = on.make_buffer(4 * FrameBlock::words, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true);
}
PlanRunner::~PlanRunner() {
    drop_buffers();
    on.destroy(uniforms);
    for (auto const& pass : passes)
        for (auto const each : {pass.later, pass.first}) vkDestroyPipeline(on.device, each, nullptr);
    vkDestroyDescriptorPool(on.device, pool, nullptr);
    vkDestroyPipelineLayout(on.device, layout, nullptr);
    vkDestroyDescriptorSetLayout(on.device, set_layout, nullptr);
}

void PlanRunner::make_layouts() {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    auto const add = [&](std::size_t i) {
        bindings.push_back({static_cast<std::uint32_t>(i), type_of(i), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    };
    for (std::size_t i = 0; i <= buffer_count; ++i) add(i);
    for (auto const& view : views)
        if (view.format != VK_FORMAT_UNDEFINED) add(view.binding);
    VkDescriptorSetLayoutCreateInfo of_set{};
    of_set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    of_set.bindingCount = static_cast<std::uint32_t>(bindings.size()), of_set.pBindings = bindings.data();
    check(vkCreateDescriptorSetLayout(on.device, &of_set, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1, info.pSetLayouts = &set_layout;
    check(vkCreatePipelineLayout(on.device, &info, nullptr, &layout), "vkCreatePipelineLayout");
}

VkPipeline PlanRunner::pipeline(std::filesystem::path const& shader) const {
    std::ifstream stream(shader, std::ios::binary);
    std::vector<char> const bytes(std::istreambuf_iterator<char>(stream), {});
    if (bytes.empty() || bytes.size() % 4 != 0) raise_error(shader.string(), "it is no SPIR-V", "write the folder again");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    VkShaderModuleCreateInfo of_module{};
    of_module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    of_module.codeSize = bytes.size(), of_module.pCode = words.data();
    VkShaderModule code = VK_NULL_HANDLE;
    check(vkCreateShaderModule(on.device, &of_module, nullptr, &code), "vkCreateShaderModule");
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT, info.stage.module = code, info.stage.pName = "main";
    info.layout = layout;
    VkPipeline made = VK_NULL_HANDLE;
    auto const result = vkCreateComputePipelines(on.device, VK_NULL_HANDLE, 1, &info, nullptr, &made);
    vkDestroyShaderModule(on.device, code, nullptr);
    check(result, "vkCreateComputePipelines");
    return made;
}

void PlanRunner::make_sets() {
    auto const count = static_cast<std::uint32_t>(sets.size()), of_buffers = count * static_cast<std::uint32_t>(buffer_count);
    std::array<VkDescriptorPoolSize, 3> const of_types{
        {{type_of(0), count}, {type_of(1), of_buffers}, {type_of(buffer_count + 1), of_buffers}}};
    VkDescriptorPoolCreateInfo of_pool{};
    of_pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    of_pool.maxSets = count, of_pool.poolSizeCount = static_cast<std::uint32_t>(of_types.size()), of_pool.pPoolSizes = of_types.data();
    check(vkCreateDescriptorPool(on.device, &of_pool, nullptr, &pool), "vkCreateDescriptorPool");
    std::array const layouts{set_layout, set_layout};
    VkDescriptorSetAllocateInfo of_sets{};
    of_sets.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    of_sets.descriptorPool = pool, of_sets.descriptorSetCount = static_cast<std::uint32_t>(sets.size()),
    of_sets.pSetLayouts = layouts.data();
    check(vkAllocateDescriptorSets(on.device, &of_sets, sets.data()), "vkAllocateDescriptorSets");
    VkCommandBufferAllocateInfo of_commands{};
    of_commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    of_commands.commandPool = on.commands, of_commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY, of_commands.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(on.device, &of_commands, &commands), "vkAllocateCommandBuffers");
}

void PlanRunner::resize(Extent to) {
    drop_buffers();
    size = to;
    auto const bytes_of_slot = static_cast<VkDeviceSize>(size.pixels()) * 4;
    for (std::size_t i = 0; i < buffer_count; ++i) {
        buffers[i] = on.make_buffer(std::max<VkDeviceSize>(slot_counts[i], 1) * bytes_of_slot,
                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
                                    is_of_host(static_cast<ShaderBuffer>(i)));
        if (views[i].format != VK_FORMAT_UNDEFINED) make_view(views[i], i);
    }
    bind_buffers();
    forget();
}
void PlanRunner::make_view(View& view, std::size_t buffer) const {
    auto const texels = slot_counts[buffer] * static_cast<VkDeviceSize>(size.pixels());
    if (texels > on.most_texels)
        raise_error<Failure>("a view of " + std::string(shader_buffer_names[buffer]),
                             std::to_string(texels) + " texels, and the device has " + std::to_string(on.most_texels) + " at most",
                             "write the shaders without --texel-loads");
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = buffers[buffer].buffer, info.format = view.format, info.range = VK_WHOLE_SIZE;
    check(vkCreateBufferView(on.device, &info, nullptr, &view.view), "vkCreateBufferView");
}
void PlanRunner::bind_buffers() {
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (std::size_t binding = 0; binding <= buffer_count; ++binding) {
            auto which = binding == 0 ? 0 : binding - 1;
            auto const is = [&](ShaderBuffer buffer) { return which == static_cast<std::size_t>(buffer); };
            if (s == 1 && binding > 0 && (is(ShaderBuffer::history_then) || is(ShaderBuffer::history_now)))
                which = static_cast<std::size_t>(is(ShaderBuffer::history_then) ? ShaderBuffer::history_now : ShaderBuffer::history_then);
            VkDescriptorBufferInfo const of_buffer{binding == 0 ? uniforms.buffer : buffers[which].buffer, 0, VK_WHOLE_SIZE};
            VkWriteDescriptorSet write{};
            write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            write.dstSet = sets[s], write.dstBinding = static_cast<std::uint32_t>(binding), write.descriptorCount = 1;
            write.descriptorType = type_of(binding), write.pBufferInfo = &of_buffer;
            vkUpdateDescriptorSets(on.device, 1, &write, 0, nullptr);
            if (binding == 0 || views[which].format == VK_FORMAT_UNDEFINED) continue;
            write.dstBinding = views[binding - 1].binding, write.descriptorType = type_of(write.dstBinding);
            write.pBufferInfo = nullptr, write.pTexelBufferView = &views[which].view;
            vkUpdateDescriptorSets(on.device, 1, &write, 0, nullptr);
        }
}
void PlanRunner::drop_buffers() {
    for (auto& each : views) {
        vkDestroyBufferView(on.device, each.view, nullptr);
        each.view = VK_NULL_HANDLE;
    }
    for (auto& each : buffers) on.destroy(each);
}

void PlanRunner::run(FrameBlock const& frame) {
    if (!(frame.size == size)) raise_error("frame size", to_string(frame.size) + " for buffers of " + to_string(size), "call resize()");
    auto const words = frame.as_words();
    std::memcpy(uniforms.mapped, words.data(), sizeof(words));
    record(frame);
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1, submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(on.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(on.queue), "vkQueueWaitIdle");
    has_past = true;
    turn = 1 - turn; // what this frame has left is the next one's past
}
void PlanRunner::record(FrameBlock const& frame) {
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &sets[turn], 0, nullptr);
    for (auto const& pass : passes) {
        auto const extent = divided(frame.size, pass.fraction);
        auto const groups = [](int pixels, int threads) { return static_cast<std::uint32_t>((pixels + threads - 1) / threads); };
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, !has_past && pass.first ? pass.first : pass.later);
        vkCmdDispatch(commands, groups(extent.width, workgroup.width), groups(extent.height, workgroup.height), 1);
        // The next pass, or the host, sees what this one has written.
        VkMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                             VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
    }
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

std::span<float> PlanRunner::slot(ShaderBuffer buffer, std::size_t number) const {
    auto const pixels = static_cast<std::size_t>(size.pixels());
    return {static_cast<float*>(buffers[static_cast<std::size_t>(buffer)].mapped) + number * pixels, pixels};
}
std::span<float> PlanRunner::input(std::string_view channel, int component) const {
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (inputs[i].channel == channel && inputs[i].component == component) return slot(ShaderBuffer::inputs, i);
    return {};
}
std::span<float const> PlanRunner::picture(int component) const { return slot(ShaderBuffer::output, static_cast<std::size_t>(component)); }

} // namespace quell::vulkan

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
constexpr vk::DescriptorType type_of(std::size_t binding) {
    if (binding > shader_buffer_names.size()) return vk::DescriptorType::eUniformTexelBuffer;
    return binding == 0 ? vk::DescriptorType::eUniformBuffer : vk::DescriptorType::eStorageBuffer;
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
        if (!buffer.contains("view")) continue;
        views[i].binding = buffer["view"]["binding"];
        views[i].format = buffer["view"]["format"] == "R32_UINT" ? vk::Format::eR32Uint : vk::Format::eR32Sfloat;
    }
    make_layouts();
    for (auto const& each : plan["passes"]) {
        auto& pass = passes.emplace_back();
        pass.fraction = each["fraction"];
        pass.later = pipeline(folder / each["shader"].get<std::string>());
        if (each.contains("first")) pass.first = pipeline(folder / each["first"].get<std::string>());
    }
    uniforms = on.make_buffer(4 * FrameBlock::words, vk::BufferUsageFlagBits::eUniformBuffer, true);
}

void PlanRunner::make_layouts() {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    auto const add = [&](std::size_t i) {
        bindings.emplace_back(static_cast<std::uint32_t>(i), type_of(i), 1, vk::ShaderStageFlagBits::eCompute);
    };
    for (std::size_t i = 0; i <= buffer_count; ++i) add(i);
    for (auto const& view : views)
        if (view.is_used()) add(view.binding);
    set_layout = on.device.createDescriptorSetLayout({{}, bindings});
    layout = on.device.createPipelineLayout({{}, *set_layout});

    std::array const layouts{*set_layout, *set_layout};
    auto const count = static_cast<std::uint32_t>(layouts.size()), of_buffers = count * static_cast<std::uint32_t>(buffer_count);
    std::array<vk::DescriptorPoolSize, 3> const of_types{
        {{type_of(0), count}, {type_of(1), of_buffers}, {type_of(buffer_count + 1), of_buffers}}};
    pool = on.device.createDescriptorPool({vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, count, of_types});
    sets = on.device.allocateDescriptorSets({*pool, layouts});
    commands = std::move(on.device.allocateCommandBuffers({*on.commands, vk::CommandBufferLevel::ePrimary, 1}).front());
}

vk::raii::Pipeline PlanRunner::pipeline(std::filesystem::path const& shader) const {
    std::ifstream stream(shader, std::ios::binary);
    std::vector<char> const bytes(std::istreambuf_iterator<char>(stream), {});
    if (bytes.empty() || bytes.size() % 4 != 0) raise_error(shader.string(), "it is no SPIR-V", "write the folder again");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    auto const code = on.device.createShaderModule({{}, words});
    vk::PipelineShaderStageCreateInfo const stage({}, vk::ShaderStageFlagBits::eCompute, *code, "main");
    return on.device.createComputePipeline(nullptr, {{}, stage, *layout});
}

void PlanRunner::resize(Extent to) {
    using enum vk::BufferUsageFlagBits;
    size = to;
    auto const bytes_of_slot = static_cast<vk::DeviceSize>(size.pixels()) * 4;
    for (std::size_t i = 0; i < buffer_count; ++i) {
        views[i].view = nullptr;
        buffers[i] = on.make_buffer(std::max<vk::DeviceSize>(slot_counts[i], 1) * bytes_of_slot, eStorageBuffer | eUniformTexelBuffer,
                                    is_of_host(static_cast<ShaderBuffer>(i)));
        if (views[i].is_used()) make_view(views[i], i);
    }
    bind_buffers();
    forget();
}
void PlanRunner::make_view(View& view, std::size_t buffer) const {
    auto const texels = slot_counts[buffer] * static_cast<vk::DeviceSize>(size.pixels());
    auto const most = on.properties().limits.maxTexelBufferElements;
    if (texels > most)
        raise_error<Failure>("a view of " + std::string(shader_buffer_names[buffer]),
                             std::to_string(texels) + " texels, and the device has " + std::to_string(most) + " at most",
                             "write the shaders without --texel-loads");
    view.view = on.device.createBufferView({{}, *buffers[buffer].buffer, view.format, 0, VK_WHOLE_SIZE});
}
void PlanRunner::bind_buffers() {
    constexpr auto then = static_cast<std::size_t>(ShaderBuffer::history_then), now = static_cast<std::size_t>(ShaderBuffer::history_now);
    auto const bind = [&](std::size_t set, std::size_t binding, vk::DescriptorBufferInfo const* buffer, vk::BufferView const* view) {
        vk::WriteDescriptorSet const write(*sets[set], static_cast<std::uint32_t>(binding), 0, 1, type_of(binding), nullptr, buffer, view);
        on.device.updateDescriptorSets(write, nullptr);
    };
    for (std::size_t set = 0; set < sets.size(); ++set) {
        vk::DescriptorBufferInfo const of_uniforms(*uniforms.buffer, 0, VK_WHOLE_SIZE);
        bind(set, 0, &of_uniforms, nullptr);
        for (std::size_t i = 0; i < buffer_count; ++i) {
            bool const is_turned = set == 1 && (i == then || i == now);
            auto const which = is_turned ? then + now - i : i;
            vk::DescriptorBufferInfo const of_buffer(*buffers[which].buffer, 0, VK_WHOLE_SIZE);
            bind(set, i + 1, &of_buffer, nullptr);
            if (views[which].is_used()) bind(set, views[i].binding, nullptr, &*views[which].view);
        }
    }
}

void PlanRunner::run(FrameBlock const& frame) {
    if (!(frame.size == size)) raise_error("frame size", to_string(frame.size) + " for buffers of " + to_string(size), "call resize()");
    auto const words = frame.as_words();
    std::memcpy(uniforms.mapped, words.data(), sizeof(words));
    record(frame);
    on.queue.submit(vk::SubmitInfo({}, {}, *commands));
    on.queue.waitIdle();
    has_past = true;
    turn = 1 - turn; // what this frame has left is the next one's past
}
void PlanRunner::record(FrameBlock const& frame) {
    using enum vk::AccessFlagBits;
    constexpr auto compute = vk::PipelineStageFlagBits::eComputeShader;
    commands.begin({});
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *sets[turn], nullptr);
    for (auto const& pass : passes) {
        auto const extent = divided(frame.size, pass.fraction);
        auto const groups = [](int pixels, int threads) { return static_cast<std::uint32_t>((pixels + threads - 1) / threads); };
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, !has_past && *pass.first ? *pass.first : *pass.later);
        commands.dispatch(groups(extent.width, workgroup.width), groups(extent.height, workgroup.height), 1);
        // The next pass, or the host, sees what this one has written.
        vk::MemoryBarrier const barrier(eShaderWrite, eShaderRead | eShaderWrite | eHostRead);
        commands.pipelineBarrier(compute, compute | vk::PipelineStageFlagBits::eHost, {}, barrier, nullptr, nullptr);
    }
    commands.end();
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

#pragma once

#include <quell/shader/pass_recorder.hpp>
#include <quell/shader/shader_plan.hpp>

/// @file
/// Finds out from a few recorded frames what each plane is, and gives it a place in the plan's buffers.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A recorded frame.
struct RecordedFrame {
    std::vector<RecordedPass> passes;
    std::vector<void const*> output; ///< memory of the picture's planes
};

/// What the memory of a plane holds while a pass runs.
struct PlaneUse {
    enum class Kind { input, made, past } kind = Kind::input;
    std::size_t number = 0; ///< of the input; or of what passes make, in order, in this frame or in the last one
    friend bool operator==(PlaneUse const&, PlaneUse const&) = default;
};

/// What the planes of each pass of a frame hold. A memory is taken for several images one after the other.
struct PlaneUses {
    std::vector<std::vector<PlaneUse>> of_pass;
    std::vector<std::size_t> writer;                   ///< the pass that makes an image, by its number
    std::unordered_map<void const*, std::size_t> left; ///< what each memory holds in the end
    std::vector<std::optional<std::size_t>> output;    ///< the picture

    /// @param inputs memory of the host's images @param then the last frame, if there is one
    PlaneUses(RecordedFrame const& frame, std::vector<void const*> const& inputs, PlaneUses const* then) {
        for (std::size_t p = 0; p < frame.passes.size(); ++p) {
            auto const& pass = frame.passes[p];
            auto& uses = of_pass.emplace_back(pass.memory.size());
            std::vector<char> read(uses.size()), written(uses.size());
            for (auto const& node : pass.graph.nodes) {
                if (node.operation == Operation::load) read[node.payload] = 1;
                if (node.operation == Operation::store) written[node.payload] = 1;
            }
            for (std::size_t i = 0; i < uses.size(); ++i) {
                if (read[i] && written[i])
                    raise_error<Failure>("pass " + pass.graph.name, "it reads and writes one image", "make another channel of it");
                if (read[i]) uses[i] = read_of(pass.memory[i], inputs, then);
            }
            for (std::size_t i = 0; i < uses.size(); ++i)
                if (written[i]) {
                    uses[i] = {PlaneUse::Kind::made, writer.size()};
                    left[pass.memory[i]] = writer.size();
                    writer.push_back(p);
                }
        }
        for (auto const* const memory : frame.output) output.push_back(left.at(memory));
    }

private:
    [[nodiscard]] PlaneUse read_of(void const* memory, std::vector<void const*> const& inputs, PlaneUses const* then) const {
        auto const input = std::find(inputs.begin(), inputs.end(), memory);
        if (input != inputs.end()) return {PlaneUse::Kind::input, static_cast<std::size_t>(input - inputs.begin())};
        if (auto const found = left.find(memory); found != left.end()) return {PlaneUse::Kind::made, found->second};
        if (then)
            if (auto const found = then->left.find(memory); found != then->left.end()) return {PlaneUse::Kind::past, found->second};
        raise_error<Failure>("recorded frame", "a pass reads an image that none has made", "keep what a policy reads in channels");
    }
};

/// Gives images of a frame slots: those that the next frame reads in the history, others in the scratch, where a slot is free for the next
/// image behind the last pass that reads it.
class SlotsOfFrame {
    struct Image {
        std::size_t first = 0, last = 0; ///< passes
        bool kept = false, is_output = false;
        int slot = -1;
    };
    std::vector<Image> images;

public:
    int history_slots = 0, scratch_slots = 0;

    /// @param first a frame without a past, which may read an image later than others do
    SlotsOfFrame(PlaneUses const& first, PlaneUses const& frame, PlaneUses const& next) : images(frame.writer.size()) {
        for (std::size_t i = 0; i < images.size(); ++i) images[i].first = images[i].last = frame.writer[i];
        for (auto const* const each : {&first, &frame})
            for (std::size_t p = 0; p < each->of_pass.size(); ++p)
                for (auto const& use : each->of_pass[p])
                    if (use.kind == PlaneUse::Kind::made) images[use.number].last = std::max(images[use.number].last, p);
        for (auto const& uses : next.of_pass)
            for (auto const& use : uses)
                if (use.kind == PlaneUse::Kind::past) images[use.number].kept = true;
        int number = 0;
        for (auto const& each : frame.output)
            if (auto& image = images[*each]; !image.kept)
                image.is_output = true, image.slot = number++;
            else
                ++number;
        for (auto& image : images)
            if (image.kept) image.slot = history_slots++;
        place_scratch();
    }
    [[nodiscard]] bool is_kept(std::size_t image) const { return images[image].kept; }
    void place(GraphPlane& plane, PlaneUse const& use) const {
        plane.slot = static_cast<int>(use.number);
        plane.buffer = ShaderBuffer::inputs;
        if (use.kind == PlaneUse::Kind::input) return;
        auto const& image = images[use.number];
        plane.slot = image.slot;
        plane.buffer = use.kind == PlaneUse::Kind::past ? ShaderBuffer::history_then
                       : image.kept                     ? ShaderBuffer::history_now
                       : image.is_output                ? ShaderBuffer::output
                                                        : ShaderBuffer::scratch;
    }

private:
    void place_scratch() {
        std::vector<std::size_t> busy_until;
        for (auto& image : images) {
            if (image.kept || image.is_output) continue;
            auto const free = std::find_if(busy_until.begin(), busy_until.end(), [&](std::size_t last) { return last < image.first; });
            image.slot = static_cast<int>(free - busy_until.begin());
            if (free == busy_until.end())
                busy_until.push_back(image.last);
            else
                *free = image.last;
        }
        scratch_slots = static_cast<int>(busy_until.size());
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

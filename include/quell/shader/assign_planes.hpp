#pragma once

#include <quell/shader/pack_halves.hpp>
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

/// How a pass stores an image.
struct ImageStore {
    bool is_half = false; ///< as 16-bit floats, once a pixel
    int fraction = 1;
    std::int32_t place = 0; ///< the node
    friend bool operator==(ImageStore const&, ImageStore const&) = default;
};

/// What the planes of each pass of a frame hold. A memory is taken for several images one after the other.
struct PlaneUses {
    std::vector<std::vector<PlaneUse>> of_pass;
    std::vector<std::size_t> writer;                   ///< the pass that makes an image, by its number
    std::vector<ImageStore> store;                     ///< and how
    std::unordered_map<void const*, std::size_t> left; ///< what each memory holds in the end
    std::vector<std::optional<std::size_t>> output;    ///< the picture

    /// @param inputs memory of the host's images @param then the last frame, if there is one
    PlaneUses(RecordedFrame const& frame, std::vector<void const*> const& inputs, PlaneUses const* then) {
        for (std::size_t p = 0; p < frame.passes.size(); ++p) {
            auto const& pass = frame.passes[p];
            auto& uses = of_pass.emplace_back(pass.memory.size());
            std::vector<char> read(uses.size());
            std::vector<int> written(uses.size());
            std::vector<std::int32_t> place(uses.size());
            for (auto const& node : pass.graph.nodes) {
                if (node.operation == Operation::load) read[node.payload] = 1;
                if (node.operation == Operation::store) ++written[node.payload], place[node.payload] = node.of[1];
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
                    auto const& plane = pass.graph.planes[i];
                    store.push_back({plane.is_half && written[i] == 1, plane.fraction, place[i]});
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
        WordPart part = WordPart::whole;
        std::size_t lower = 0; ///< of an upper part: the image with which it shares words
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
        share_words(first, frame);
        for (auto& image : images)
            if (image.kept && image.part != WordPart::upper) image.slot = history_slots++;
        place_scratch();
        for (auto& image : images)
            if (image.part == WordPart::upper) image.slot = images[image.lower].slot;
    }
    [[nodiscard]] bool is_kept(std::size_t image) const { return images[image].kept; }
    /// Places the planes of a pass. Returns what each has of the words of its slot.
    std::vector<WordPart> place(std::vector<GraphPlane>& planes, std::vector<PlaneUse> const& uses) const {
        std::vector<WordPart> parts;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            place(planes[i], uses[i]);
            parts.push_back(uses[i].kind == PlaneUse::Kind::input ? WordPart::whole : images[uses[i].number].part);
        }
        return parts;
    }

private:
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

    /// Pairs images of 16-bit floats that a pass stores at one place, and of which both are kept or none.
    void share_words(PlaneUses const& first, PlaneUses const& frame) {
        auto const may_share = [&](std::size_t i) {
            return frame.store[i].is_half && first.store[i].is_half && !images[i].is_output && images[i].part == WordPart::whole;
        };
        auto const are_alike = [&](std::size_t i, std::size_t k) {
            return frame.writer[i] == frame.writer[k] && frame.store[i] == frame.store[k] && first.store[i] == first.store[k] &&
                   images[i].kept == images[k].kept;
        };
        for (std::size_t i = 0; i < images.size(); ++i)
            for (std::size_t k = i + 1; k < images.size() && may_share(i); ++k)
                if (may_share(k) && are_alike(i, k)) {
                    images[i].part = WordPart::lower, images[k].part = WordPart::upper, images[k].lower = i;
                    images[i].last = std::max(images[i].last, images[k].last);
                }
    }
    void place_scratch() {
        std::vector<std::size_t> busy_until;
        for (auto& image : images) {
            if (image.kept || image.is_output || image.part == WordPart::upper) continue;
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

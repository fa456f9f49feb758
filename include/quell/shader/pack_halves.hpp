#pragma once

#include <quell/shader/pass_graph.hpp>

#include <map>
#include <utility>

/// @file
/// Puts two planes of 16-bit floats into the words of one slot.

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What a plane has of the words of its slot.
enum class WordPart : std::uint8_t { lower, upper, whole };

/// Writes a pass anew, so that planes of one slot are the halves of its words. No two pixels share a word: threads must not write parts of
/// one.
class HalfPacker {
    PassGraph const& graph;
    std::vector<WordPart> const& parts;
    PassGraph packed;
    std::vector<std::uint32_t> plane_of;                                  ///< of the packed pass, for each plane
    std::vector<std::array<std::int32_t, 2>> stored;                      ///< values of both parts of these, -1 for none so far
    std::vector<std::int32_t> number;                                     ///< of each node, in the packed pass
    std::map<std::pair<std::int32_t, std::uint32_t>, std::int32_t> words; ///< loads, by place and plane

public:
    /// @param parts of each plane; both parts are stored by one pass, at one place
    HalfPacker(PassGraph const& g, std::vector<WordPart> const& of_planes)
        : graph(g), parts(of_planes), packed{.name = g.name, .fraction = g.fraction} {
        for (std::size_t i = 0; i < graph.planes.size(); ++i) plane_of.push_back(plane(i));
        stored.resize(packed.planes.size(), {-1, -1});
    }
    [[nodiscard]] PassGraph take() {
        for (auto const& node : graph.nodes) number.push_back(rewritten(node));
        drop_dead(packed.nodes), measure_loops(packed.nodes);
        return std::move(packed);
    }

private:
    std::uint32_t plane(std::size_t i) {
        auto const& each = graph.planes[i];
        if (parts[i] != WordPart::whole)
            for (std::size_t k = 0; k < i; ++k)
                if (parts[k] != WordPart::whole && graph.planes[k].buffer == each.buffer && graph.planes[k].slot == each.slot) {
                    auto& shared = packed.planes[plane_of[k]];
                    shared.beside = each.label();
                    return plane_of[k];
                }
        packed.planes.push_back(each);
        return static_cast<std::uint32_t>(packed.planes.size() - 1);
    }
    std::int32_t push(Node const& node) {
        packed.nodes.push_back(node);
        return static_cast<std::int32_t>(packed.nodes.size() - 1);
    }
    std::int32_t rewritten(Node node) {
        for (int k = 0; k < node.operands(); ++k) {
            auto& operand = node.of[static_cast<std::size_t>(k)];
            operand = number[static_cast<std::size_t>(operand)];
        }
        bool const is_load = node.operation == Operation::load;
        if (!is_load && node.operation != Operation::store) return push(node);
        auto const part = parts[node.payload];
        node.payload = plane_of[node.payload];
        if (part == WordPart::whole) return push(node);
        if (!is_load) return store(node, part);
        auto const [word, is_new] = words.try_emplace({node.of[0], node.payload}, 0);
        if (is_new) word->second = push(node);
        return push({part == WordPart::lower ? Operation::lower_half : Operation::upper_half, {word->second}});
    }
    /// Stores a word when both parts of it are there.
    std::int32_t store(Node node, WordPart part) {
        auto& values = stored[node.payload];
        auto const& value = packed.nodes[static_cast<std::size_t>(node.of[0])];
        // Packing rounds.
        values[static_cast<std::size_t>(part)] = value.operation == Operation::round_to_half ? value.of[0] : node.of[0];
        if (values[0] < 0 || values[1] < 0) return -1;
        node.of[0] = push({Operation::from_bits, {push({Operation::pack_halves, {values[0], values[1]}})}});
        return push(node);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/core/error.hpp>
#include <quell/shader/node.hpp>

#include <bit>
#include <string>
#include <unordered_map>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// A buffer of a ShaderPlan.
enum class ShaderBuffer : std::uint8_t {
    inputs,       ///< the host's channels
    history_then, ///< what the last frame has left
    history_now,  ///< what this frame leaves for the next
    scratch,      ///< what only this frame needs
    output        ///< the picture
};

/// A component of an image, as a recorded pass reads or writes it.
struct GraphPlane {
    std::string channel;                         ///< whose; "signal" is what is denoised
    int component = 0;                           ///< of the channel, from 0
    int fraction = 1;                            ///< its size = frame size / fraction, rounded up
    ShaderBuffer buffer = ShaderBuffer::scratch; ///< where it lies
    int slot = 0; ///< and which of the buffer's slots, each of which has room for a plane of the frame's size

    /// Equal in every member.
    friend bool operator==(GraphPlane const&, GraphPlane const&) = default;
};

/// A pass as it was recorded: for one pixel, each step that its kernel takes. Equal steps are one, those with constants alone are computed,
/// and those that nothing needs are gone.
struct PassGraph {
    std::string name;                 ///< of the pass
    int fraction = 1;                 ///< the pass runs at 1/fraction of the frame's width and height
    std::vector<Node> nodes{};        ///< in an order in which they can be computed; node 0 is the constant 0
    std::vector<GraphPlane> planes{}; ///< those that it reads and writes

    /// Equal in every member.
    friend bool operator==(PassGraph const&, PassGraph const&) = default;
};

namespace detail {
struct HashOfNode {
    std::size_t operator()(Node const& node) const {
        auto sum = static_cast<std::uint64_t>(node.operation);
        auto const mix = [&](std::int32_t a) { sum = (sum ^ static_cast<std::uint32_t>(a)) * 0xff51afd7ed558ccdull, sum ^= sum >> 29; };
        for (auto const operand : node.of) mix(operand);
        mix(static_cast<std::int32_t>(node.payload));
        return static_cast<std::size_t>(sum);
    }
};

/// Whether a node is an effect, which stays although nothing takes its value.
inline bool is_effect(Node const& node) { return node.operation == Operation::store; }

/// Drops the nodes that no store needs, and renumbers the others.
inline void drop_dead(std::vector<Node>& nodes) {
    std::vector<char> live(nodes.size());
    live[0] = 1;
    auto const operands = [](Node const& node) { return static_cast<std::size_t>(node.operands()); };
    for (auto i = nodes.size(); i-- > 0;) {
        live[i] = live[i] || is_effect(nodes[i]);
        if (live[i])
            for (std::size_t k = 0; k < operands(nodes[i]); ++k) live[static_cast<std::size_t>(nodes[i].of[k])] = 1;
    }
    std::vector<std::int32_t> number(nodes.size());
    std::vector<Node> kept;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!live[i]) continue;
        auto node = nodes[i];
        for (std::size_t k = 0; k < operands(node); ++k) node.of[k] = number[static_cast<std::size_t>(node.of[k])];
        number[i] = static_cast<std::int32_t>(kept.size());
        kept.push_back(node);
    }
    nodes = std::move(kept);
}

/// Collects the nodes of a pass while its kernel runs over Recorded.
class GraphBuilder {
    std::vector<Node> nodes;
    std::unordered_map<Node, std::int32_t, HashOfNode> known;
    static constexpr std::size_t most_nodes = std::size_t{1} << 20;

public:
    GraphBuilder() { add({Operation::constant}); } // node 0: what a value-initialised number is

    /// The number of a node. Equal nodes are one.
    std::int32_t add(Node const& node) {
        auto const next = static_cast<std::int32_t>(nodes.size());
        if (!is_effect(node)) {
            auto const [found, is_new] = known.try_emplace(node, next);
            if (!is_new) return found->second;
        }
        if (nodes.size() == most_nodes)
            raise_error<Failure>("recorded pass", "more than a million steps",
                                 "a loop goes on while any(mask) is true, which a recording "
                                 "always answers: give the loop a fixed number of turns");
        nodes.push_back(node);
        return next;
    }
    [[nodiscard]] Node const& operator[](std::int32_t number) const { return nodes[static_cast<std::size_t>(number)]; }
    /// The nodes that stores need.
    [[nodiscard]] std::vector<Node> take() {
        drop_dead(nodes);
        return std::move(nodes);
    }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

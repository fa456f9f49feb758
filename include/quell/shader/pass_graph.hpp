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
    int slot = 0;         ///< and which of the buffer's slots, each of which has room for a plane of the frame's size
    bool is_half = false; ///< whether it is kept as 16-bit floats, so that two planes may share the words of a slot
    std::string beside{}; ///< the plane in the upper halves of its words, if there is one

    /// Its name for people, such as "signal[0]"; both where two share words.
    [[nodiscard]] std::string label() const {
        return channel + "[" + std::to_string(component) + "]" + (beside.empty() ? beside : ", " + beside);
    }

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

/// Whether a node does something, so that equal ones are not one.
inline bool is_effect(Node const& node) { return node.type() == NodeType::none; }

/// Orders nodes anew, without those that have no place in the order.
inline void reorder(std::vector<Node>& nodes, std::vector<std::int32_t> const& order) {
    std::vector<std::int32_t> number(nodes.size());
    std::vector<Node> kept;
    for (auto const i : order) {
        auto node = nodes[static_cast<std::size_t>(i)];
        for (int k = 0; k < node.operands(); ++k) {
            auto& operand = node.of[static_cast<std::size_t>(k)];
            operand = number[static_cast<std::size_t>(operand)];
        }
        number[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(kept.size());
        kept.push_back(node);
    }
    nodes = std::move(kept);
}
/// Drops the nodes that no store needs, and renumbers the others. A turn's `next` is needed where its variable is.
inline void drop_dead(std::vector<Node>& nodes) {
    std::vector<char> live(nodes.size());
    live[0] = 1;
    auto const is_live = [&](std::int32_t number) { return live[static_cast<std::size_t>(number)] != 0; };
    auto const is_needed = [&](Node const& node) { return node.operation == Operation::store || (is_effect(node) && is_live(node.of[0])); };
    for (bool found = true; found;) {
        found = false;
        for (auto i = nodes.size(); i-- > 0;) {
            if (!live[i] && is_needed(nodes[i])) live[i] = found = true;
            if (live[i])
                for (int k = 0; k < nodes[i].operands(); ++k) live[static_cast<std::size_t>(nodes[i].of[static_cast<std::size_t>(k)])] = 1;
        }
    }
    std::vector<std::int32_t> order;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (live[i]) order.push_back(static_cast<std::int32_t>(i));
    reorder(nodes, order);
}

/// Tells each loop how many nodes it has.
inline void measure_loops(std::vector<Node>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].operation == Operation::end_loop) {
            auto const begin = static_cast<std::size_t>(nodes[i].of[0]);
            nodes[begin].payload = static_cast<std::uint32_t>(i - begin);
        }
}

/// Collects the nodes of a pass while its kernel runs over Recorded. A node stands in the innermost loop of those that it takes: what is
/// the same in each turn stands before the loop.
class GraphBuilder {
    /// What lies within a loop, or in none.
    struct Block {
        std::int32_t loop = 0;
        std::vector<std::int32_t> order{};
    };
    std::vector<Node> nodes;
    std::vector<std::int32_t> loop_of; ///< of each node; 0 for none
    std::vector<Block> open{Block{}};  ///< the innermost one last
    std::unordered_map<Node, std::int32_t, HashOfNode> known;
    static constexpr std::size_t most_nodes = std::size_t{1} << 20;

public:
    GraphBuilder() { add({Operation::constant}); } // node 0: what a value-initialised number is

    /// The number of a node. Equal nodes are one.
    std::int32_t add(Node const& node) {
        if (!is_effect(node))
            if (auto const found = known.find(node); found != known.end()) return found->second;
        auto& block = block_of(node);
        auto const number = push(node, block.loop);
        block.order.push_back(number);
        if (!is_effect(node)) known.emplace(node, number);
        return number;
    }
    [[nodiscard]] Node const& operator[](std::int32_t number) const { return nodes[static_cast<std::size_t>(number)]; }

    /// A variable of the loop that comes next. @param initial its first value
    std::int32_t carry(std::int32_t initial) {
        auto const number = push({Operation::carried, {initial}}, open.back().loop);
        open.back().order.push_back(number);
        return number;
    }
    /// What is added from now on and depends on the loop stands in it. @param count of turns
    std::int32_t begin_loop(std::int32_t count) {
        auto const number = static_cast<std::int32_t>(nodes.size());
        push({Operation::loop, {count}}, number);
        open.push_back({number});
        return number;
    }
    void end_loop() {
        auto const inner = std::move(open.back());
        open.pop_back();
        auto& order = open.back().order;
        order.push_back(inner.loop);
        order.insert(order.end(), inner.order.begin(), inner.order.end());
        order.push_back(push({Operation::end_loop, {inner.loop}}, open.back().loop));
    }
    /// The nodes that stores need.
    [[nodiscard]] std::vector<Node> take() {
        reorder(nodes, open.front().order);
        drop_dead(nodes), measure_loops(nodes);
        return std::move(nodes);
    }

private:
    std::int32_t push(Node const& node, std::int32_t loop) {
        if (nodes.size() == most_nodes)
            raise_error<Failure>("recorded pass", "more than a million steps",
                                 "a loop goes on while any(mask) is true, which a recording "
                                 "always answers: give the loop a fixed number of turns, or use for_each_turn(count, body, state...)");
        nodes.push_back(node);
        loop_of.push_back(loop);
        return static_cast<std::int32_t>(nodes.size() - 1);
    }
    Block& block_of(Node const& node) {
        if (node.operation == Operation::current && node.payload != 0) return open.back();
        std::size_t innermost = 0;
        for (int k = 0; k < node.operands(); ++k) {
            auto const loop = loop_of[static_cast<std::size_t>(node.of[static_cast<std::size_t>(k)])];
            auto depth = open.size() - 1;
            while (depth > 0 && open[depth].loop != loop) --depth;
            if (loop != 0 && depth == 0)
                raise_error<Failure>("recorded pass", "what a loop computes is used behind it",
                                     "give what turns hand on to for_each_turn(count, body, state...) as its state");
            innermost = depth > innermost ? depth : innermost;
        }
        return open[innermost];
    }
};
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/core/error.hpp>

#include <cuda_runtime_api.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// CUDA graphs of frames, for the executor Cuda: a frame then costs the host less than its launches would. A graph is made for each row of
/// kernels that a frame turns out to be; later frames put their arguments into it, or make it anew where it does not take them. One object
/// serves one stream, and must live until no executor that points to it is used any more:
///
///     CudaGraphs graphs;
///     run(denoise, frame, history, Cuda{.stream = stream, .graphs = &graphs});
class CudaGraphs {
public:
    CudaGraphs() = default;
    CudaGraphs(CudaGraphs const&) = delete;
    CudaGraphs& operator=(CudaGraphs const&) = delete;
    ~CudaGraphs() { drop(); }

    /// Drops all graphs. The next frame makes them again.
    void drop() {
        for (auto& each : made) destroy(each);
        made.clear();
    }

    /// @cond
    struct Kernel {
        void const* function;
        char const* pass;
        dim3 grid, block;
        bool cooperative;
        bool operator==(Kernel const& other) const {
            auto const same = [](dim3 a, dim3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
            return function == other.function && same(grid, other.grid) && same(block, other.block);
        }
    };
    /// Adds a kernel of two arguments to the frame.
    template <class First, class Second> void add(Kernel const& kernel, First const& first, Second const& second) {
        auto const at = arguments.size();
        arguments.resize(at + places(sizeof(First)) + places(sizeof(Second)));
        std::memcpy(arguments.data() + at, &first, sizeof(First));
        std::memcpy(arguments.data() + at + places(sizeof(First)), &second, sizeof(Second));
        nodes.push_back({kernel, at, at + places(sizeof(First)), arguments.size()});
    }
    /// Adds to the frame that memory is set to zero.
    void add_clear(void* memory, std::size_t bytes) { clears.push_back({memory, bytes, nodes.size()}); }
    /// Drops what has been added and not submitted.
    void drop_frame() { nodes.clear(), clears.clear(), arguments.clear(); }

    /// Puts the frame into a stream. Returns the first error.
    cudaError_t submit(cudaStream_t stream, char const*& pass) {
        if (nodes.empty() && clears.empty()) return cudaSuccess;
        pass = "of a graph";
        auto same = std::find_if(made.begin(), made.end(), [&](Made const& each) { return is_like(each); });
        if (same != made.end() && update(*same, pass) != cudaSuccess) {
            cudaGetLastError(); // forgets it: the graph is made anew, in place of one that does not take the arguments
            destroy(*same);
            made.erase(same), same = made.end();
        }
        auto status = cudaSuccess;
        if (same == made.end()) {
            status = make();
            if (status == cudaSuccess) same = made.end() - 1;
        }
        if (status == cudaSuccess) status = cudaGraphLaunch(same->runnable, stream);
        drop_frame();
        return status;
    }
    /// @endcond

private:
    struct alignas(16) Place {
        std::byte bytes[16];
    };
    static std::size_t places(std::size_t bytes) { return (bytes + sizeof(Place) - 1) / sizeof(Place); }

    struct Node {
        Kernel kernel;
        std::size_t first, second, end; ///< of its arguments
    };
    struct Clear {
        void* memory;
        std::size_t bytes, before; ///< and the node behind it
        bool operator==(Clear const&) const = default;
    };
    struct Made {
        std::vector<Node> nodes;
        std::vector<Clear> clears;
        std::vector<Place> arguments;
        std::vector<cudaGraphNode_t> handles;
        cudaGraph_t graph;
        cudaGraphExec_t runnable;
    };
    static void destroy(Made& each) { cudaGraphExecDestroy(each.runnable), cudaGraphDestroy(each.graph); }

    std::vector<Node> nodes; ///< of the running frame
    std::vector<Clear> clears;
    std::vector<Place> arguments;
    std::vector<Made> made;

    bool is_like(Made const& other) const {
        return clears == other.clears && std::equal(nodes.begin(), nodes.end(), other.nodes.begin(), other.nodes.end(),
                                                    [](Node const& a, Node const& b) { return a.kernel == b.kernel && a.end == b.end; });
    }
    template <class Visit> static cudaError_t with_parameters(Node const& node, std::vector<Place>& from, Visit const& visit) {
        void* pointers[] = {from.data() + node.first, from.data() + node.second};
        cudaKernelNodeParams parameters{};
        parameters.func = const_cast<void*>(node.kernel.function);
        parameters.gridDim = node.kernel.grid, parameters.blockDim = node.kernel.block;
        parameters.kernelParams = pointers;
        return visit(parameters);
    }
    /// Hands over the arguments that differ from those of the graph's last frame.
    cudaError_t update(Made& graph, char const*& pass) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            auto const& node = nodes[i];
            auto const bytes = (node.end - node.first) * sizeof(Place);
            if (std::memcmp(arguments.data() + node.first, graph.arguments.data() + node.first, bytes) == 0) continue;
            auto const status = with_parameters(node, arguments, [&](cudaKernelNodeParams const& parameters) {
                return cudaGraphExecKernelNodeSetParams(graph.runnable, graph.handles[i], &parameters);
            });
            if (status != cudaSuccess) {
                pass = node.kernel.pass;
                return status;
            }
            std::memcpy(graph.arguments.data() + node.first, arguments.data() + node.first, bytes); // the graph has them
        }
        return cudaSuccess;
    }
    cudaError_t make() {
        constexpr std::size_t most = 64; // sizes come and go
        if (made.size() == most) drop();
        Made graph{nodes, clears, arguments, {}, nullptr, nullptr};
        auto status = cudaGraphCreate(&graph.graph, 0);
        cudaGraphNode_t last = nullptr;
        for (std::size_t i = 0; i <= nodes.size() && status == cudaSuccess; ++i) {
            for (auto const& clear : clears)
                if (clear.before == i && status == cudaSuccess) status = add_to(graph, clear, last);
            if (i < nodes.size() && status == cudaSuccess) status = add_to(graph, nodes[i], last);
        }
        if (status == cudaSuccess) status = cudaGraphInstantiate(&graph.runnable, graph.graph, 0);
        if (status == cudaSuccess)
            made.push_back(std::move(graph));
        else if (graph.graph)
            cudaGraphDestroy(graph.graph);
        return status;
    }
    static cudaError_t add_to(Made& graph, Clear const& clear, cudaGraphNode_t& last) {
        cudaMemsetParams parameters{};
        parameters.dst = clear.memory, parameters.elementSize = 1, parameters.width = clear.bytes, parameters.height = 1;
        cudaGraphNode_t node = nullptr;
        auto const status = cudaGraphAddMemsetNode(&node, graph.graph, &last, last ? 1 : 0, &parameters);
        last = node;
        return status;
    }
    static cudaError_t add_to(Made& graph, Node const& kernel, cudaGraphNode_t& last) {
        cudaGraphNode_t node = nullptr;
        auto status = with_parameters(kernel, graph.arguments, [&](cudaKernelNodeParams const& parameters) {
            return cudaGraphAddKernelNode(&node, graph.graph, &last, last ? 1 : 0, &parameters);
        });
        if (status == cudaSuccess && kernel.kernel.cooperative) {
            cudaKernelNodeAttrValue value{};
            value.cooperative = 1;
            status = cudaGraphKernelNodeSetAttribute(node, cudaKernelNodeAttributeCooperative, &value);
        }
        graph.handles.push_back(node);
        last = node;
        return status;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

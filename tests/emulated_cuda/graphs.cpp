#include "machine.hpp"

#include <algorithm>
#include <memory>

using emulated_cuda::Launch;
using emulated_cuda::machine;

struct CUgraphNode_st {
    std::optional<Launch> kernel;
    cudaMemsetParams clear{};
    std::vector<cudaGraphNode_t> before;
};
struct CUgraph_st {
    std::vector<std::unique_ptr<CUgraphNode_st>> nodes;
};
/// Copies of a graph's nodes, with where they came from.
struct CUgraphExec_st {
    std::vector<std::pair<cudaGraphNode_t, CUgraphNode_st>> nodes;
};

namespace {
cudaError_t begin(char const* call) { return machine().end(machine().begin(call)); }

cudaError_t add(cudaGraphNode_t* node, cudaGraph_t graph, cudaGraphNode_t const* before, std::size_t count, CUgraphNode_st made) {
    made.before.assign(before, before + count);
    *node = graph->nodes.emplace_back(std::make_unique<CUgraphNode_st>(std::move(made))).get();
    return cudaSuccess;
}
std::optional<Launch> launch_of(cudaKernelNodeParams const& p, bool cooperative) {
    return machine().launch_of(p.func, p.gridDim, p.blockDim, p.kernelParams, cooperative);
}
/// Runs nodes whose predecessors have run.
void run(CUgraphExec_st const& graph) {
    std::vector<cudaGraphNode_t> done;
    auto const is_done = [&](cudaGraphNode_t node) { return std::find(done.begin(), done.end(), node) != done.end(); };
    while (done.size() < graph.nodes.size())
        for (auto at = graph.nodes.rbegin(); at != graph.nodes.rend(); ++at) { // whichever order edges allow: the last first
            auto const& [from, node] = *at;
            if (is_done(from) || !std::all_of(node.before.begin(), node.before.end(), is_done)) continue;
            if (node.kernel)
                machine().run(*node.kernel);
            else
                std::memset(node.clear.dst, static_cast<int>(node.clear.value), node.clear.width * node.clear.elementSize);
            done.push_back(from);
        }
}
} // namespace

cudaError_t cudaGraphCreate(cudaGraph_t* graph, unsigned) {
    if (auto const status = begin("cudaGraphCreate"); status != cudaSuccess) return status;
    *graph = new CUgraph_st;
    return cudaSuccess;
}
cudaError_t cudaGraphDestroy(cudaGraph_t graph) { return delete graph, cudaSuccess; }
cudaError_t cudaGraphAddKernelNode(cudaGraphNode_t* node, cudaGraph_t graph, cudaGraphNode_t const* before, std::size_t count,
                                   cudaKernelNodeParams const* parameters) {
    if (auto const status = begin("cudaGraphAddKernelNode"); status != cudaSuccess) return status;
    auto made = launch_of(*parameters, false);
    return made ? add(node, graph, before, count, {std::move(made), {}, {}}) : machine().end(cudaErrorInvalidDeviceFunction);
}
cudaError_t cudaGraphAddMemsetNode(cudaGraphNode_t* node, cudaGraph_t graph, cudaGraphNode_t const* before, std::size_t count,
                                   cudaMemsetParams const* parameters) {
    if (auto const status = begin("cudaGraphAddMemsetNode"); status != cudaSuccess) return status;
    return add(node, graph, before, count, {{}, *parameters, {}});
}
cudaError_t cudaGraphKernelNodeSetAttribute(cudaGraphNode_t node, cudaKernelNodeAttrID, cudaKernelNodeAttrValue const* value) {
    node->kernel->cooperative = value->cooperative != 0;
    return begin("cudaGraphKernelNodeSetAttribute");
}
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* runnable, cudaGraph_t graph, unsigned long long) {
    if (auto const status = begin("cudaGraphInstantiate"); status != cudaSuccess) return status;
    ++machine().counts.graphs;
    *runnable = new CUgraphExec_st;
    for (auto const& node : graph->nodes) (*runnable)->nodes.emplace_back(node.get(), *node);
    return cudaSuccess;
}
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t runnable) { return delete runnable, cudaSuccess; }
cudaError_t cudaGraphExecKernelNodeSetParams(cudaGraphExec_t runnable, cudaGraphNode_t node, cudaKernelNodeParams const* parameters) {
    if (auto const status = begin("cudaGraphExecKernelNodeSetParams"); status != cudaSuccess) return status;
    for (auto& [from, copy] : runnable->nodes) {
        if (from != node) continue;
        auto made = launch_of(*parameters, copy.kernel->cooperative);
        if (!made) return machine().end(cudaErrorInvalidDeviceFunction);
        ++machine().counts.changed_arguments;
        copy.kernel = std::move(made);
        return cudaSuccess;
    }
    return machine().end(cudaErrorInvalidValue);
}
cudaError_t cudaGraphLaunch(cudaGraphExec_t runnable, cudaStream_t stream) {
    if (auto const status = begin("cudaGraphLaunch"); status != cudaSuccess) return status;
    ++machine().counts.graph_launches;
    machine().enqueue(stream, [copy = *runnable] { run(copy); });
    return cudaSuccess;
}

// Shortest ways over graphs, by Dijkstra's algorithm; the form without a compiler is SciPy's, in
// `geodesic.numerics.shortest_ways`.

#include "kernels.h"

// In each of (count) graphs of (nodes) nodes, edges (degrees[k] from node k, in the order of nodes)
// lead to `heads` and have `weights`, both (count, edges). Ways begin at the last node. `distance`
// and `before`, the node before on the way, are (count, nodes); where no way leads, these are
// infinity and -1.
EXPORTED int64_t bodymeasure_shortest_trees(int64_t count, int64_t nodes, int64_t edges,
                                            const int64_t *degrees, const int64_t *heads,
                                            const double *weights, double *distance,
                                            int64_t *before) {
    std::vector<int64_t> from(nodes + 1, 0), edge(nodes);
    for (int64_t k = 0; k < nodes; ++k) from[k + 1] = from[k] + degrees[k];
    const auto all = [](int64_t, double) { return true; };
    for (int64_t graph = 0; graph < count; ++graph) {
        bodymeasure::shortest_ways(nodes, from.data(), heads, weights, {{0.0, nodes - 1}}, all, distance,
                                   before, edge.data());
        heads += edges, weights += edges, distance += nodes, before += nodes;
    }
    return count;
}

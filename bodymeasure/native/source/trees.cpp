// Shortest ways from many points at once, each over a graph of its own of the same shape, by
// Dijkstra's algorithm; the form without a compiler is SciPy's, in `geodesic.shortest.grid_graph`.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernels.h"

// In each of (count) graphs of (nodes) nodes, edges (degrees[k] from node k, in the order of nodes)
// lead to `heads` and have `weights`, both (count, edges). Ways begin at the last node. `distance`
// and `before`, the node before on the way, are (count, nodes); where no way leads, these are
// infinity and -1.
EXPORTED int64_t bodymeasure_shortest_trees(int64_t count, int64_t nodes, int64_t edges,
                                            const int64_t *degrees, const int64_t *heads,
                                            const double *weights, double *distance,
                                            int64_t *before) {
    using Reached = std::pair<double, int64_t>;
    std::vector<int64_t> first(nodes + 1, 0);
    for (int64_t k = 0; k < nodes; ++k) first[k + 1] = first[k] + degrees[k];
    std::vector<Reached> heap;
    const auto later = [](const Reached &a, const Reached &b) { return a > b; };
    for (int64_t graph = 0; graph < count; ++graph) {
        std::fill(distance, distance + nodes, INFINITY);
        std::fill(before, before + nodes, -1);
        distance[nodes - 1] = 0.0;
        heap.assign(1, {0.0, nodes - 1});
        while (!heap.empty()) {
            std::pop_heap(heap.begin(), heap.end(), later);
            const auto [way, node] = heap.back();
            heap.pop_back();
            if (way > distance[node]) continue;  // A shorter way came later.
            for (int64_t edge = first[node]; edge < first[node + 1]; ++edge) {
                const double longer = way + weights[edge];
                if (!(longer < distance[heads[edge]])) continue;
                distance[heads[edge]] = longer;
                before[heads[edge]] = node;
                heap.emplace_back(longer, heads[edge]);
                std::push_heap(heap.begin(), heap.end(), later);
            }
        }
        heads += edges, weights += edges, distance += nodes, before += nodes;
    }
    return count;
}

// Shortest ways over graphs, by Dijkstra's algorithm; the form without a compiler is SciPy's, in
// `geodesic.numerics.shortest_ways`.

#include <algorithm>
#include <cmath>

#include "kernels.h"

namespace bodymeasure {

void shortest_ways(int64_t nodes, const int64_t *from, const int64_t *heads, const double *weights,
                   std::vector<Reached> reached, double *distance, int64_t *before, int64_t *edge) {
    const auto later = [](const Reached &a, const Reached &b) { return a > b; };
    std::fill(distance, distance + nodes, INFINITY);
    std::fill(before, before + nodes, -1);
    for (const auto &[way, node] : reached) distance[node] = way;
    std::make_heap(reached.begin(), reached.end(), later);
    while (!reached.empty()) {
        std::pop_heap(reached.begin(), reached.end(), later);
        const auto [way, node] = reached.back();
        reached.pop_back();
        if (way > distance[node]) continue;  // A shorter way came later.
        for (int64_t number = from[node]; number < from[node + 1]; ++number) {
            const int64_t there = heads[number];
            const double longer = way + weights[number];
            if (!(longer < distance[there])) continue;
            distance[there] = longer;
            before[there] = node;
            edge[there] = number;
            reached.emplace_back(longer, there);
            std::push_heap(reached.begin(), reached.end(), later);
        }
    }
}

}  // namespace bodymeasure

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
    for (int64_t graph = 0; graph < count; ++graph) {
        bodymeasure::shortest_ways(nodes, from.data(), heads, weights, {{0.0, nodes - 1}}, distance,
                                   before, edge.data());
        heads += edges, weights += edges, distance += nodes, before += nodes;
    }
    return count;
}

// Rough ways between two points, pulled straight; the NumPy form is `routes.ways._straight_ways`, with
// `routes.strips.straight_way`.
//
// A way leads along the shortest ways of a graph from both ends, and one step between them: one over
// which it passes a part of its length. Of the steps from a vertex the one of the shortest way is
// taken, and of these, the shortest first, all that begin apart from those before.

#include <set>
#include <tuple>

#include "kernels.h"

namespace bodymeasure {

using Numbers = std::vector<int64_t>;

struct Graph {
    int64_t vertices, longest;
    const int64_t *from;  // (vertices + 1,), the first step from each
    const int64_t *heads;
    const double *lengths;
    const int64_t *along;  // (steps, longest), the vertices along edges of the mesh, or -1
};

// The vertices to which an end is joined, and how edges of the mesh lead there.
struct Joined {
    int64_t count, longest;
    const int64_t *vertices;
    const double *distances;
    const int64_t *along;  // (count, longest), from a corner of the face that holds the end, or -1
};

struct Scope {
    double longer, apart;  // as parts of the length of the shortest way
    int64_t parts, most;
    const double *part;
};

// The different ways that are found, with room for `longest` faces each, as in `Way`.
struct Ways {
    int64_t faces[2];
    double ends[2][3];
    int64_t longest;
    int64_t *counts, *strips, *sides;
    double *along, *lengths, *weights;
};

namespace {

// The part by which sums of lengths in another order may differ.
constexpr double ROUNDING = 1e-9;

// The step over which a way passes a part of its length; none in the shortest way.
struct Over {
    double whole;
    int64_t first, last, step;
    bool operator<(const Over &other) const {
        return std::tie(whole, first, last, step) <
               std::tie(other.whole, other.first, other.last, other.step);
    }
};

struct Reach {
    std::vector<double> distance;
    Numbers before, step;

    template <typename Wanted>
    Reach(const Graph &graph, const Joined &end, const Wanted &wanted)
        : distance(graph.vertices), before(graph.vertices), step(graph.vertices) {
        std::vector<Reached> reached;
        for (int64_t k = 0; k < end.count; ++k) reached.emplace_back(end.distances[k], end.vertices[k]);
        shortest_ways(graph.vertices, graph.from, graph.heads, graph.lengths, reached, wanted,
                      distance.data(), before.data(), step.data());
    }
};

void append(const int64_t *vertices, int64_t most, Numbers &way) {
    for (int64_t k = 0; k < most; ++k)
        if (vertices[k] >= 0) way.push_back(vertices[k]);
}

// The vertices on the way from an end to a vertex.
Numbers way_to(const Graph &graph, const Joined &end, const Reach &reach, int64_t vertex) {
    Numbers steps, way;
    for (; reach.before[vertex] >= 0; vertex = reach.before[vertex]) steps.push_back(reach.step[vertex]);
    const int64_t number = std::find(end.vertices, end.vertices + end.count, vertex) - end.vertices;
    append(end.along + number * end.longest, end.longest, way);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        append(graph.along + *step * graph.longest, graph.longest, way);
    return way;
}

// The steps over which ways that are no longer than `most` pass a part of their length.
std::vector<Over> over_level(const Graph &graph, const Reach &ahead, const Reach &back, double part,
                             double most) {
    const auto beyond = [&](int64_t vertex) {
        const double here = ahead.distance[vertex], there = back.distance[vertex];
        return here + there <= most ? (1.0 - part) * here - part * there : -INFINITY;
    };
    std::vector<Over> result;
    for (int64_t first = 0; first < graph.vertices; ++first) {
        if (!(ahead.distance[first] + back.distance[first] <= most) || beyond(first) > 0.0) continue;
        Over least{INFINITY, first, -1, -1};
        for (int64_t step = graph.from[first]; step < graph.from[first + 1]; ++step) {
            const int64_t last = graph.heads[step];
            if (!(beyond(last) > 0.0)) continue;
            const double whole = ahead.distance[first] + graph.lengths[step] + back.distance[last];
            if (whole < least.whole) least = {whole, first, last, step};
        }
        if (least.whole <= most) result.push_back(least);
    }
    std::sort(result.begin(), result.end());
    return result;
}

// Add those steps that begin farther than a distance from others before them.
void spread(const double *vertices, const std::vector<Over> &steps, double apart,
            std::vector<Over> &picked) {
    const size_t begun = picked.size();
    for (const Over &step : steps) {
        const auto is_far = [&](const Over &other) {
            double off[3];
            for (int c = 0; c < 3; ++c) off[c] = vertices[3 * step.first + c] - vertices[3 * other.first + c];
            return dot(off, off) > apart * apart;
        };
        if (std::all_of(picked.begin() + begun, picked.end(), is_far)) picked.push_back(step);
    }
}

}  // namespace

// Returns the number of ways, or `UNKNOWN_WAY`.
EXPORTED int64_t bodymeasure_first_ways(const Triangles *mesh, const Graph *graph, const Joined *ends,
                                        const Scope *scope, Ways *ways) {
    // Only vertices count over which ways are short enough. None is shorter than the one at hand.
    const double longer = (1.0 + scope->longer) * (1.0 + ROUNDING);
    std::vector<double> last(graph->vertices, INFINITY);
    for (int64_t k = 0; k < ends[1].count; ++k) last[ends[1].vertices[k]] = ends[1].distances[k];
    double most = INFINITY;
    for (int64_t k = 0; k < ends[0].count; ++k)
        most = std::min(most, longer * (ends[0].distances[k] + last[ends[0].vertices[k]]));
    const Reach ahead(*graph, ends[0], [&](int64_t vertex, double way) {
        most = std::min(most, longer * (way + last[vertex]));
        return way <= most;
    });
    const Reach back(*graph, ends[1], [&](int64_t vertex, double way) {
        return way + ahead.distance[vertex] <= most;
    });
    Over shortest{INFINITY, -1, -1, -1};
    for (int64_t k = 0; k < graph->vertices; ++k) {
        const double through = ahead.distance[k] + back.distance[k];
        if (through < shortest.whole) shortest = {through, k, k, -1};
    }
    if (!std::isfinite(shortest.whole)) return 0;
    std::vector<Over> rough{shortest};
    for (int64_t k = 0; k < scope->parts; ++k) {
        const double whole = (1.0 + scope->longer) * shortest.whole;
        spread(mesh->vertices, over_level(*graph, ahead, back, scope->part[k], whole),
               scope->apart * shortest.whole, rough);
    }
    std::sort(rough.begin(), rough.end());
    std::set<Numbers> begun, found;
    for (const Over &over : rough) {
        if (int64_t(begun.size()) == scope->most) break;
        Numbers vertices = way_to(*graph, ends[0], ahead, over.first);
        if (over.step >= 0) append(graph->along + over.step * graph->longest, graph->longest, vertices);
        const Numbers rest = way_to(*graph, ends[1], back, over.last);
        vertices.insert(vertices.end(), rest.rbegin(), rest.rend());
        if (!begun.insert(vertices).second) continue;
        const int64_t number = found.size(), first = number * ways->longest;
        Way way{int64_t(vertices.size()), vertices.data(), {}, {}, ways->longest,
                ways->strips + first,     ways->sides + first, ways->along + first, 0.0};
        std::copy(ways->faces, ways->faces + 2, way.faces);
        std::copy(&ways->ends[0][0], &ways->ends[0][0] + 6, &way.weights[0][0]);
        const int64_t count = straighten(*mesh, way);
        if (count == UNKNOWN_WAY) return UNKNOWN_WAY;
        if (count < 0 || !found.insert(Numbers(way.strip, way.strip + count)).second) continue;
        ways->counts[number] = count, ways->lengths[number] = way.length;
        std::copy(&way.weights[0][0], &way.weights[0][0] + 6, ways->weights + 6 * number);
    }
    return found.size();
}

}  // namespace bodymeasure

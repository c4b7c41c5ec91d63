// What the kernels share: the arrays that come from Python, and what they export.
//
// All functions have C's calling convention, take plain arrays of doubles in C order, and hold no
// state, so that threads may call them at once. Python allocates the results, and they what they
// need beside these.

#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

#if __has_include(<features.h>)
#include <features.h>  // Says whether the C library is glibc.
#endif

#if defined(_WIN32)
#define EXPORTED extern "C" __declspec(dllexport)
#else
#define EXPORTED extern "C" __attribute__((visibility("default")))
#endif

// Where the compiler and the loader can, the function that fits the processor is chosen at load.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
#define FOR_EACH_PROCESSOR \
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), flatten))
#else
#define FOR_EACH_PROCESSOR
#endif

namespace bodymeasure {

// The highest degree of a patch in one parameter for which the kernels have room.
constexpr int64_t MOST_DEGREE = 32, MOST_SIDE = MOST_DEGREE + 1;

// Numbers of several problems, which are calculated at once.
#if defined(__GNUC__)
constexpr int64_t LANES = 4;
typedef double Lanes __attribute__((vector_size(8 * LANES)));
inline double number_in(const Lanes &x, int64_t lane) { return x[lane]; }
inline void put_in(Lanes &x, int64_t lane, double value) { x[lane] = value; }
#else
constexpr int64_t LANES = 1;
typedef double Lanes;
inline double number_in(const Lanes &x, int64_t) { return x; }
inline void put_in(Lanes &x, int64_t, double value) { x = value; }
#endif

// Room for some of them. What a type is aligned to depends on the processor, so that `new` does not
// know it.
class Room {
    std::vector<double> whole;

  public:
    explicit Room(int64_t count) : whole((count + 1) * LANES) {}
    Lanes *begin() {
        constexpr uintptr_t size = sizeof(Lanes);
        return reinterpret_cast<Lanes *>((reinterpret_cast<uintptr_t>(whole.data()) + size - 1) / size * size);
    }
};

template <typename Number>
inline Number dot(const Number *a, const Number *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline void cross_product(const double *a, const double *b, double *result) {
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

// The values of the Bernstein polynomials of a degree at t.
template <typename Number>
inline void bernstein(int64_t degree, const Number &t, Number *values) {
    const Number s = 1.0 - t;
    values[0] = Number{} + 1.0;
    for (int64_t k = 1; k <= degree; ++k) {
        values[k] = t * values[k - 1];
        for (int64_t i = k - 1; i > 0; --i) values[i] = s * values[i] + t * values[i - 1];
        values[0] *= s;
    }
}

// Bezier patches of degrees (m, n), and polynomial paths on them, one for each patch.
struct Paths {
    int64_t count;
    int64_t degree_u, degree_v;
    // Control points of the derivatives of each patch, in the order of `surfaces.protocol.JET`:
    // (count, (m + 1) (n + 1), 30).
    const double *nets;
    // The trial space: its nodes, and its functions and their slopes at the points of the
    // quadrature, both (points, nodes).
    int64_t nodes, points;
    const double *place, *slopes, *weights;
};

// Past the last path, it is calculated again.
inline int64_t lane_of(const Paths &paths, int64_t number) {
    return number < paths.count ? number : paths.count - 1;
}

// Room for energies, in `Lanes`.
int64_t energy_room(const Paths &paths);

// The energies of paths from a number on, their gradients by all nodal values, u before v, and the
// lower triangles of their Hessians. Where `flat`, J^T J stands for the Hessian.
void energies_of_paths(const Paths &paths, int64_t number, const Lanes *values, bool flat,
                       Lanes *energy, Lanes *gradient, Lanes *hessian, Lanes *room);

// The speed of a path at the points of the quadrature, one by it, its geodesic curvature, and the
// Gaussian curvature of the patch there: (4, points), the entries `stride` apart. `bend` holds the
// second derivatives of the trial space's functions, (points, nodes). Room for (`path_room`) doubles.
void path_geometry(const Paths &paths, const double *bend, int64_t number, const double *values,
                   double *along, int64_t stride, double *room);
int64_t path_room(const Paths &paths);

// The length of a path if all terms of its derivatives were as large as their parts together.
double path_terms(const Paths &paths, const double *bend, int64_t number, const double *values,
                  double *room);

// Columns of a patch's nets at points; see `jets.cpp`.
void jets_of_patch(int64_t degree_u, int64_t degree_v, int64_t width, int64_t columns,
                   const double *net, int64_t points, const double *parameters, int64_t stride,
                   double *jets);

// Derivatives of a patch in powers, i times by u and j times by v: (3, 3, coordinates).
void power_jet(int64_t side, int64_t coordinates, const double *coefficients, const double *x,
               double *jet);

// The root of a polynomial in Bernstein form in a bracket in which it is monotone; where its sign
// does not change there, the end with the smaller value. Room for (degree + 1) doubles.
double bracketed_root(const double *coefficients, int64_t degree, double lower, double upper,
                      double *room);

using Place = std::complex<double>;

// A triangle mesh of whose sides each is on two faces at most. Side k joins corners k and k + 1.
struct Triangles {
    const int64_t *faces, *over;  // (faces, 3): the corners, and the face beyond each side or -1
    const Place *apex;            // (faces, 3): the third corner if the side leads from 0 to 1
    const double *angle;          // (vertices,), the sum of the angles about each
    const double *vertices;       // (vertices, 3)
};

// The way that is given, and the one that is found, with room for `most` faces.
struct Way {
    int64_t count;
    const int64_t *vertices;
    int64_t faces[2];      // those that hold the ends, and their barycentric coordinates there:
    double weights[2][3];  // moved to the ends of the strip
    int64_t most;
    int64_t *strip, *sides;
    double *along, length;
};

// What is returned where there is no way, and where the Python form has to look.
constexpr int64_t NO_WAY = -1, UNKNOWN_WAY = -2;

// Pull a way straight; the number of faces of its strip, or one of these.
int64_t straighten(const Triangles &mesh, Way &way);

// The distance to a node, and the node.
using Reached = std::pair<double, int64_t>;

// Shortest ways by Dijkstra's algorithm from the nodes that are reached already, at their distances.
// Edges from[k] to before from[k + 1] lead from node k to `heads`. A way that comes to a node is
// followed if it is wanted(node, distance). `before` and `edge` are the node before on the way and
// the edge from there; where there is none, these are -1 and anything, and the distance is infinite.
template <typename Wanted>
void shortest_ways(int64_t nodes, const int64_t *from, const int64_t *heads, const double *weights,
                   std::vector<Reached> reached, const Wanted &wanted, double *distance,
                   int64_t *before, int64_t *edge) {
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
            if (!(longer < distance[there]) || !wanted(there, longer)) continue;
            distance[there] = longer;
            before[there] = node;
            edge[there] = number;
            reached.emplace_back(longer, there);
            std::push_heap(reached.begin(), reached.end(), later);
        }
    }
}

// A quadratic model of a function on the box [0, 1]^n, as in `numerics.banded.BoxModels`.
struct BoxModel {
    int64_t unknowns, bands;
    const double *matrix;  // (bands, unknowns), the lower bands
    const double *gradient, *place;
    const uint8_t *idle;
};

// The entries of a vector of the widest processors, and of a column of a factor: whole vectors.
constexpr int64_t WIDTH = 8;
inline int64_t step_stride(int64_t bands) { return (bands + 2 * WIDTH - 1) / WIDTH * WIDTH; }

// Room for a step, in doubles.
inline int64_t step_room(int64_t unknowns, int64_t bands) {
    return (step_stride(bands) + 3) * unknowns;
}

// The step to the model's minimum in the box; false if there is none.
bool box_step(const BoxModel &model, double *step, double *room);

// By how much a step lowers the model's value.
double box_decrease(const BoxModel &model, const double *step, double *room);

// Whether an unknown is on a bound and pressed outwards by the gradient.
inline bool is_pressed(double place, double gradient) {
    return (place == 0.0 && gradient > 0.0) || (place == 1.0 && gradient < 0.0);
}

}  // namespace bodymeasure

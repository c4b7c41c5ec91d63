// Newton's method for paths by collocation with two unknown functions; the NumPy forms are
// `solving.newton` and `contact.moving_ends`.
//
// With A the acceleration of S(u(t), v(t)), the equations at the inner nodes are S_u . A = 0 and
// S_v . A = 0. Where an end may move along an edge, the path has to be tangential to it: there the
// derivative of the coordinate that the edge fixes is zero.

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

struct Collocation {
    int64_t count, degree_u, degree_v, nodes, most_evaluations;
    const double *nets;            // as in `Paths`
    const double *first, *second;  // the derivatives at the inner nodes, (nodes - 2, nodes)
    const double *at_ends;         // the first ones at both ends, (2, nodes)
    // Of each problem, the coordinates that edges fix at its ends; -1 for an end that stays.
    const int64_t *held;  // (count, 2)
    const double *spans;  // (count), beside which last steps are small
    double sufficient_decrease, last_step, longest_step, smallest_step;
};

namespace {

constexpr int64_t COLUMNS = 30;

// One problem. The unknowns are u and then v at the inner nodes, then the places of moving ends, of
// which each has an equation; the right sides stand in a last column.
struct System {
    const Collocation &all;
    int64_t number, inner, size = 0;
    std::vector<int64_t> place;  // of each unknown among the nodal values
    std::vector<double> jets, parameters, matrix;

    System(const Collocation &problems, int64_t which)
        : all(problems), number(which), inner(all.nodes - 2), jets(COLUMNS * inner), parameters(2 * inner) {
        for (int64_t axis = 0; axis < 2; ++axis)
            for (int64_t i = 1; i <= inner; ++i) place.push_back(axis * all.nodes + i);
        for (int64_t end = 0; end < 2; ++end)
            if (const int64_t axis = held(end); axis >= 0)
                place.push_back((1 - axis) * all.nodes + end * (inner + 1));
        size = int64_t(place.size());
        matrix.resize(size * (size + 1));
    }

    int64_t held(int64_t end) const { return all.held[2 * number + end]; }

    double sum(const double *row, const double *values) const {
        double result = 0.0;
        for (int64_t k = 0; k < all.nodes; ++k) result += row[k] * values[k];
        return result;
    }

    void expand(const double *values) {
        const int64_t nodes = all.nodes, functions = (all.degree_u + 1) * (all.degree_v + 1);
        for (int64_t k = 0; k < 2 * inner; ++k) parameters[k] = values[k % 2 * nodes + k / 2 + 1];
        jets_of_patch(all.degree_u, all.degree_v, COLUMNS, COLUMNS, all.nets + number * functions * COLUMNS,
                      inner, parameters.data(), inner, jets.data());
        for (int64_t i = 0; i < inner; ++i) {
            const double *first = all.first + i * nodes, *second = all.second + i * nodes;
            const double du = sum(first, values), dv = sum(first, values + nodes);
            const double ddu = sum(second, values), ddv = sum(second, values + nodes);
            double x[10][3], acceleration[3], by_place[2][3], by_slope[2][3];
            for (int k = 0; k < COLUMNS; ++k) x[k / 3][k % 3] = jets[k * inner + i];
            for (int c = 0; c < 3; ++c) {
                const double u = x[1][c], v = x[2][c], uu = x[3][c], uv = x[4][c], vv = x[5][c];
                const double uuv = x[7][c], uvv = x[8][c], two = 2.0 * du * dv;
                acceleration[c] = u * ddu + v * ddv + uu * (du * du) + uv * two + vv * (dv * dv);
                by_place[0][c] = uu * ddu + uv * ddv + x[6][c] * (du * du) + uuv * two + uvv * (dv * dv);
                by_place[1][c] = uv * ddu + vv * ddv + uuv * (du * du) + uvv * two + x[9][c] * (dv * dv);
                by_slope[0][c] = 2.0 * (uu * du + uv * dv);
                by_slope[1][c] = 2.0 * (uv * du + vv * dv);
            }
            for (int a = 0; a < 2; ++a) {
                double *row = matrix.data() + (a * inner + i) * (size + 1);
                double slope[2], bend[2];
                for (int b = 0; b < 2; ++b)
                    slope[b] = dot(x[1 + a], by_slope[b]), bend[b] = dot(x[1 + a], x[1 + b]);
                for (int64_t k = 0; k < size; ++k) {
                    const int64_t b = place[k] >= nodes, node = place[k] - b * nodes;
                    row[k] = slope[b] * first[node] + bend[b] * second[node];
                }
                for (int b = 0; b < 2; ++b)
                    row[b * inner + i] += dot(x[1 + a], by_place[b]) + dot(x[3 + a + b], acceleration);
                row[size] = -dot(x[1 + a], acceleration);
            }
        }
        double *row = matrix.data() + 2 * inner * (size + 1);
        for (int64_t end = 0; end < 2; ++end) {
            const int64_t axis = held(end);
            if (axis < 0) continue;
            const double *slopes = all.at_ends + end * nodes;
            for (int64_t k = 0; k < size; ++k) {
                const int64_t node = place[k] - axis * nodes;
                row[k] = 0 <= node && node < nodes ? slopes[node] : 0.0;
            }
            row[size] = -sum(slopes, values + axis * nodes);
            row += size + 1;
        }
    }

    double norm() const {
        double square = 0.0;
        for (int64_t k = 0; k < size; ++k)
            square += matrix[k * (size + 1) + size] * matrix[k * (size + 1) + size];
        return std::sqrt(square);
    }
};

// Elimination with the largest pivots of each column, in place; the solution replaces the last column.
// Returns whether it is finite.
FOR_EACH_PROCESSOR
bool solve(double *matrix, int64_t size) {
    const int64_t width = size + 1;
    for (int64_t i = 0; i < size; ++i) {
        double *__restrict pivot = matrix + i * width;
        int64_t best = i;
        for (int64_t r = i + 1; r < size; ++r)
            if (std::fabs(matrix[r * width + i]) > std::fabs(matrix[best * width + i])) best = r;
        if (best != i) std::swap_ranges(pivot + i, pivot + width, matrix + best * width + i);
        const double inverse = 1.0 / pivot[i];
        for (int64_t r = i + 1; r < size; ++r) {
            double *__restrict line = matrix + r * width;
            const double factor = line[i] * inverse;
            for (int64_t k = i + 1; k < width; ++k) line[k] -= factor * pivot[k];
        }
    }
    bool is_finite = true;
    for (int64_t i = size - 1; i >= 0; --i) {
        double *line = matrix + i * width, value = line[size];
        for (int64_t k = i + 1; k < size; ++k) value -= line[k] * matrix[k * width + size];
        line[size] = value / line[i];
        is_finite = is_finite && std::isfinite(line[size]);
    }
    return is_finite;
}

}  // namespace

// Solve the equations from guesses (count, 2, nodes), which are moved; see `solving.newton` for what
// is found of each problem.
EXPORTED int64_t bodymeasure_collocation(const Collocation *problems, double *values, uint8_t *converged,
                                         uint8_t *singular, int64_t *iterations) {
    const int64_t nodes = 2 * problems->nodes;
    std::vector<double> base(nodes), trial(nodes), direction(nodes);
    for (int64_t number = 0; number < problems->count; ++number, values += nodes) {
        System system(*problems, number);
        base.assign(values, values + nodes);
        direction.assign(nodes, 0.0);
        double step = 0.0, before = INFINITY, size = 0.0;
        bool done = false;
        converged[number] = singular[number] = 0;
        for (iterations[number] = 0; iterations[number] < problems->most_evaluations && !done;) {
            ++iterations[number];
            for (int64_t k = 0; k < nodes; ++k) trial[k] = base[k] + step * direction[k];
            system.expand(trial.data());
            const double norm = system.norm();
            bool solvable = true;
            if (norm <= (1.0 - problems->sufficient_decrease * step) * before) {
                base.swap(trial);
                before = norm, size = 0.0;
                solvable = solve(system.matrix.data(), system.size);
                for (int64_t k = 0; k < system.size; ++k) {
                    const double own = solvable ? system.matrix[k * (system.size + 1) + system.size] : 0.0;
                    direction[system.place[k]] = own;
                    size = std::fmax(size, std::fabs(own));
                }
                step = std::fmin(1.0, problems->longest_step / size);
            } else {
                step *= 0.5;
            }
            const bool small = solvable && size < problems->last_step * problems->spans[number];
            done = small || !solvable || step < problems->smallest_step || !std::isfinite(before);
            // The last step is known already; taking it squares the error once more.
            for (int64_t k = 0; k < nodes && small; ++k) base[k] += direction[k];
            converged[number] = small;
            // A first residual that is not finite is as bad as a system that cannot be solved.
            singular[number] = done && (!solvable || !std::isfinite(before));
        }
        for (int64_t k = 0; k < nodes; ++k) values[k] = base[k];
    }
    return problems->count;
}

}  // namespace bodymeasure

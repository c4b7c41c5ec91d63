// The energy of paths to the second order; the NumPy form is `lengths.functionals.energy`.
//
// With x' = S_u u' + S_v v' the energy is the integral of |x'|^2 / 2. At each point of the
// quadrature it depends on z = (u, v, u', v') alone, with the gradient J^T x' and the Hessian
// J^T J + x' . d2x'/dz2, J = dx'/dz, which the functions and slopes of the trial space take to the
// nodal values.

#include <cmath>

#include "kernels.h"

namespace bodymeasure {

namespace {

constexpr int64_t JET = 30, FIRST = 3;  // The positions, which come first, are not needed.
constexpr int SECOND = 10;              // The entries of a symmetric matrix of size 4.
// The place of the entry of two components of z.
constexpr int AT[4][4] = {{0, 1, 3, 4}, {1, 2, 5, 6}, {3, 5, 7, 8}, {4, 6, 8, 9}};
constexpr int64_t MOST_DEGREE = 32;

void bernstein(int64_t degree, double t, double *values) {
    const double s = 1.0 - t;
    values[0] = 1.0;
    for (int64_t k = 1; k <= degree; ++k) {
        values[k] = t * values[k - 1];
        for (int64_t i = k - 1; i > 0; --i) values[i] = s * values[i] + t * values[i - 1];
        values[0] *= s;
    }
}

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The density's second derivatives, the gradient, and the density itself, at one point.
double density(const double *jet, double du, double dv, bool flat, double *first, double *second) {
    const double *s_u = jet, *s_v = jet + 3, *s_uu = jet + 6, *s_uv = jet + 9, *s_vv = jet + 12;
    const double *s_uuu = jet + 15, *s_uuv = jet + 18, *s_uvv = jet + 21, *s_vvv = jet + 24;
    double x[3], by[4][3];
    for (int c = 0; c < 3; ++c) {
        x[c] = s_u[c] * du + s_v[c] * dv;
        by[0][c] = s_uu[c] * du + s_uv[c] * dv;
        by[1][c] = s_uv[c] * du + s_vv[c] * dv;
        by[2][c] = s_u[c];
        by[3][c] = s_v[c];
    }
    for (int a = 0; a < 4; ++a) {
        first[a] = dot(x, by[a]);
        for (int b = 0; b <= a; ++b) second[AT[a][b]] = dot(by[a], by[b]);
    }
    if (!flat) {
        const double mixed = dot(x, s_uv), uuv = dot(x, s_uuv), uvv = dot(x, s_uvv);
        second[AT[0][0]] += dot(x, s_uuu) * du + uuv * dv;
        second[AT[0][1]] += uuv * du + uvv * dv;
        second[AT[1][1]] += uvv * du + dot(x, s_vvv) * dv;
        second[AT[0][2]] += dot(x, s_uu);
        second[AT[0][3]] += mixed;
        second[AT[1][2]] += mixed;
        second[AT[1][3]] += dot(x, s_vv);
    }
    return 0.5 * dot(x, x);
}

}  // namespace

int64_t energy_room(const Paths &paths) { return 2 * paths.nodes; }

FOR_EACH_PROCESSOR
double energy_of_path(const Paths &paths, int64_t number, const double *values, bool flat,
                      double *gradient, double *hessian, double *room) {
    const int64_t nodes = paths.nodes, size = 2 * nodes;
    const int64_t in_u = paths.degree_u + 1, in_v = paths.degree_v + 1;
    const double *net = paths.nets + number * in_u * in_v * JET;
    for (int64_t i = 0; i < size; ++i) gradient[i] = 0.0;
    for (int64_t i = 0; i < size * size; ++i) hessian[i] = 0.0;
    double *of_place = room, *of_slope = room + nodes;
    double whole = 0.0;
    for (int64_t point = 0; point < paths.points; ++point) {
        const double *place = paths.place + point * nodes, *slope = paths.slopes + point * nodes;
        const double weight = paths.weights[point];
        // Differences from the start, so that rounding errors of slopes do not grow with (u, v).
        double u = 0.0, v = 0.0, du = 0.0, dv = 0.0;
        for (int64_t k = 0; k < nodes; ++k) {
            u += place[k] * values[k];
            v += place[k] * values[nodes + k];
            du += slope[k] * (values[k] - values[0]);
            dv += slope[k] * (values[nodes + k] - values[nodes]);
        }
        double by_u[MOST_DEGREE + 1], by_v[MOST_DEGREE + 1];
        bernstein(paths.degree_u, u, by_u);
        bernstein(paths.degree_v, v, by_v);
        double jet[JET - FIRST] = {};
        for (int64_t i = 0; i < in_u; ++i) {
            for (int64_t j = 0; j < in_v; ++j) {
                const double basis = by_u[i] * by_v[j];
                const double *row = net + (i * in_v + j) * JET + FIRST;
                for (int64_t c = 0; c < JET - FIRST; ++c) jet[c] += basis * row[c];
            }
        }
        double first[4], second[SECOND];
        whole += weight * density(jet, du, dv, flat, first, second);
        for (double &entry : first) entry *= weight;
        for (double &entry : second) entry *= weight;
        for (int a = 0; a < 2; ++a) {
            double *row = gradient + a * nodes;
            for (int64_t k = 0; k < nodes; ++k) row[k] += first[a] * place[k] + first[a + 2] * slope[k];
            for (int b = 0; b <= a; ++b) {
                const double both = second[AT[a][b]], right = second[AT[a][b + 2]];
                const double left = second[AT[a + 2][b]], slopes = second[AT[a + 2][b + 2]];
                for (int64_t k = 0; k < nodes; ++k) {
                    of_place[k] = both * place[k] + right * slope[k];
                    of_slope[k] = left * place[k] + slopes * slope[k];
                }
                for (int64_t i = 0; i < nodes; ++i) {
                    double *entries = hessian + (a * nodes + i) * size + b * nodes;
                    const double p = place[i], s = slope[i];
                    for (int64_t k = 0; k < nodes; ++k) entries[k] += p * of_place[k] + s * of_slope[k];
                }
            }
        }
    }
    for (int64_t i = 0; i < nodes; ++i)
        for (int64_t k = 0; k < nodes; ++k)
            hessian[i * size + nodes + k] = hessian[(nodes + k) * size + i];
    return whole;
}

}  // namespace bodymeasure

EXPORTED void bodymeasure_energy(const bodymeasure::Paths *paths, const double *values, int64_t flat,
                                 double *energies, double *gradients, double *hessians,
                                 double *room) {
    const int64_t size = 2 * paths->nodes;
    for (int64_t number = 0; number < paths->count; ++number)
        energies[number] = bodymeasure::energy_of_path(
            *paths, number, values + number * size, flat != 0, gradients + number * size,
            hessians + number * size * size, room);
}

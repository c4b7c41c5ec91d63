// The energy of paths to the second order; the NumPy form is `lengths.functionals.energy`.
//
// With x' = S_u u' + S_v v' the energy is the integral of |x'|^2 / 2. At each point of the
// quadrature it depends on z = (u, v, u', v') alone, with the gradient J^T x' and the Hessian
// J^T J + x' . d2x'/dz2, J = dx'/dz, which the functions and slopes of the trial space take to the
// nodal values.

#include <cmath>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

namespace {

// The positions, which come first, are not needed, but with their last coordinate the rest of a row is
// whole vectors.
constexpr int64_t JET = 30, FIRST = 2;
constexpr int SECOND = 10;  // The entries of a symmetric matrix of size 4.
// The place of the entry of two components of z.
constexpr int AT[4][4] = {{0, 1, 3, 4}, {1, 2, 5, 6}, {3, 5, 7, 8}, {4, 6, 8, 9}};
// Points whose parts of the Hessian are added at once, since each addition reads and writes it.
constexpr int64_t AT_ONCE = 4;

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

// Add what some points give to the lower blocks of the Hessian.
void add_to_hessian(int64_t nodes, const double *const *places, const double *const *slopes,
                    const double (*second)[SECOND], double *hessian, double *room) {
    const int64_t size = 2 * nodes;
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b <= a; ++b) {
            for (int64_t k = 0; k < AT_ONCE; ++k) {
                const double *entry = second[k], *place = places[k], *slope = slopes[k];
                const double both = entry[AT[a][b]], right = entry[AT[a][b + 2]];
                const double left = entry[AT[a + 2][b]], last = entry[AT[a + 2][b + 2]];
                double *of_place = room + 2 * k * nodes, *of_slope = of_place + nodes;
                for (int64_t i = 0; i < nodes; ++i) {
                    of_place[i] = both * place[i] + right * slope[i];
                    of_slope[i] = left * place[i] + last * slope[i];
                }
            }
            for (int64_t i = 0; i < nodes; ++i) {
                double *__restrict row = hessian + (a * nodes + i) * size + b * nodes;
                const double p0 = places[0][i], p1 = places[1][i], p2 = places[2][i];
                const double p3 = places[3][i], s0 = slopes[0][i], s1 = slopes[1][i];
                const double s2 = slopes[2][i], s3 = slopes[3][i];
                const double *__restrict part = room;
                for (int64_t j = 0; j < nodes; ++j)
                    row[j] += p0 * part[j] + s0 * part[nodes + j] + p1 * part[2 * nodes + j] +
                              s1 * part[3 * nodes + j] + p2 * part[4 * nodes + j] +
                              s2 * part[5 * nodes + j] + p3 * part[6 * nodes + j] +
                              s3 * part[7 * nodes + j];
            }
        }
    }
}

}  // namespace

int64_t energy_room(const Paths &paths) { return 2 * AT_ONCE * paths.nodes; }

FOR_EACH_PROCESSOR
double energy_of_path(const Paths &paths, int64_t number, const double *values, bool flat,
                      double *gradient, double *hessian, double *room) {
    const int64_t nodes = paths.nodes, size = 2 * nodes;
    const int64_t in_u = paths.degree_u + 1, in_v = paths.degree_v + 1;
    const double *net = paths.nets + number * in_u * in_v * JET;
    for (int64_t i = 0; i < size; ++i) gradient[i] = 0.0;
    for (int64_t i = 0; i < size * size; ++i) hessian[i] = 0.0;
    double whole = 0.0;
    for (int64_t begin = 0; begin < paths.points; begin += AT_ONCE) {
        double second[AT_ONCE][SECOND] = {};
        const double *places[AT_ONCE], *all_slopes[AT_ONCE];
        for (int64_t k = 0; k < AT_ONCE; ++k) {
            // Past the last point nothing is added: there the second derivatives are zero.
            const bool is_point = begin + k < paths.points;
            const int64_t point = is_point ? begin + k : begin;
            const double *place = places[k] = paths.place + point * nodes;
            const double *slope = all_slopes[k] = paths.slopes + point * nodes;
            if (!is_point) continue;
            // Differences from the start, so that rounding errors of slopes do not grow with (u, v).
            double u = 0.0, v = 0.0, du = 0.0, dv = 0.0;
            for (int64_t i = 0; i < nodes; ++i) {
                u += place[i] * values[i];
                v += place[i] * values[nodes + i];
                du += slope[i] * (values[i] - values[0]);
                dv += slope[i] * (values[nodes + i] - values[nodes]);
            }
            double by_u[MOST_SIDE], by_v[MOST_SIDE];
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
            const double weight = paths.weights[point];
            double first[4];
            whole += weight * density(jet + 1, du, dv, flat, first, second[k]);
            for (double &entry : second[k]) entry *= weight;
            for (int a = 0; a < 2; ++a) {
                const double by_place = weight * first[a], by_slope = weight * first[a + 2];
                double *row = gradient + a * nodes;
                for (int64_t i = 0; i < nodes; ++i) row[i] += by_place * place[i] + by_slope * slope[i];
            }
        }
        add_to_hessian(nodes, places, all_slopes, second, hessian, room);
    }
    // Only the lower triangle of blocks was summed.
    for (int64_t i = 0; i < nodes; ++i)
        for (int64_t k = 0; k < nodes; ++k)
            hessian[i * size + nodes + k] = hessian[(nodes + k) * size + i];
    return whole;
}

}  // namespace bodymeasure

EXPORTED int64_t bodymeasure_energy(const bodymeasure::Paths *paths, const double *values, int64_t flat,
                                 double *energies, double *gradients, double *hessians) {
    const int64_t size = 2 * paths->nodes;
    std::vector<double> room(bodymeasure::energy_room(*paths));
    for (int64_t number = 0; number < paths->count; ++number)
        energies[number] = bodymeasure::energy_of_path(
            *paths, number, values + number * size, flat != 0, gradients + number * size,
            hessians + number * size * size, room.data());
    return paths->count;
}

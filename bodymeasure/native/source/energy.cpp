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

// The positions, which come first, are not needed.
constexpr int64_t JET = 30, FIRST = 3;
// Derivatives that are summed at once, in registers.
constexpr int64_t COLUMNS = 9;
constexpr int SECOND = 10;  // The entries of a symmetric matrix of size 4.
// The place of the entry of two components of z.
constexpr int AT[4][4] = {{0, 1, 3, 4}, {1, 2, 5, 6}, {3, 5, 7, 8}, {4, 6, 8, 9}};
// Points whose parts of the Hessian are added at once, since each addition reads and writes it.
constexpr int64_t AT_ONCE = 4;

// The density's second derivatives, the gradient, and the density itself, at one point of each path.
inline Lanes density(const Lanes *jet, const Lanes &du, const Lanes &dv, bool flat, Lanes *first,
                     Lanes *second) {
    const Lanes *s_u = jet, *s_v = jet + 3, *s_uu = jet + 6, *s_uv = jet + 9, *s_vv = jet + 12;
    const Lanes *s_uuu = jet + 15, *s_uuv = jet + 18, *s_uvv = jet + 21, *s_vvv = jet + 24;
    Lanes x[3], by[4][3];
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
        const Lanes mixed = dot(x, s_uv), uuv = dot(x, s_uuv), uvv = dot(x, s_uvv);
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

// Add what some points give to the Hessian's lower triangle.
inline void add_to_hessian(int64_t nodes, const double *places, const double *slopes,
                           const Lanes (*second)[SECOND], Lanes *hessian, Lanes *room) {
    const int64_t size = 2 * nodes;
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b <= a; ++b) {
            for (int64_t k = 0; k < AT_ONCE; ++k) {
                const double *place = places + k * nodes, *slope = slopes + k * nodes;
                const Lanes both = second[k][AT[a][b]], right = second[k][AT[a][b + 2]];
                const Lanes left = second[k][AT[a + 2][b]], last = second[k][AT[a + 2][b + 2]];
                for (int64_t i = 0; i < nodes; ++i) {
                    room[(2 * k) * nodes + i] = both * place[i] + right * slope[i];
                    room[(2 * k + 1) * nodes + i] = left * place[i] + last * slope[i];
                }
            }
            for (int64_t i = 0; i < nodes; ++i) {
                Lanes *__restrict row = hessian + (a * nodes + i) * size + b * nodes;
                double of_row[2 * AT_ONCE];
                for (int64_t k = 0; k < AT_ONCE; ++k)
                    of_row[2 * k] = places[k * nodes + i], of_row[2 * k + 1] = slopes[k * nodes + i];
                for (int64_t j = 0; j < (a == b ? i + 1 : nodes); ++j) {
                    Lanes sum = row[j];
                    for (int64_t k = 0; k < 2 * AT_ONCE; ++k) sum += of_row[k] * room[k * nodes + j];
                    row[j] = sum;
                }
            }
        }
    }
}

}  // namespace

int64_t energy_room(const Paths &paths) {
    return (2 * AT_ONCE * paths.nodes + (paths.degree_u + 1) * (paths.degree_v + 1) * (JET + 1));
}

FOR_EACH_PROCESSOR
void energies_of_paths(const Paths &paths, int64_t number, const Lanes *values, bool flat,
                       Lanes *energy, Lanes *gradient, Lanes *hessian, Lanes *room) {
    const int64_t nodes = paths.nodes, size = 2 * nodes;
    const int64_t in_u = paths.degree_u + 1, in_v = paths.degree_v + 1, entries = in_u * in_v * JET;
    Lanes *nets = room + 2 * AT_ONCE * nodes, *basis = nets + entries;
    for (int64_t k = 0; k < LANES; ++k) {
        const double *net = paths.nets + lane_of(paths, number + k) * entries;
        for (int64_t i = 0; i < entries; ++i) put_in(nets[i], k, net[i]);
    }
    *energy = Lanes{};
    for (int64_t i = 0; i < size; ++i) gradient[i] = Lanes{};
    for (int64_t i = 0; i < size * size; ++i) hessian[i] = Lanes{};
    for (int64_t begin = 0; begin < paths.points; begin += AT_ONCE) {
        Lanes second[AT_ONCE][SECOND] = {};
        // The last points again if there are no more: there the second derivatives are zero.
        const int64_t from = begin + AT_ONCE <= paths.points ? begin : paths.points - AT_ONCE;
        for (int64_t point = begin; point < from + AT_ONCE; ++point) {
            const double *place = paths.place + point * nodes, *slope = paths.slopes + point * nodes;
            // Differences from the start, so that rounding errors of slopes do not grow with (u, v).
            Lanes u{}, v{}, du{}, dv{};
            for (int64_t i = 0; i < nodes; ++i) {
                u += place[i] * values[i];
                v += place[i] * values[nodes + i];
                du += slope[i] * (values[i] - values[0]);
                dv += slope[i] * (values[nodes + i] - values[nodes]);
            }
            Lanes by_u[MOST_SIDE], by_v[MOST_SIDE], jet[JET - FIRST];
            bernstein(paths.degree_u, u, by_u);
            bernstein(paths.degree_v, v, by_v);
            for (int64_t i = 0; i < in_u; ++i)
                for (int64_t j = 0; j < in_v; ++j) basis[i * in_v + j] = by_u[i] * by_v[j];
            for (int64_t c = FIRST; c < JET; c += COLUMNS) {
                Lanes sums[COLUMNS] = {};
                for (int64_t i = 0; i < in_u * in_v; ++i)
                    for (int64_t k = 0; k < COLUMNS; ++k) sums[k] += basis[i] * nets[i * JET + c + k];
                for (int64_t k = 0; k < COLUMNS; ++k) jet[c + k - FIRST] = sums[k];
            }
            const double weight = paths.weights[point];
            Lanes first[4], *bend = second[point - from];
            *energy += weight * density(jet, du, dv, flat, first, bend);
            for (int64_t k = 0; k < SECOND; ++k) bend[k] *= weight;
            for (int a = 0; a < 2; ++a) {
                const Lanes by_place = weight * first[a], by_slope = weight * first[a + 2];
                for (int64_t i = 0; i < nodes; ++i)
                    gradient[a * nodes + i] += by_place * place[i] + by_slope * slope[i];
            }
        }
        add_to_hessian(nodes, paths.place + from * nodes, paths.slopes + from * nodes, second, hessian,
                       room);
    }
}

}  // namespace bodymeasure

EXPORTED int64_t bodymeasure_energy(const bodymeasure::Paths *paths, const double *values, int64_t flat,
                                    double *energies, double *gradients, double *hessians) {
    using namespace bodymeasure;
    const int64_t size = 2 * paths->nodes;
    Room room(1 + size * (size + 2) + energy_room(*paths));
    Lanes *energy = room.begin(), *place = energy + 1, *gradient = place + size, *hessian = gradient + size;
    for (int64_t begin = 0; begin < paths->count; begin += LANES) {
        for (int64_t k = 0; k < LANES; ++k)
            for (int64_t i = 0; i < size; ++i)
                put_in(place[i], k, values[lane_of(*paths, begin + k) * size + i]);
        energies_of_paths(*paths, begin, place, flat != 0, energy, gradient, hessian,
                          hessian + size * size);
        for (int64_t k = 0; k < LANES && begin + k < paths->count; ++k) {
            energies[begin + k] = number_in(*energy, k);
            for (int64_t i = 0; i < size; ++i) *gradients++ = number_in(gradient[i], k);
            for (int64_t i = 0; i < size; ++i)
                for (int64_t j = 0; j < size; ++j)
                    *hessians++ = number_in(hessian[i < j ? j * size + i : i * size + j], k);
        }
    }
    return paths->count;
}

// Newton's method for the path along a route; the NumPy form is `box_newton.minimize_in_box` with
// `RouteProblem.expand`.
//
// The function is the sum over the pieces of sqrt(2 E + epsilon), E the energy of a piece. Its
// unknowns are the nodal values of all pieces, where neighbors share the place at which they cross
// their seam. Each step leads to the minimum, in the box, of the quadratic model with the exact
// Hessian, damped as by Levenberg and Marquardt.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

// What moves the nodal values of the pieces; arrays of shape (pieces, moved).
struct RouteUnknowns {
    int64_t unknowns, bands, moved;
    const int64_t *rows, *local;  // the unknown, and the nodal value that it moves
    const double *sign, *offset;  // value = offset + sign * unknown
    const double *fixed;          // (pieces, 2 nodes), the values that nothing moves
    const uint8_t *idle;          // (unknowns,)
    double epsilon;
};

// The constants of `numerics.box_newton`.
struct NewtonSettings {
    int64_t most_steps;
    double rest, rest_damping, rounding, start, first, less, more, least, most;
};

namespace {

struct Expansion {
    double value;
    double *gradient, *bands;  // (unknowns,), (bands, unknowns)
};

struct Work {
    Lanes *energy, *values, *gradient, *hessian, *rest;
    double *slope;
};

double expand(const Paths &paths, const RouteUnknowns &route, const double *place,
              const Expansion &result, const Work &room) {
    const int64_t nodes = paths.nodes, size = 2 * nodes, moved = route.moved;
    std::memset(result.gradient, 0, sizeof(double) * route.unknowns);
    std::memset(result.bands, 0, sizeof(double) * route.bands * route.unknowns);
    double whole = 0.0;
    for (int64_t begin = 0; begin < paths.count; begin += LANES) {
        for (int64_t lane = 0; lane < LANES; ++lane) {
            const int64_t piece = lane_of(paths, begin + lane), first = piece * moved;
            for (int64_t i = 0; i < size; ++i) put_in(room.values[i], lane, route.fixed[piece * size + i]);
            for (int64_t i = first; i < first + moved; ++i)
                put_in(room.values[route.local[i]], lane,
                       route.offset[i] + route.sign[i] * place[route.rows[i]]);
        }
        energies_of_paths(paths, begin, room.values, false, room.energy, room.gradient, room.hessian,
                          room.rest);
        for (int64_t lane = 0; lane < LANES && begin + lane < paths.count; ++lane) {
            const int64_t first = (begin + lane) * moved;
            const int64_t *rows = route.rows + first, *local = route.local + first;
            const double *sign = route.sign + first;
            const double root = std::sqrt(2.0 * number_in(*room.energy, lane) + route.epsilon);
            const double inverse = 1.0 / root;
            whole += root;
            for (int64_t i = 0; i < moved; ++i) {
                room.slope[i] = number_in(room.gradient[local[i]], lane) * sign[i] * inverse;
                result.gradient[rows[i]] += room.slope[i];
            }
            for (int64_t i = 0; i < moved; ++i) {
                for (int64_t j = 0; j < moved; ++j) {
                    const int64_t band = rows[i] - rows[j];
                    if (band < 0) continue;
                    const int64_t low = std::min(local[i], local[j]), high = std::max(local[i], local[j]);
                    const double bend = number_in(room.hessian[high * size + low], lane) * sign[i] * sign[j] -
                                        room.slope[i] * room.slope[j];
                    result.bands[band * route.unknowns + rows[j]] += bend * inverse;
                }
            }
        }
    }
    return whole;
}

}  // namespace

// Find the minimum from `place`, which is moved there. Returns the number of steps, negative if the
// last one did not come to rest; at least one is made. `value` and `bands` are those of the minimum.
EXPORTED int64_t bodymeasure_route_newton(const Paths *paths, const RouteUnknowns *route,
                                          const NewtonSettings *settings, double *place,
                                          double *value, double *gradient, double *bands) {
    const int64_t n = route->unknowns, size = 2 * paths->nodes;
    const int64_t entries = route->bands * n;
    Room lanes(1 + size * (size + 2) + energy_room(*paths));
    std::vector<double> whole(route->moved + 3 * n + 2 * entries + step_room(n, route->bands));
    double *room = whole.data();
    const auto take = [&room](int64_t count) { return (room += count) - count; };
    Lanes *values = lanes.begin() + 1, *slopes = values + size, *hessian = slopes + size;
    const Work own{lanes.begin(), values, slopes, hessian, hessian + size * size, take(route->moved)};
    double *trial = take(n), *step = take(n), *damped = take(entries);
    Expansion here{0.0, gradient, bands}, there{0.0, take(n), take(entries)};
    double *rest = room;
    here.value = expand(*paths, *route, place, here, own);
    double damping = settings->start;
    bool converged = false;
    int64_t steps = 0;
    while (steps < settings->most_steps && !converged && damping <= settings->most) {
        ++steps;
        std::memcpy(damped, here.bands, sizeof(double) * entries);
        for (int64_t i = 0; i < n; ++i) damped[i] += damping * std::fabs(here.bands[i]);
        const BoxModel model{n, route->bands, damped, here.gradient, place, route->idle};
        const bool definite = box_step(model, step, rest);
        double decrease = INFINITY;
        if (definite) {
            for (int64_t i = 0; i < n; ++i) {
                const double moved = place[i] + step[i];
                trial[i] = moved < 0.0 ? 0.0 : moved > 1.0 ? 1.0 : moved;
                step[i] = trial[i] - place[i];
            }
            decrease = box_decrease(model, step, rest);
            there.value = expand(*paths, *route, trial, there, own);
        }
        const double after = definite ? there.value : here.value;
        const bool small = decrease <= settings->rest * here.value;
        if (after < here.value || (small && after <= here.value * (1.0 + settings->rounding))) {
            converged = small && damping <= settings->rest_damping;
            std::memcpy(place, trial, sizeof(double) * n);
            here.value = there.value;
            std::memcpy(here.gradient, there.gradient, sizeof(double) * n);
            std::memcpy(here.bands, there.bands, sizeof(double) * entries);
            damping = damping * settings->less < settings->least ? 0.0 : damping * settings->less;
        } else {
            const double more = damping * settings->more;
            damping = more > settings->first ? more : settings->first;
        }
    }
    *value = here.value;
    return converged ? steps : -steps;
}

}  // namespace bodymeasure

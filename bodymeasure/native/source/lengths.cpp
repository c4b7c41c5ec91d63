// What lengths of paths are calculated from, point by point; the NumPy forms are
// `lengths.path_geometry` and `lengths.measure`.

#include <cmath>

#include "kernels.h"

namespace bodymeasure {

namespace {

// The columns of nets, and those of the derivatives up to the second, S first.
constexpr int64_t COLUMNS = 30, TERMS = 18;

// (u, v) at the points of the quadrature and two derivatives, (3, points, 2).
void follow(const Paths &paths, const double *bend, const double *values, double *motion) {
    const int64_t nodes = paths.nodes, step = 2 * paths.points;
    for (int64_t k = 0; k < step; ++k) {
        const double *x = values + k % 2 * nodes;
        const int64_t row = k / 2 * nodes;
        double place = 0.0, slope = 0.0, curve = 0.0;
        for (int64_t i = 0; i < nodes; ++i) {
            // Differences from the start, so that rounding errors do not grow with (u, v).
            const double moved = x[i] - x[0];
            place += paths.place[row + i] * x[i];
            slope += paths.slopes[row + i] * moved;
            curve += bend[row + i] * moved;
        }
        motion[k] = place, motion[step + k] = slope, motion[2 * step + k] = curve;
    }
}

}  // namespace

int64_t path_room(const Paths &paths) {
    const int64_t functions = (paths.degree_u + 1) * (paths.degree_v + 1);
    return (6 + TERMS) * paths.points + TERMS * functions;
}

FOR_EACH_PROCESSOR
void path_geometry(const Paths &paths, const double *bend, int64_t number, const double *values,
                   double *along, int64_t stride, double *room) {
    const int64_t points = paths.points, functions = (paths.degree_u + 1) * (paths.degree_v + 1);
    const double *net = paths.nets + number * functions * COLUMNS;
    double *motion = room, *jet = room + 6 * points;
    follow(paths, bend, values, motion);
    jets_of_patch(paths.degree_u, paths.degree_v, COLUMNS, TERMS, net, points, motion, points, jet);
    for (int64_t p = 0; p < points; ++p) {
        double x[6][3], velocity[3], acceleration[3], normal[3], turn[3];
        for (int k = 0; k < TERMS; ++k) x[k / 3][k % 3] = jet[k * points + p];
        const double *first = motion + 2 * (points + p), *second = first + 2 * points;
        const double du = first[0], dv = first[1];
        for (int c = 0; c < 3; ++c) {
            velocity[c] = x[1][c] * du + x[2][c] * dv;
            acceleration[c] = x[1][c] * second[0] + x[2][c] * second[1] + x[3][c] * du * du +
                              2.0 * x[4][c] * du * dv + x[5][c] * dv * dv;
        }
        cross_product(x[1], x[2], normal);
        cross_product(velocity, acceleration, turn);
        const double area = dot(normal, normal), twist = dot(x[4], normal);
        double *result = along + p * stride;
        const int64_t next = points * stride;
        const double speed = std::sqrt(dot(velocity, velocity));
        result[0] = speed, result[next] = 1.0 / speed;
        result[2 * next] = dot(turn, normal) / (speed * speed * speed * std::sqrt(area));
        result[3 * next] = (dot(x[3], normal) * dot(x[5], normal) - twist * twist) / (area * area);
    }
}

double path_terms(const Paths &paths, const double *bend, int64_t number, const double *values,
                  double *room) {
    const int64_t points = paths.points, functions = (paths.degree_u + 1) * (paths.degree_v + 1);
    const double *net = paths.nets + number * functions * COLUMNS;
    double *jet = room + 6 * points, *sizes = jet + TERMS * points, result = 0.0;
    follow(paths, bend, values, room);
    for (int64_t k = 0; k < functions * TERMS; ++k)
        sizes[k] = std::fabs(net[k / TERMS * COLUMNS + k % TERMS]);
    jets_of_patch(paths.degree_u, paths.degree_v, TERMS, TERMS, sizes, points, room, points, jet);
    for (int64_t p = 0; p < points; ++p) {
        const double *place = room + 2 * p, *slope = place + 2 * points;
        const double u = std::fabs(place[0]), v = std::fabs(place[1]);
        double term[6];
        for (int k = 1; k < 6; ++k) {
            const double *x = jet + 3 * k * points + p;
            const double y = x[points], z = x[2 * points];
            term[k] = std::sqrt(x[0] * x[0] + y * y + z * z);
        }
        result += paths.weights[p] * ((term[1] + term[3] * u + term[4] * v) * std::fabs(slope[0]) +
                                      (term[2] + term[4] * u + term[5] * v) * std::fabs(slope[1]));
    }
    return result;
}

}  // namespace bodymeasure

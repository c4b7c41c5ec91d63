// Points on the pieces of plane sections, and the velocities there; the NumPy form is
// `section.pieces.CutSurface.points`.
//
// A piece is the graph of one parameter s of its patch over the other, t: with f the distance from
// the plane, f(s, t) = 0. Its velocity is S_t + s' S_s, with s' = -(n S_t) / (n S_s).

#include <vector>

#include "kernels.h"

namespace bodymeasure {

struct SectionPieces {
    int64_t count, points, side, coordinates;
    // The pieces: their patches, the parameters that run (0 for u, 1 for v), where these start, how
    // far they run, and the bounds of the other one.
    const int64_t *patch, *axis;
    const double *start, *span, *low, *high;
    // Where on each piece points are wanted, as parts of what it runs: (count, points).
    const double *fraction;
    // Of all patches: their control points, and their distances from the plane in Bernstein form.
    const double *nets, *distances, *normal;
};

namespace {

// The values of the Bernstein polynomials at t, and their slopes.
void basis(int64_t degree, double t, double *values, double *slopes) {
    double lower[MOST_SIDE + 1] = {0.0};
    if (degree > 0) bernstein(degree - 1, t, lower + 1);
    lower[degree + 1] = 0.0;
    for (int64_t i = 0; i <= degree; ++i) {
        values[i] = t * lower[i] + (1.0 - t) * lower[i + 1];
        slopes[i] = degree * (lower[i] - lower[i + 1]);
    }
    if (degree == 0) values[0] = 1.0;
}

// The position of a patch and its derivatives by u and v; of a rational one, with its weight.
void tangents(int64_t side, int64_t coordinates, const double *net, const double *x,
              double (*jet)[4]) {
    double by_u[2][MOST_SIDE], by_v[2][MOST_SIDE];
    basis(side - 1, x[0], by_u[0], by_u[1]);
    basis(side - 1, x[1], by_v[0], by_v[1]);
    for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 4; ++c) jet[k][c] = 0.0;
    for (int64_t i = 0; i < side; ++i) {
        double row[2][4] = {{0.0}};
        for (int64_t j = 0; j < side; ++j, net += coordinates)
            for (int64_t c = 0; c < coordinates; ++c) {
                row[0][c] += by_v[0][j] * net[c];
                row[1][c] += by_v[1][j] * net[c];
            }
        for (int64_t c = 0; c < coordinates; ++c) {
            jet[0][c] += by_u[0][i] * row[0][c];
            jet[1][c] += by_u[1][i] * row[0][c];
            jet[2][c] += by_u[0][i] * row[1][c];
        }
    }
    if (coordinates < 4) return;
    // S = A / w has the derivative (A' - w' S) / w.
    for (int c = 0; c < 3; ++c) jet[0][c] /= jet[0][3];
    for (int k = 1; k < 3; ++k)
        for (int c = 0; c < 3; ++c) jet[k][c] = (jet[k][c] - jet[k][3] * jet[0][c]) / jet[0][3];
}

}  // namespace

FOR_EACH_PROCESSOR
void section_points(const SectionPieces &all, double *parameters, double *positions,
                    double *velocities) {
    const int64_t side = all.side, degree = side - 1;
    std::vector<double> room(2 * side);
    double *across = room.data() + side, basis_along[MOST_SIDE], jet[3][4];
    for (int64_t piece = 0; piece < all.count; ++piece) {
        const double *net = all.nets + all.patch[piece] * side * side * all.coordinates;
        const double *distance = all.distances + all.patch[piece] * side * side;
        const bool over_v = all.axis[piece] == 1;
        const int64_t own = over_v ? 1 : side, other = over_v ? side : 1;
        for (int64_t k = piece * all.points; k < (piece + 1) * all.points; ++k) {
            const double t = all.start[piece] + all.fraction[k] * all.span[piece];
            bernstein(degree, t, basis_along);
            for (int64_t j = 0; j < side; ++j) {
                across[j] = 0.0;
                for (int64_t i = 0; i < side; ++i)
                    across[j] += basis_along[i] * distance[i * own + j * other];
            }
            const double s =
                bracketed_root(across, degree, all.low[piece], all.high[piece], room.data());
            double *x = parameters + 2 * k;
            x[over_v ? 1 : 0] = t;
            x[over_v ? 0 : 1] = s;
            tangents(side, all.coordinates, net, x, jet);
            const double *along = jet[over_v ? 2 : 1], *beside = jet[over_v ? 1 : 2];
            const double run = dot(beside, all.normal);
            const double slope = run != 0.0 ? -dot(along, all.normal) / run : 0.0;
            for (int c = 0; c < 3; ++c) {
                positions[3 * k + c] = jet[0][c];
                velocities[3 * k + c] = (along[c] + slope * beside[c]) * all.span[piece];
            }
        }
    }
}

}  // namespace bodymeasure

// Parameters (count, points, 2), positions and velocities by the fraction (count, points, 3).
EXPORTED int64_t bodymeasure_section_points(const bodymeasure::SectionPieces *all,
                                            double *parameters, double *positions,
                                            double *velocities) {
    bodymeasure::section_points(*all, parameters, positions, velocities);
    return all->count;
}

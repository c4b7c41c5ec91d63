// Positions and derivatives of patches at points; the NumPy form is `BezierSurfaces._evaluated`.

#include "kernels.h"

namespace bodymeasure {

namespace {

constexpr int64_t MOST_COLUMNS = 40;

}  // namespace

// One patch, at points (points, 2), from nets of shape (functions, width), of which the first
// columns are wanted: (columns, stride), where the points of this patch stand side by side.
inline void jets_at(int64_t degree_u, int64_t degree_v, int64_t width, int64_t columns,
                    const double *net, int64_t points, const double *parameters, int64_t stride,
                    double *jets) {
    for (int64_t k = 0; k < points; ++k) {
        double by_u[MOST_SIDE], by_v[MOST_SIDE], sums[MOST_COLUMNS];
        bernstein(degree_u, parameters[2 * k], by_u);
        bernstein(degree_v, parameters[2 * k + 1], by_v);
        for (int64_t c = 0; c < columns; ++c) sums[c] = 0.0;
        for (int64_t i = 0; i <= degree_u; ++i) {
            for (int64_t j = 0; j <= degree_v; ++j) {
                const double basis = by_u[i] * by_v[j];
                const double *row = net + (i * (degree_v + 1) + j) * width;
                for (int64_t c = 0; c < columns; ++c) sums[c] += basis * row[c];
            }
        }
        for (int64_t c = 0; c < columns; ++c) jets[c * stride + k] = sums[c];
    }
}

// The same; for points of bicubic patches, and for their derivatives up to the second and the third,
// the compiler knows how long the loops are.
FOR_EACH_PROCESSOR
void jets_of_patch(int64_t degree_u, int64_t degree_v, int64_t width, int64_t columns,
                   const double *net, int64_t points, const double *parameters, int64_t stride,
                   double *jets) {
    const int64_t known = degree_u == 3 && degree_v == 3 ? columns : 0;
    if (known == 3) return jets_at(3, 3, width, 3, net, points, parameters, stride, jets);
    if (known == 18) return jets_at(3, 3, width, 18, net, points, parameters, stride, jets);
    if (known == 30) return jets_at(3, 3, width, 30, net, points, parameters, stride, jets);
    jets_at(degree_u, degree_v, width, columns, net, points, parameters, stride, jets);
}

}  // namespace bodymeasure

EXPORTED int64_t bodymeasure_jets(int64_t count, int64_t degree_u, int64_t degree_v, int64_t width,
                                  int64_t columns, const double *nets, int64_t points,
                                  const double *parameters, double *jets) {
    const int64_t functions = (degree_u + 1) * (degree_v + 1);
    for (int64_t number = 0; number < count; ++number)
        bodymeasure::jets_of_patch(degree_u, degree_v, width, columns,
                                   nets + number * functions * width, points,
                                   parameters + 2 * number * points, count * points,
                                   jets + number * points);
    return count;
}

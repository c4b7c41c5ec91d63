// Positions and derivatives of patches in powers of u and v; the NumPy form is
// `bezier.power_form.jets`.

#include "kernels.h"

namespace bodymeasure {

namespace {

// The powers of t, their slopes, and the slopes of those.
void powers(int64_t side, double t, double (*result)[MOST_SIDE]) {
    result[0][0] = 1.0;
    result[1][0] = result[2][0] = result[2][side > 1 ? 1 : 0] = 0.0;
    for (int64_t k = 1; k < side; ++k) {
        result[0][k] = t * result[0][k - 1];
        result[1][k] = k * result[0][k - 1];
        if (k > 1) result[2][k] = k * (k - 1) * result[0][k - 2];
    }
}

}  // namespace

// Derivatives i times by u and j times by v of one patch at one point: (3, 3, coordinates).
FOR_EACH_PROCESSOR
void power_jet(int64_t side, int64_t coordinates, const double *coefficients, const double *x,
               double *jet) {
    double by_u[3][MOST_SIDE], by_v[3][MOST_SIDE], row[4 * MOST_SIDE];
    powers(side, x[0], by_u);
    powers(side, x[1], by_v);
    const int64_t width = side * coordinates;
    for (int i = 0; i < 3; ++i) {
        for (int64_t c = 0; c < width; ++c) row[c] = 0.0;
        for (int64_t a = 0; a < side; ++a) {
            const double power = by_u[i][a];
            for (int64_t c = 0; c < width; ++c) row[c] += power * coefficients[a * width + c];
        }
        for (int j = 0; j < 3; ++j) {
            double *entry = jet + (3 * i + j) * coordinates;
            for (int64_t c = 0; c < coordinates; ++c) entry[c] = 0.0;
            for (int64_t b = 0; b < side; ++b)
                for (int64_t c = 0; c < coordinates; ++c)
                    entry[c] += by_v[j][b] * row[b * coordinates + c];
        }
    }
}

}  // namespace bodymeasure

EXPORTED int64_t bodymeasure_power_jets(int64_t count, int64_t side, int64_t coordinates,
                                        const double *coefficients, const double *x, double *jets) {
    for (int64_t k = 0; k < count; ++k)
        bodymeasure::power_jet(side, coordinates, coefficients + k * side * side * coordinates,
                               x + 2 * k, jets + 9 * k * coordinates);
    return count;
}

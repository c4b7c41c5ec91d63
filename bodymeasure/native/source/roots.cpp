// Roots of polynomials in brackets; the NumPy form is `section.roots.bracketed_roots`.
//
// Newton's method, with a halving wherever its step would leave the bracket.

#include <cmath>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

namespace {

constexpr int MOST_STEPS = 120;
// The rounding error of parameters, which lie in [0, 1].
constexpr double FINEST = 4e-16;

// The value of a polynomial in Bernstein form, and its slope, by de Casteljau's algorithm.
double value_at(const double *coefficients, int64_t degree, double t, double *slope, double *room) {
    const double s = 1.0 - t;
    for (int64_t i = 0; i <= degree; ++i) room[i] = coefficients[i];
    for (int64_t left = degree; left > 1; --left)
        for (int64_t i = 0; i < left; ++i) room[i] = s * room[i] + t * room[i + 1];
    *slope = degree * (room[1] - room[0]);
    return s * room[0] + t * room[1];
}

}  // namespace

double bracketed_root(const double *coefficients, int64_t degree, double lower, double upper,
                      double *room) {
    double low = lower, high = upper, slope;
    const double at_low = value_at(coefficients, degree, low, &slope, room);
    const double at_high = value_at(coefficients, degree, high, &slope, room);
    if ((at_low < 0.0) == (at_high < 0.0))
        return std::fabs(at_low) <= std::fabs(at_high) ? low : high;
    const bool rising = at_low < 0.0;
    double t = 0.5 * (low + high);
    for (int step = 0; step < MOST_STEPS; ++step) {
        const double value = value_at(coefficients, degree, t, &slope, room);
        ((value < 0.0) == rising ? low : high) = t;
        const double move = slope != 0.0 ? value / slope : INFINITY;
        // This comes first, since a root that is met exactly is an end of its bracket.
        const bool arrived = std::fabs(move) <= FINEST;
        double next = t - move;
        if (!arrived && !(next > low && next < high)) next = 0.5 * (low + high);
        t = next < lower ? lower : next > upper ? upper : next;
        if (arrived || high - low <= FINEST) break;
    }
    return t;
}

}  // namespace bodymeasure

// Of `count` polynomials, (count, degree + 1).
EXPORTED int64_t bodymeasure_roots(int64_t count, int64_t degree, const double *coefficients,
                                   const double *lower, const double *upper, double *found) {
    std::vector<double> room(degree + 1);
    for (int64_t k = 0; k < count; ++k)
        found[k] = bodymeasure::bracketed_root(coefficients + k * (degree + 1), degree, lower[k],
                                               upper[k], room.data());
    return count;
}

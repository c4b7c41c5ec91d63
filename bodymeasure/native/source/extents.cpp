// Patches scaled to about size 1, their greatest extents and their largest coordinates; the NumPy
// forms are `of_size_one` and `extents` of `geodesic.surfaces.control_points`.

#include <cmath>

#include "kernels.h"

namespace bodymeasure {

namespace {

// Four points at a time, so that vectors of the processor hold them.
constexpr int64_t AT_ONCE = 12;

FOR_EACH_PROCESSOR
void extents(int64_t count, int64_t numbers, const double *x, double *scaled, double *found) {
    for (int64_t number = 0; number < count; ++number, x += numbers) {
        double low[AT_ONCE], high[AT_ONCE], sums[AT_ONCE] = {};
        for (int64_t k = 0; k < AT_ONCE; ++k) low[k] = high[k] = x[k % 3];
        for (int64_t begin = 0; begin < numbers; begin += AT_ONCE) {
            const int64_t rest = numbers - begin < AT_ONCE ? numbers - begin : AT_ONCE;
            for (int64_t k = 0; k < rest; ++k) {
                const double value = x[begin + k];
                low[k] = value < low[k] ? value : low[k];
                high[k] = value > high[k] ? value : high[k];
                sums[k] += 0.0 * value;  // Not a number where the value is none, or infinite.
            }
        }
        double most = 0.0, far = 0.0, sum = 0.0;
        for (int64_t c = 0; c < 3; ++c) {
            double least = low[c], greatest = high[c];
            for (int64_t k = c; k < AT_ONCE; k += 3) {
                least = low[k] < least ? low[k] : least;
                greatest = high[k] > greatest ? high[k] : greatest;
                sum += sums[k];
            }
            most = std::fmax(most, greatest - least);
            far = std::fmax(far, std::fmax(-least, greatest));
        }
        found[number] = most += sum, found[count + number] = far + sum;
        if (!scaled) continue;
        // By a power of 2 in two steps, since that of the smallest patches is beyond all numbers.
        const int power = most > 0.0 && most < INFINITY ? std::ilogb(most) : 0;
        const double half = std::ldexp(1.0, -(power / 2));
        const double rest = std::ldexp(1.0, power / 2 - power);
        for (int64_t k = 0; k < numbers; ++k) scaled[k] = x[k] * half * rest;
        found[2 * count + number] = std::ldexp(1.0, power), scaled += numbers;
    }
}

}  // namespace

}  // namespace bodymeasure

// Of points (count, points, 3); `found` are the extents and the largest coordinates, both not a
// number where a coordinate is not finite, and, if scaled points are asked for, their units.
EXPORTED int64_t bodymeasure_extents(int64_t count, int64_t points, const double *net,
                                     double *scaled, double *found) {
    bodymeasure::extents(count, 3 * points, net, scaled, found);
    return count;
}

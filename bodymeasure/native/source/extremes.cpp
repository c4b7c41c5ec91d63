// The least and greatest coordinates of patches; the NumPy form is
// `geodesic.surfaces.control_points.extremes`.

#include "kernels.h"

namespace bodymeasure {

namespace {

// Four points at a time, so that vectors of the processor hold them.
constexpr int64_t AT_ONCE = 12;

inline void extremes_of(int64_t numbers, const double *x, double *low, double *high) {
    double least[AT_ONCE], most[AT_ONCE], sums[AT_ONCE] = {};
    for (int64_t k = 0; k < AT_ONCE; ++k) least[k] = most[k] = x[k % 3];
    int64_t begin = 0;
    for (; begin + AT_ONCE <= numbers; begin += AT_ONCE)
        for (int64_t k = 0; k < AT_ONCE; ++k) {
            const double value = x[begin + k];
            least[k] = value < least[k] ? value : least[k];
            most[k] = value > most[k] ? value : most[k];
            sums[k] += 0.0 * value;  // Not a number where the value is none, or infinite.
        }
    for (int64_t k = 0; begin + k < numbers; ++k) {
        const double value = x[begin + k];
        least[k] = value < least[k] ? value : least[k];
        most[k] = value > most[k] ? value : most[k];
        sums[k] += 0.0 * value;
    }
    for (int64_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        low[c] = least[c], high[c] = most[c];
        for (int64_t k = c; k < AT_ONCE; k += 3) {
            low[c] = least[k] < low[c] ? least[k] : low[c];
            high[c] = most[k] > high[c] ? most[k] : high[c];
            sum += sums[k];
        }
        low[c] += sum, high[c] += sum;
    }
}

FOR_EACH_PROCESSOR
void extremes(int64_t count, int64_t numbers, const double *x, double *low, double *high) {
    for (int64_t number = 0; number < count; ++number)
        extremes_of(numbers, x + numbers * number, low + 3 * number, high + 3 * number);
}

}  // namespace

}  // namespace bodymeasure

// Of points (count, points, 3); `low` and `high` are (count, 3), and not a number where one is not
// finite.
EXPORTED int64_t bodymeasure_extremes(int64_t count, int64_t points, const double *net, double *low,
                                      double *high) {
    bodymeasure::extremes(count, 3 * points, net, low, high);
    return count;
}

// Steps to the minima of quadratic models in a box; the NumPy form is `numerics.banded.BoxModels`.
//
// A primal-dual active set (M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002) 865-888):
// what would leave the box is put on its bound, and what is on a bound and not pressed there is let
// go, until nothing changes. The systems are solved by Cholesky's factors of the lower bands.

#include <cmath>
#include <limits>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

namespace {

constexpr int MOST_SETS = 20;

void product(const BoxModel &model, const double *vector, double *result) {
    const int64_t n = model.unknowns;
    for (int64_t i = 0; i < n; ++i) result[i] = model.matrix[i] * vector[i];
    for (int64_t row = 1; row < model.bands; ++row) {
        const double *band = model.matrix + row * n;
        for (int64_t j = 0; j < n - row; ++j) {
            result[j + row] += band[j] * vector[j];
            result[j] += band[j] * vector[j + row];
        }
    }
}

// Solve for what is free, by columns of the lower triangle: (n, stride). Past its entries a column
// has zeros, so that the innermost loop always takes whole vectors. False if the matrix is not
// positive definite there.
bool solve_free(const BoxModel &model, const double *bound, double *factor, double *right) {
    const int64_t n = model.unknowns, bands = model.bands, stride = step_stride(bands);
    for (int64_t j = 0; j < n; ++j) {
        double *column = factor + j * stride;
        const bool is_free = std::isnan(bound[j]);
        const int64_t below = bands < n - j ? bands : n - j;
        column[0] = is_free ? model.matrix[j] : 1.0;
        for (int64_t row = 1; row < stride; ++row) column[row] = 0.0;
        for (int64_t row = 1; row < below && is_free; ++row)
            if (std::isnan(bound[j + row])) column[row] = model.matrix[row * n + j];
    }
    for (int64_t j = 0; j < n; ++j) {
        double *__restrict column = factor + j * stride;
        if (!(column[0] > 0.0)) return false;
        const double root = std::sqrt(column[0]), inverse = 1.0 / root;
        column[0] = root;
        const int64_t below = bands < n - j ? bands : n - j;
        for (int64_t row = 1; row < below; ++row) column[row] *= inverse;
        right[j] *= inverse;
        for (int64_t row = 1; row < below; ++row) {
            const double entry = column[row];
            if (entry == 0.0) continue;
            right[j + row] -= entry * right[j];
            double *__restrict other = factor + (j + row) * stride;
            for (int64_t k = 0; k < below - row; k += WIDTH)
                for (int64_t lane = 0; lane < WIDTH; ++lane)
                    other[k + lane] -= entry * column[row + k + lane];
        }
    }
    for (int64_t j = n - 1; j >= 0; --j) {
        const double *column = factor + j * stride;
        const int64_t below = bands < n - j ? bands : n - j;
        double sum = right[j];
        for (int64_t row = 1; row < below; ++row) sum -= column[row] * right[j + row];
        right[j] = sum / column[0];
    }
    return true;
}

}  // namespace

FOR_EACH_PROCESSOR
bool box_step(const BoxModel &model, double *step, double *room) {
    const int64_t n = model.unknowns;
    double *bound = room, *held = room + n, *slope = room + 2 * n, *factor = room + 3 * n;
    const double free = std::numeric_limits<double>::quiet_NaN();
    for (int64_t i = 0; i < n; ++i) {
        const bool stays = model.idle[i] || is_pressed(model.place[i], model.gradient[i]);
        bound[i] = stays ? model.place[i] : free;
    }
    for (int round = 0; round < MOST_SETS; ++round) {
        for (int64_t i = 0; i < n; ++i)
            held[i] = std::isnan(bound[i]) ? 0.0 : bound[i] - model.place[i];
        product(model, held, slope);
        for (int64_t i = 0; i < n; ++i)
            step[i] = std::isnan(bound[i]) ? -model.gradient[i] - slope[i] : held[i];
        bool definite = solve_free(model, bound, factor, step);
        for (int64_t i = 0; i < n && definite; ++i) definite = std::isfinite(step[i]);
        if (!definite) {
            for (int64_t i = 0; i < n; ++i) step[i] = 0.0;
            return false;
        }
        product(model, step, slope);
        bool same = true;
        for (int64_t i = 0; i < n; ++i) {
            const double there = model.place[i] + step[i];
            const bool was_free = std::isnan(bound[i]);
            const bool stays = model.idle[i] || (!was_free && (1.0 - 2.0 * bound[i]) *
                                                                  (model.gradient[i] + slope[i]) > 0.0);
            const bool leaves = was_free && (there < 0.0 || there > 1.0);
            const double now = stays ? bound[i] : leaves ? (there < 0.5 ? 0.0 : 1.0) : free;
            same = same && (now == bound[i] || (std::isnan(now) && was_free));
            bound[i] = now;
        }
        if (same) break;
    }
    return true;
}

FOR_EACH_PROCESSOR
double box_decrease(const BoxModel &model, const double *step, double *room) {
    product(model, step, room);
    double sum = 0.0;
    for (int64_t i = 0; i < model.unknowns; ++i)
        sum -= (model.gradient[i] + 0.5 * room[i]) * step[i];
    return sum;
}

}  // namespace bodymeasure

// Many models of one size, in arrays of (count, ...).
EXPORTED int64_t bodymeasure_box_steps(int64_t count, int64_t unknowns, int64_t bands,
                                       const double *matrix, const double *gradient,
                                       const double *place, const uint8_t *idle, double *step,
                                       uint8_t *definite) {
    std::vector<double> room(bodymeasure::step_room(unknowns, bands));
    for (int64_t number = 0; number < count; ++number) {
        const int64_t first = number * unknowns;
        const bodymeasure::BoxModel model{unknowns,         bands,         matrix + first * bands,
                                          gradient + first, place + first, idle + first};
        definite[number] = bodymeasure::box_step(model, step + first, room.data());
    }
    return count;
}

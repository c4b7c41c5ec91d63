// Polygons that slide down to rest on their patches; the NumPy form is `shortest.descent`.
//
// With the steps d_k = x_(k+1) - x_k of m edges the energy is m sum |d_k|^2. Its derivatives by (u, v)
// of a point are 2 m (S_u . b, S_v . b), b = d_(k-1) - d_k. In its Hessian, the metric of the point
// stands on the diagonal, twice, with the second derivatives times b, and -S_a . S_b of neighbors
// below it. The unknowns are u and v of each inner point in turn.

#include <cmath>
#include <utility>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

struct Descent {
    int64_t count, degree_u, degree_v, points, most_steps;
    const double *nets;  // as in `Paths`
    double regularization, rest, first_damping, less, more, most_damping;
};

namespace {

constexpr int64_t COLUMNS = 30, TERMS = 18, BANDS = 4;

// The energy, its gradient, the bands of its Hessian without the metric, and those of the metric.
struct Expansion {
    double value = 0.0;
    std::vector<double> gradient, bands, metric;
    explicit Expansion(int64_t unknowns)
        : gradient(unknowns), bands(BANDS * unknowns), metric(2 * unknowns) {}
};

void expand(const Descent &all, const double *net, const double *places, double *jets, Expansion &here) {
    const int64_t points = all.points, n = 2 * (points - 2);
    const double edges = double(points - 1), factor = 2.0 * edges;
    double *bands = here.bands.data(), trace = 0.0, square = 0.0;
    jets_of_patch(all.degree_u, all.degree_v, COLUMNS, TERMS, net, points, places, points, jets);
    const auto column = [&](int64_t k, int64_t term, double *x) {
        for (int64_t c = 0; c < 3; ++c) x[c] = jets[(3 * term + c) * points + k];
    };
    double before[3], last[2][3], x[6][3];
    column(0, 0, before);
    for (int64_t k = 1; k < points; ++k) {
        double step[3], bend[3], after[3];
        column(k, 0, x[0]);
        for (int c = 0; c < 3; ++c) step[c] = x[0][c] - before[c];
        square += dot(step, step);
        if (k == points - 1) break;
        column(k + 1, 0, after);
        for (int c = 0; c < 3; ++c) bend[c] = step[c] - (after[c] - x[0][c]);
        for (int64_t term = 1; term < 6; ++term) column(k, term, x[term]);
        const int64_t u = 2 * (k - 1), v = u + 1;
        here.gradient[u] = factor * dot(x[1], bend), here.gradient[v] = factor * dot(x[2], bend);
        bands[u] = factor * dot(x[3], bend), bands[v] = factor * dot(x[5], bend);
        bands[n + u] = factor * dot(x[4], bend);
        here.metric[u] = dot(x[1], x[1]), here.metric[v] = dot(x[2], x[2]);
        here.metric[n + u] = dot(x[1], x[2]), here.metric[n + v] = 0.0;
        trace += here.metric[u] + here.metric[v];
        for (int64_t a = 0; a < 2 && k > 1; ++a)
            for (int64_t b = 0; b < 2; ++b)
                bands[(2 + a - b) * n + u - 2 + b] = -factor * dot(x[1 + a], last[b]);
        for (int c = 0; c < 3; ++c) before[c] = x[0][c], last[0][c] = x[1][c], last[1][c] = x[2][c];
    }
    for (int64_t i = 0; i < n; ++i) here.metric[i] += all.regularization * trace / double(n);
    for (double &each : here.metric) each *= 2.0 * factor;
    here.value = edges * square;
}

}  // namespace

// Move polygons (count, points, 2) of at least two edges to rest; their ends stay.
EXPORTED int64_t bodymeasure_descent(const Descent *all, double *polygons) {
    const int64_t points = all->points, n = 2 * (points - 2);
    const int64_t entries = (all->degree_u + 1) * (all->degree_v + 1) * COLUMNS;
    const std::vector<uint8_t> idle(n, 0);
    std::vector<double> trial(2 * points), jets(TERMS * points), damped(BANDS * n), step(n);
    std::vector<double> room(step_room(n, BANDS));
    Expansion here(n), there(n);
    for (int64_t number = 0; number < all->count; ++number, polygons += 2 * points) {
        const double *net = all->nets + number * entries;
        double damping = all->first_damping;
        expand(*all, net, polygons, jets.data(), here);
        trial.assign(polygons, polygons + 2 * points);
        for (int64_t steps = 0; steps < all->most_steps; ++steps) {
            damped = here.bands;
            for (int64_t i = 0; i < 2 * n; ++i) damped[i] += (1.0 + damping) * here.metric[i];
            const BoxModel model{n, BANDS, damped.data(), here.gradient.data(), polygons + 2, idle.data()};
            const bool definite = box_step(model, step.data(), room.data());
            const double decrease = definite ? box_decrease(model, step.data(), room.data()) : INFINITY;
            for (int64_t i = 0; i < n; ++i)
                trial[i + 2] = std::fmin(std::fmax(polygons[i + 2] + step[i], 0.0), 1.0);
            expand(*all, net, trial.data(), jets.data(), there);
            const bool better = there.value < here.value;
            damping *= better ? all->less : all->more;
            if (better) {
                std::swap(here, there);
                for (int64_t i = 2; i < n + 2; ++i) polygons[i] = trial[i];
            }
            if (decrease < all->rest * here.value || damping > all->most_damping) break;
        }
    }
    return all->count;
}

}  // namespace bodymeasure

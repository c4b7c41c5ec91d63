// The closest points of patches in powers of u and v; the NumPy form is
// `atlas.queries.closest.descend` with `bezier.power_form.jets`.
//
// Projected Newton after D. Bertsekas, SIAM J. Control Optim. 20 (1982) 221-246: a coordinate on its
// bound which the gradient presses outwards is held; the others take a Newton step (a Gauss-Newton
// step where the Hessian is not positive definite), which is projected, and halved if it led away.

#include <cmath>
#include <limits>

#include "kernels.h"

namespace bodymeasure {

// The constants of `atlas.queries.closest`.
struct ClosestSettings {
    int64_t most_steps;
    double last_step, longest_step, singular, damping, rounding;
};

namespace {

void newton_step(const double *s, const double *offset, const double *x,
                 const ClosestSettings &settings, double *step) {
    const double *s_v = s + 3, *s_vv = s + 6, *s_u = s + 9, *s_uv = s + 12, *s_uu = s + 18;
    const double e = dot(s_u, s_u), f = dot(s_u, s_v), g = dot(s_v, s_v);
    double a = e + dot(s_uu, offset), c = g + dot(s_vv, offset), b = f + dot(s_uv, offset);
    if (!(a > 0.0 && a * c - b * b > settings.singular * e * g)) {
        const double damping = settings.damping * (e + g) + std::numeric_limits<double>::min();
        a = e + damping;
        c = g + damping;
        b = f;
    }
    double p = -dot(s_u, offset), q = -dot(s_v, offset);
    const bool held_u = (x[0] <= 0.0 && p < 0.0) || (x[0] >= 1.0 && p > 0.0);
    const bool held_v = (x[1] <= 0.0 && q < 0.0) || (x[1] >= 1.0 && q > 0.0);
    if (held_u || held_v) b = 0.0;
    if (held_u) p = 0.0;
    if (held_v) q = 0.0;
    const double determinant = a * c - b * b;
    step[0] = (c * p - b * q) / determinant;
    step[1] = (a * q - b * p) / determinant;
    const double longest = std::fmax(std::fabs(step[0]), std::fabs(step[1]));
    if (longest > settings.longest_step)
        for (int k = 0; k < 2; ++k) step[k] *= settings.longest_step / longest;
}

double inside(double t) { return t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t; }

}  // namespace

double descend(int64_t side, const double *coefficients, const double *target, double *trial,
               const ClosestSettings &settings) {
    double jet[27], offset[3], x[2] = {trial[0], trial[1]}, step[2] = {0.0, 0.0};
    double value = std::numeric_limits<double>::infinity();
    const auto squared = [&]() {
        power_jet(side, 3, coefficients, trial, jet);
        for (int c = 0; c < 3; ++c) offset[c] = jet[c] - target[c];
        return dot(offset, offset);
    };
    for (int64_t number = 0; number < settings.most_steps; ++number) {
        const double now = squared();
        if (now <= value * (1.0 + settings.rounding)) {
            x[0] = trial[0];
            x[1] = trial[1];
            value = now;
            newton_step(jet, offset, x, settings, step);
        } else {
            step[0] *= 0.5;
            step[1] *= 0.5;
        }
        for (int k = 0; k < 2; ++k) trial[k] = inside(x[k] + step[k]);
        if (!(std::fmax(std::fabs(trial[0] - x[0]), std::fabs(trial[1] - x[1])) >
              settings.last_step))
            break;
    }
    // The last steps are too small to lead away.
    return squared();
}

}  // namespace bodymeasure

// Of patches (count, side, side, 3), to targets (count, 3), from parameters x (count, 2), which are
// moved there; `squared` are the squares of the distances.
EXPORTED int64_t bodymeasure_closest(int64_t count, int64_t side, const double *coefficients,
                                     const double *targets,
                                     const bodymeasure::ClosestSettings *settings, double *x,
                                     double *squared) {
    for (int64_t k = 0; k < count; ++k)
        squared[k] = bodymeasure::descend(side, coefficients + k * side * side * 3, targets + 3 * k,
                                          x + 2 * k, *settings);
    return count;
}

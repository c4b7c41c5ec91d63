// The closest points of patches in powers of u and v, and of those over their seams; the NumPy form
// is in `atlas.queries.feet`.
//
// Projected Newton after D. Bertsekas, SIAM J. Control Optim. 20 (1982) 221-246: a coordinate on its
// bound which the gradient presses outwards is held; the others take a Newton step (a Gauss-Newton
// step where the Hessian is not positive definite), which is projected, and halved if it led away.

#include <cmath>
#include <limits>

#include "kernels.h"

namespace bodymeasure {

// The constants of `atlas.queries.feet`; a search goes on over a seam where that leads closer by more
// than `tied`, in squares of distances.
struct ClosestSettings {
    int64_t most_steps, most_seams;
    double last_step, longest_step, singular, damping, rounding, tied;
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

// The sides of all patches, (patches, 4): the patch and the side beyond, -1 where there is none, and
// whether that side runs against this one.
struct Seams {
    const int64_t *to_patch, *to_side;
    const bool *flipped;
};

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

void cross(int64_t side, const double *coefficients, const Seams &seams, const double *target,
           const ClosestSettings &settings, int64_t *patch, double *x, double *squared) {
    const int64_t size = side * side * 3;
    for (int64_t number = 0; number < settings.most_seams; ++number) {
        double least = *squared - settings.tied, place[2] = {0.0, 0.0};
        int64_t found = -1;
        for (int64_t edge = 0; edge < 4; ++edge) {
            const int64_t over = seams.to_patch[4 * *patch + edge];
            if (over < 0 || x[edge / 2] != edge % 2) continue;
            const int64_t to_side = seams.to_side[4 * *patch + edge];
            const double along = x[1 - edge / 2];
            double there[2];
            there[to_side / 2] = to_side % 2;
            there[1 - to_side / 2] = seams.flipped[4 * *patch + edge] ? 1.0 - along : along;
            const double closer =
                descend(side, coefficients + over * size, target, there, settings);
            // At a corner two sides lead on.
            if (!(closer < least)) continue;
            least = closer;
            found = over;
            place[0] = there[0];
            place[1] = there[1];
        }
        if (found < 0) return;
        *patch = found;
        *squared = least;
        x[0] = place[0];
        x[1] = place[1];
    }
}

}  // namespace bodymeasure

// Of some of all patches (patches, side, side, 3), to targets (count, 3), from parameters x (count, 2),
// which are moved there, as are the patches (count,); `squared` are the squares of the distances.
EXPORTED int64_t bodymeasure_closest(int64_t count, int64_t side, const double *coefficients,
                                     const int64_t *to_patch, const int64_t *to_side,
                                     const bool *flipped, const double *targets,
                                     const bodymeasure::ClosestSettings *settings, int64_t *patch,
                                     double *x, double *squared) {
    const bodymeasure::Seams seams{to_patch, to_side, flipped};
    for (int64_t k = 0; k < count; ++k, targets += 3, x += 2) {
        squared[k] = bodymeasure::descend(side, coefficients + patch[k] * side * side * 3, targets,
                                          x, *settings);
        bodymeasure::cross(side, coefficients, seams, targets, *settings, patch + k, x,
                           squared + k);
    }
    return count;
}

// Unit normals of patches in powers of u and v, and how they bend; the NumPy form is
// `atlas.normals.normals_and_bends`.
//
// With the dual tangents d^i = g^ij S_j, the bend is -(d^i d^j) (n S_ij), minus the shape operator.
// The metric is that of unit tangents, which is well-conditioned unless they are parallel.

#include <cmath>

#include "kernels.h"

namespace bodymeasure {

// False beside a pole and where the tangents span no plane: there the normal is another one.
bool normal_and_bend(int64_t side, const double *coefficients, const double *x, double least_sine,
                     double least_ratio, double *position, double *normal, double *bend) {
    double jet[27], tangent[2][3], dual[2][3];
    power_jet(side, 3, coefficients, x, jet);
    const double *s_v = jet + 3, *s_vv = jet + 6, *s_u = jet + 9, *s_uv = jet + 12,
                 *s_uu = jet + 18;
    double cross[3];
    cross_product(s_u, s_v, cross);
    const double area = std::sqrt(dot(cross, cross));
    const double size_u = std::sqrt(dot(s_u, s_u)), size_v = std::sqrt(dot(s_v, s_v));
    const double longer = size_u > size_v ? size_u : size_v;
    const double shorter = size_u > size_v ? size_v : size_u;
    if (!(area >= least_sine * size_u * size_v && shorter >= least_ratio * longer && area > 0.0))
        return false;
    for (int c = 0; c < 3; ++c) {
        position[c] = jet[c];
        normal[c] = cross[c] / area;
        tangent[0][c] = s_u[c] / size_u;
        tangent[1][c] = s_v[c] / size_v;
    }
    const double cosine = dot(tangent[0], tangent[1]);
    const double e = dot(tangent[0], tangent[0]), g = dot(tangent[1], tangent[1]);
    const double determinant = e * g - cosine * cosine;
    for (int c = 0; c < 3; ++c) {
        dual[0][c] = (g * tangent[0][c] - cosine * tangent[1][c]) / determinant;
        dual[1][c] = (e * tangent[1][c] - cosine * tangent[0][c]) / determinant;
    }
    const double uu = dot(s_uu, normal) / (size_u * size_u);
    const double uv = dot(s_uv, normal) / (size_u * size_v);
    const double vv = dot(s_vv, normal) / (size_v * size_v);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            bend[3 * i + j] = -(dual[0][i] * (uu * dual[0][j] + uv * dual[1][j]) +
                                dual[1][i] * (uv * dual[0][j] + vv * dual[1][j]));
    return true;
}

}  // namespace bodymeasure

// Of patches (patches, side, side, 3), at parameters x (count, 2) of those with the numbers `patch`.
// Returns how many rows are left out, which `regular` tells.
EXPORTED int64_t bodymeasure_normals(int64_t count, int64_t side, const double *coefficients,
                                     const int64_t *patch, const double *x, const double *least,
                                     double *position, double *normal, double *bend,
                                     uint8_t *regular) {
    int64_t left = 0;
    for (int64_t k = 0; k < count; ++k) {
        regular[k] = bodymeasure::normal_and_bend(side, coefficients + patch[k] * side * side * 3,
                                                  x + 2 * k, least[0], least[1], position + 3 * k,
                                                  normal + 3 * k, bend + 9 * k);
        left += !regular[k];
    }
    return left;
}

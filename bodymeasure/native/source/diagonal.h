// Geodesics from corner to corner of bicubic patches, by collocation with one unknown function; the
// NumPy form is `geodesic.graph.solve` with `geodesic.lengths.jacobi`, where the formulas are
// derived. Names are those of the NumPy form.

#pragma once

#include <cstdint>

namespace bodymeasure {

// Patches of 4 x 4 points, each whole or restricted to the rectangle between its two points.
struct DiagonalProblems {
    int64_t count;
    const int64_t *rows;   // (count), the rows of the arrays below
    const double *nets;    // (rows, 4, 4, 3)
    const double *start;   // (rows, 2), in the parameters of the whole patches
    const double *end;
    // Whether the points are corners of whole patches: then a patch is turned where it begins at 1.
    int64_t are_corners;
};

// A trial space: its inner nodes, and the maps from offsets there.
struct DiagonalSpace {
    int64_t before, inner, points, modes, blocks, between;
    // The degrees at which the second, third and last quarters of Legendre coefficients begin.
    int64_t second, third, last;
    const double *times;               // (inner)
    const double *carry;               // (inner, before), from the nodes of the space before
    const double *first, *second_map;  // (inner, inner), to q' and q'' at the nodes
    // The quadrature, symmetric about the middle; its maps are (points, inner).
    const double *quadrature, *weights, *place, *slope, *bend;
    const double *gaps;  // (points - 1), one by the distances of the points
    // The first half of the modes and their slopes, (points / 2, modes): of even numbers they are
    // even and odd about the middle, of odd numbers the other way round.
    const double *values, *slopes;
    // Products of two slopes and of two values, four entries of the Galerkin system at a time:
    // (blocks, points / 2, 2, 4); whether a block's products are even; and the places of the entries
    // in the lower triangle, column by column, with one more place for what is unused.
    const double *products;
    const int64_t *is_even, *places;
    const double *coefficients;     // (points - second, points / 2), to Legendre coefficients
    const double *beside, *across;  // times between the nodes, (between), and (between, inner)
};

// Constants of `graph.ladder`, `lengths.jacobi`, `lengths.length` and `spaces.quadrature`.
struct DiagonalSettings {
    int64_t guess_steps, steps, twice_falls;
    double longest_step, small, most_offset, far_outside, tolerance, steep, rounding, noise;
    double safety, quadrature_safety, curvature_variation, path_rounding;
    double lyapunov, eigenvalue_rounding, trusted_correction, trusted_residual;
};

// What is found: the paths that are done, and the offsets of those that are left to another space.
// Each array has room for all problems, and is filled from its beginning.
struct DiagonalPaths {
    int64_t *problem;   // (done), the place of each path's problem in `rows`
    double *values;     // (done, 2, inner + 2), u and v at all nodes
    double *raw, *correction, *error, *residual, *reach, *chord;
    int64_t *index;
    uint8_t *trusted, *good;
    int64_t *left;      // (left), as `problem`
    double *offset;     // (left, inner)
    int64_t counts[2];  // done, left
};

}  // namespace bodymeasure

// Geodesics from corner to corner of bicubic patches, by collocation with one unknown function; the
// NumPy form is `geodesic.graph.solve` with `geodesic.lengths.jacobi`, where the formulas are
// derived. Names are those of the NumPy form.

#pragma once

#include <cstdint>

namespace bodymeasure {

// The entries of a block of the Galerkin system: as many sums as run beside one another without
// waiting for each other.
constexpr int BLOCK = 8;

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

// What lengths on a trial space are calculated from: a quadrature, symmetric about the middle.
struct LengthTables {
    int64_t size, points, modes, blocks;  // paths have size + 1 nodes
    // The degrees at which the second, third and last quarters of Legendre coefficients begin.
    int64_t second, third, last;
    const double *weights;
    // The maps from nodal values to values and two derivatives, (points, nodes); for diagonals,
    // whose offsets vanish at the ends, from inner nodes.
    const double *place, *slope, *bend;
    const double *gaps;  // (points - 1), one by the distances of the points
    // The first half of the modes and their slopes, (points / 2, modes): of even numbers they are
    // even and odd about the middle, of odd numbers the other way round.
    const double *values, *slopes;
    // Products of two slopes and, negative, of two values, for some entries of the Galerkin system at
    // a time: (blocks, points / 2, 2, BLOCK); whether a block's products are even; and the places of
    // the entries in the lower triangle, column by column, with one more place for what is unused.
    const double *products;
    const int64_t *is_even, *places;
    const double *coefficients;    // (points - second, points / 2), to Legendre coefficients
    const double *antiderivative;  // (points, points), where so few modes leave out too much
};

// A trial space for diagonals: its inner nodes, and the maps from offsets there.
struct DiagonalSpace : LengthTables {
    int64_t before, inner, between;
    const double *times;               // (inner)
    const double *carry;               // (inner, before), from the nodes of the space before
    const double *first, *second_map;  // (inner, inner), to q' and q'' at the nodes
    const double *quadrature;          // (points)
    const double *beside, *across;     // times between the nodes, (between), and (between, inner)
};

// Constants of `lengths.measure`, `lengths.jacobi`, `lengths.length` and `spaces.quadrature`.
struct LengthSettings {
    int64_t twice_falls;
    double steep, cancellation, noise, safety, quadrature_safety, curvature_variation;
    double path_rounding, lyapunov, eigenvalue_rounding, trusted_correction, trusted_residual;
};

// Constants of `graph.ladder`, too.
struct DiagonalSettings : LengthSettings {
    int64_t guess_steps, steps;
    double longest_step, small, most_offset, far_outside, tolerance, rounding;
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

// What lengths are found of paths.
struct Lengths {
    double *raw, *correction, *error, *residual;
    int64_t *index;
    uint8_t *trusted;
};

}  // namespace bodymeasure

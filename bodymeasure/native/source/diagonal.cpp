// Many geodesics from corner to corner at once: the functions for each kind of processor, and the
// choice among them. See `diagonal.h` and `diagonal_lanes.h`.

#include "diagonal.h"

#include <cmath>
#include <vector>

#include "kernels.h"

#if defined(__GNUC__)
#define INLINE __attribute__((always_inline)) static inline
// Vectors are passed only among functions that are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"
#else
#define INLINE static inline
#endif

namespace bodymeasure {

namespace {

#if defined(__GNUC__)
#define LANES 2
#else
#define LANES 1
#endif
namespace narrow {
#include "diagonal_lanes.h"
}
#undef LANES

#if defined(__GNUC__) && defined(__x86_64__)
#define HAS_WIDE 1
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define LANES 4
namespace wide {
#include "diagonal_lanes.h"
}
#undef LANES
#if defined(__clang__)
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,fma"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,fma")
#endif
#define LANES 8
namespace widest {
#include "diagonal_lanes.h"
}
#undef LANES
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

// The most lanes that the processor has, and at most so many as are asked for.
int lanes_for(int64_t most) {
#if defined(HAS_WIDE)
    if (most >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return 8;
    if (most >= 4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return 4;
#endif
    return 2;
}

}  // namespace

}  // namespace bodymeasure

// Solve problems on a trial space, in vectors of at most `lanes`; see `solve`. Returns the number
// of lanes that were taken.
EXPORTED int64_t bodymeasure_diagonals(const bodymeasure::DiagonalProblems *problems,
                                       const bodymeasure::DiagonalSpace *guess,
                                       const bodymeasure::DiagonalSpace *space,
                                       const bodymeasure::DiagonalSettings *settings,
                                       const double *before, bodymeasure::DiagonalPaths *paths,
                                       int64_t lanes) {
    paths->counts[0] = paths->counts[1] = 0;
    const int chosen = bodymeasure::lanes_for(lanes);
#if defined(HAS_WIDE)
    if (chosen == 8) bodymeasure::widest::solve(*problems, *guess, *space, *settings, before, *paths);
    if (chosen == 4) bodymeasure::wide::solve(*problems, *guess, *space, *settings, before, *paths);
#endif
    if (chosen == 2) bodymeasure::narrow::solve(*problems, *guess, *space, *settings, before, *paths);
    return chosen;
}

// Measure paths, one on each patch.
EXPORTED int64_t bodymeasure_lengths(const bodymeasure::Paths *paths, const double *values,
                                     const bodymeasure::LengthTables *space,
                                     const bodymeasure::LengthSettings *settings,
                                     const bodymeasure::Lengths *found, int64_t lanes) {
    const int chosen = bodymeasure::lanes_for(lanes);
#if defined(HAS_WIDE)
    if (chosen == 8) bodymeasure::widest::lengths(*paths, *space, *settings, values, *found);
    if (chosen == 4) bodymeasure::wide::lengths(*paths, *space, *settings, values, *found);
#endif
    if (chosen == 2) bodymeasure::narrow::lengths(*paths, *space, *settings, values, *found);
    return chosen;
}

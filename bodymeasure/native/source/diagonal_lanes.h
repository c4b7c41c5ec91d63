// The kernel of `diagonal.cpp` for vectors of LANES doubles: one problem a lane. It is included once
// for each kind of processor, within a namespace of its own.

#if LANES > 1
typedef double Lanes __attribute__((vector_size(8 * LANES), aligned(8 * LANES)));
typedef int64_t Mask __attribute__((vector_size(8 * LANES), aligned(8 * LANES)));
INLINE double lane(const Lanes &x, int i) { return x[i]; }
INLINE void put(Lanes &x, int i, double value) { x[i] = value; }
#else
typedef double Lanes;
INLINE double lane(const Lanes &x, int) { return x; }
INLINE void put(Lanes &x, int, double value) { x = value; }
#endif

INLINE Lanes all(double x) { return x - Lanes{}; }
INLINE Lanes size(Lanes x) { return x < all(0.0) ? -x : x; }
// The larger one; a NaN stays.
INLINE Lanes larger(Lanes a, Lanes b) { return (a >= b) | (a != a) ? a : b; }
INLINE Lanes root(Lanes x) {
    Lanes result = x;
    for (int i = 0; i < LANES; ++i) put(result, i, std::sqrt(lane(x, i)));
    return result;
}

// A point of space for each lane.
struct Point {
    Lanes c[3];
};
INLINE Lanes dot(const Point &a, const Point &b) {
    return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}
INLINE Point cross(const Point &p, const Point &q) {
    Point result;
    for (int c = 0; c < 3; ++c) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        result.c[c] = p.c[a] * q.c[b] - p.c[b] * q.c[a];
    }
    return result;
}

// The patches: [c][i][j] is the derivative of coordinate c, i times by u and j times by v, at the
// middle of the patch, where the terms of a Taylor polynomial are smallest.
struct Nets {
    Lanes middle[3][4][4];
    Point chord;
    Lanes start[2], end[2], way[2];
};

// The value at 1/2 and the derivatives there of a cubic Bezier polynomial.
INLINE void derivatives(Lanes a, Lanes b, Lanes c, Lanes d, Lanes *result, int stride) {
    const Lanes first = b - a, second = c - b, third = d - c;
    result[0] = 0.125 * ((a + d) + 3.0 * (b + c));
    result[stride] = 0.75 * ((first + third) + 2.0 * second);
    result[2 * stride] = 3.0 * (third - first);
    result[3 * stride] = 6.0 * ((third - second) - (second - first));
}

INLINE void load(const DiagonalProblems &problems, int64_t begin, Nets &nets) {
    Lanes place[3][4][4];
    for (int i = 0; i < LANES; ++i) {
        // Past the last problem the last one is solved again.
        const int64_t number = begin + i < problems.count ? begin + i : problems.count - 1;
        const int64_t row = problems.rows[number];
        const double *net = problems.nets + 48 * row, *start = problems.start + 2 * row;
        int turned[2];
        for (int axis = 0; axis < 2; ++axis) {
            put(nets.start[axis], i, start[axis]);
            put(nets.end[axis], i, problems.end[2 * row + axis]);
            turned[axis] = problems.are_corners && start[axis] == 1.0 ? 3 : 0;
        }
        const double *first = net + 3 * (4 * turned[0] + turned[1]);
        const double *last = net + 3 * (15 - 4 * turned[0] - turned[1]);
        for (int c = 0; c < 3; ++c) {
            // Only differences matter, and they have smaller rounding errors near the origin.
            const double middle = 0.5 * (first[c] + last[c]);
            for (int a = 0; a < 4; ++a)
                for (int b = 0; b < 4; ++b)
                    put(place[c][a][b], i,
                        net[3 * (4 * (a ^ turned[0]) + (b ^ turned[1])) + c] - middle);
        }
    }
    for (int axis = 0; axis < 2; ++axis) nets.way[axis] = nets.end[axis] - nets.start[axis];
    for (int c = 0; c < 3; ++c) {
        auto &p = place[c];
        nets.chord.c[c] = p[3][3] - p[0][0];
        for (auto &row : p) derivatives(row[0], row[1], row[2], row[3], row, 1);
        for (int j = 0; j < 4; ++j)
            derivatives(p[0][j], p[1][j], p[2][j], p[3][j], &nets.middle[c][0][j], 4);
    }
}

// Derivatives of T(t, q) = S(t + q, t - q): those that paths have, and those that only Newton's
// method needs.
struct Jet {
    Point t, q, tt, tq, qq, ttq, tqq, qqq;
};

INLINE void derive(const Nets &nets, Lanes time, Lanes offset, bool newton, Jet &jet) {
    const Lanes x = time + offset - 0.5, y = time - offset - 0.5;
    const Lanes x2 = x * (1.0 / 2.0), x3 = x * (1.0 / 3.0), y2 = y * (1.0 / 2.0), y3 = y * (1.0 / 3.0);
    for (int c = 0; c < 3; ++c) {
        // Derivatives by u in its middle: of S, S_v and S_vv.
        Lanes s[4], v[4], vv[4];
        for (int i = 0; i < 4; ++i) {
            const Lanes *d = nets.middle[c][i];
            s[i] = d[0] + y * (d[1] + y2 * (d[2] + y3 * d[3]));
            v[i] = d[1] + y * (d[2] + y2 * d[3]);
            vv[i] = d[2] + y * d[3];
        }
        const Lanes s_u = s[1] + x * (s[2] + x2 * s[3]), s_uu = s[2] + x * s[3];
        const Lanes s_v = v[0] + x * (v[1] + x2 * (v[2] + x3 * v[3]));
        const Lanes s_uv = v[1] + x * (v[2] + x2 * v[3]);
        const Lanes s_vv = vv[0] + x * (vv[1] + x2 * (vv[2] + x3 * vv[3]));
        jet.t.c[c] = s_u + s_v;
        jet.q.c[c] = s_u - s_v;
        jet.tt.c[c] = (s_uu + s_vv) + 2.0 * s_uv;
        jet.tq.c[c] = s_uu - s_vv;
        jet.qq.c[c] = (s_uu + s_vv) - 2.0 * s_uv;
        if (!newton) continue;
        const auto &d = nets.middle[c];
        const Lanes s_uuv = v[2] + x * v[3], s_uvv = vv[1] + x * (vv[2] + x2 * vv[3]);
        const Lanes s_vvv = d[0][3] + x * (d[1][3] + x2 * (d[2][3] + x3 * d[3][3]));
        jet.ttq.c[c] = (s[3] - s_vvv) + (s_uuv - s_uvv);
        jet.tqq.c[c] = (s[3] + s_vvv) - (s_uuv + s_uvv);
        jet.qqq.c[c] = (s[3] - s_vvv) - 3.0 * (s_uuv - s_uvv);
    }
}

// The left side F of the equation and its derivatives, as in `graph.equation.linearize`.
struct Row {
    Lanes left, by_offset, by_slope, by_bend;
};

INLINE void linearize(const Jet &x, Lanes slope, Lanes bend, Row &row) {
    // x', h, and their derivatives by q; that of h by q' is twice that of x' by q.
    Point velocity, ahead, h, h_q;
    for (int c = 0; c < 3; ++c) {
        velocity.c[c] = x.t.c[c] + x.q.c[c] * slope;
        ahead.c[c] = x.tq.c[c] + x.qq.c[c] * slope;
        h.c[c] = x.tt.c[c] + (2.0 * x.tq.c[c] + x.qq.c[c] * slope) * slope;
        h_q.c[c] = x.ttq.c[c] + (2.0 * x.tqq.c[c] + x.qqq.c[c] * slope) * slope;
    }
    const Point normal = cross(x.t, x.q), turn = cross(velocity, h);
    const Point one = cross(x.tq, x.q), other = cross(x.t, x.qq);
    const Point by_velocity = cross(h, normal), by_h = cross(normal, velocity);
    row.by_bend = dot(normal, normal);
    row.left = row.by_bend * bend + dot(turn, normal);
    row.by_offset = 2.0 * (dot(normal, one) + dot(normal, other)) * bend + dot(turn, one) +
                    dot(turn, other) + dot(ahead, by_velocity) + dot(h_q, by_h);
    row.by_slope = dot(x.q, by_velocity) + 2.0 * dot(ahead, by_h);
}

INLINE Lanes mapped(const double *row, const Lanes *x, int64_t count) {
    Lanes result = row[0] * x[0];
    for (int64_t k = 1; k < count; ++k) result += row[k] * x[k];
    return result;
}

// Newton's steps from offsets at the inner nodes. Returns the size of the last one. The room is for
// (inner + 1) inner vectors.
INLINE Lanes newton(const DiagonalSpace &space, int64_t n, int64_t steps, double longest_step,
                    const Nets &nets, Lanes *offset, Lanes *room) {
    const int64_t width = n + 1;
    Lanes largest{};
    for (int64_t step = 0; step < steps; ++step) {
        for (int64_t i = 0; i < n; ++i) {
            const double *first = space.first + i * n, *second = space.second_map + i * n;
            Jet jet;
            Row row;
            derive(nets, all(space.times[i]), offset[i], true, jet);
            linearize(jet, mapped(first, offset, n), mapped(second, offset, n), row);
            Lanes *line = room + i * width;
            for (int64_t k = 0; k < n; ++k) line[k] = row.by_slope * first[k] + row.by_bend * second[k];
            line[i] += row.by_offset;
            line[n] = -row.left;
        }
        // Elimination without pivoting: what would need it ends in numbers that are not finite.
        for (int64_t i = 0; i < n; ++i) {
            const Lanes *pivot = room + i * width, inverse = 1.0 / pivot[i];
            for (int64_t r = i + 1; r < n; ++r) {
                Lanes *line = room + r * width;
                const Lanes factor = line[i] * inverse;
                for (int64_t k = i + 1; k < width; ++k) line[k] -= factor * pivot[k];
            }
        }
        for (int64_t i = n - 1; i >= 0; --i) {
            Lanes *line = room + i * width, value = line[n];
            for (int64_t k = i + 1; k < n; ++k) value -= line[k] * room[k * width + n];
            line[n] = value / line[i];
        }
        largest = Lanes{};
        for (int64_t i = 0; i < n; ++i) largest = larger(largest, size(room[i * width + n]));
        const Lanes longest = all(longest_step);
        const Lanes part = largest > longest ? longest / largest : all(1.0);
        for (int64_t i = 0; i < n; ++i) offset[i] += part * room[i * width + n];
    }
    return largest;
}

// The geometry of paths at the points of the quadrature; each array has room for all points.
struct Along {
    Lanes *speed, *inverse, *kappa, *curvature;
};

INLINE void follow(const DiagonalSpace &space, const Nets &nets, const Lanes *offset,
                   const Along &along) {
    const int64_t n = space.inner;
    for (int64_t p = 0; p < space.points; ++p) {
        const Lanes slope = mapped(space.slope + p * n, offset, n);
        const Lanes bend = mapped(space.bend + p * n, offset, n);
        Jet x;
        derive(nets, all(space.quadrature[p]), mapped(space.place + p * n, offset, n), false, x);
        Point velocity, acceleration;
        for (int c = 0; c < 3; ++c) {
            velocity.c[c] = x.t.c[c] + x.q.c[c] * slope;
            acceleration.c[c] = x.tt.c[c] + (2.0 * x.tq.c[c] + x.qq.c[c] * slope) * slope +
                                x.q.c[c] * bend;
        }
        const Point normal = cross(x.t, x.q);
        const Lanes area = dot(normal, normal), square = dot(velocity, velocity);
        const Lanes bent = dot(cross(velocity, acceleration), normal);
        const Lanes twist = dot(x.tq, normal);
        along.speed[p] = root(square);
        along.inverse[p] = 1.0 / along.speed[p];
        along.kappa[p] = bent / (square * root(square * area));
        along.curvature[p] =
            (dot(x.tt, normal) * dot(x.qq, normal) - twist * twist) / (area * area);
    }
}

// Sums and differences of the values at points that lie opposite each other about the middle.
INLINE void halved(const Lanes *x, int64_t points, Lanes *even, Lanes *odd) {
    for (int64_t h = 0; h < points / 2; ++h) {
        even[h] = x[h] + x[points - 1 - h];
        odd[h] = x[h] - x[points - 1 - h];
    }
}

// The quadrature's estimate of its own error, as in `spaces.quadrature.Quadrature.error_estimate`.
INLINE Lanes quadrature_error(const LengthTables &space, const LengthSettings &settings,
                              const Lanes *speed, int64_t half, Lanes *even, Lanes *odd) {
    halved(speed, space.points, even, odd);
    Lanes before{}, middle{}, last{}, most{};
    for (int64_t degree = space.second; degree < space.points; ++degree) {
        const double *row = space.coefficients + (degree - space.second) * half;
        const Lanes one = size(mapped(row, degree % 2 ? odd : even, half));
        Lanes &part = degree < space.third ? before : degree < space.last ? middle : last;
        part = larger(part, one);
    }
    for (int64_t p = 0; p < space.points; ++p) most = larger(most, speed[p]);
    const Lanes fall = last / middle, average = root(last / before);
    Lanes slower = fall > average ? fall : average;
    slower = root(slower > all(1.0) ? all(1.0) : slower);
    Lanes excess = last;
    for (int64_t k = 0; k < settings.twice_falls; ++k) excess *= slower;
    return last <= settings.noise * double(space.points) * most ? all(0.0) : excess;
}

// The part of the correction that belongs to all modes that are left out, as in `lengths.jacobi`. The
// room is for `points` and for `modes` vectors.
INLINE Lanes beyond(const LengthTables &space, const Along &along, const Lanes &length, Lanes *turn,
                    Lanes *parts) {
    const int64_t points = space.points, modes = space.modes;
    Lanes mean{}, result{};
    for (int64_t p = 0; p < points; ++p) {
        const double *row = space.antiderivative + p * points;
        turn[p] = Lanes{};
        for (int64_t k = 0; k < points; ++k) turn[p] += row[k] * along.kappa[k] * along.speed[k];
        mean += space.weights[p] * along.speed[p] * turn[p];
    }
    for (int64_t p = 0; p < points; ++p) turn[p] = (turn[p] - mean / length) * along.speed[p];
    const auto slope = [&](int64_t p, int64_t k) {
        const bool is_first = p < points / 2;
        const double value = space.slopes[(is_first ? p : points - 1 - p) * modes + k];
        return is_first || k % 2 ? value : -value;
    };
    for (int64_t k = 0; k < modes; ++k) {
        parts[k] = Lanes{};
        for (int64_t p = 0; p < points; ++p) parts[k] += space.weights[p] * slope(p, k) * turn[p];
    }
    for (int64_t p = 0; p < points; ++p) {
        Lanes rest = turn[p];
        for (int64_t k = 0; k < modes; ++k) rest -= slope(p, k) * parts[k];
        result += 0.5 * space.weights[p] * rest * rest * along.inverse[p];
    }
    return result;
}

struct Measured {
    Lanes raw, correction, error, residual, index;
};

// Lengths, their correction and their error, as in `lengths.jacobi.length_and_error`. The room is
// for 12 half + modes (modes + 5) / 2 + 1 vectors.
INLINE void measure(const LengthTables &space, const LengthSettings &settings,
                    const Along &along, Lanes *room, int64_t half, int64_t modes,
                    Measured &result) {
    const int64_t points = 2 * half;
    Lanes *density = room, *stiff = density + points, *mass = stiff + points, *load = mass + points;
    Lanes *shift = load + points, *tilt = shift + points, *triangle = tilt + points;
    Lanes *solution = triangle + modes * (modes + 1) / 2 + 1;
    // Each of the four holds its even half, then its odd half.
    Lanes length{}, inverses{}, positive{}, turn{}, bend{}, change{};
    for (int64_t p = 0; p < points; ++p) density[p] = space.weights[p] * along.inverse[p];
    halved(density, points, stiff, stiff + half);
    for (int64_t p = 0; p < points; ++p) {
        const Lanes weighted = space.weights[p] * along.speed[p];
        length += weighted;
        inverses += density[p];
        density[p] = weighted * along.curvature[p];
        positive += density[p] > all(0.0) ? density[p] : all(0.0);
        turn = larger(turn, size(along.kappa[p]));
        bend = larger(bend, size(along.curvature[p]));
    }
    halved(density, points, mass, mass + half);
    for (int64_t p = 0; p < points; ++p)
        density[p] = space.weights[p] * along.speed[p] * along.kappa[p];
    halved(density, points, load, load + half);
    for (int64_t p = 0; p + 1 < points; ++p) {
        const Lanes apart = size(along.curvature[p + 1] - along.curvature[p]) * space.gaps[p];
        change = larger(change, apart * larger(along.inverse[p + 1], along.inverse[p]));
    }
    const Lanes variation = change + settings.curvature_variation * bend / length;
    // The Galerkin system.
    for (int64_t block = 0; block < space.blocks; ++block) {
        const double *product = space.products + block * half * 2 * BLOCK;
        const Lanes *s = stiff + (space.is_even[block] ? 0 : half);
        const Lanes *m = mass + (space.is_even[block] ? 0 : half);
        Lanes entries[BLOCK] = {};
        for (int64_t h = 0; h < half; ++h, product += 2 * BLOCK)
            for (int k = 0; k < BLOCK; ++k) {
                entries[k] += product[k] * s[h];
                entries[k] += product[BLOCK + k] * m[h];
            }
        for (int k = 0; k < BLOCK; ++k) triangle[space.places[BLOCK * block + k]] = entries[k];
    }
    Lanes *loads = solution + modes;
    for (int64_t k = 0; k < modes; ++k) {
        const Lanes *part = load + (k % 2 ? half : 0);
        Lanes whole = space.values[k] * part[0];
        for (int64_t h = 1; h < half; ++h) whole += space.values[h * modes + k] * part[h];
        loads[k] = solution[k] = whole;
    }
    // L D L', column by column; as many pivots are negative as eigenvalues are.
    Lanes negative{}, determinant = all(1.0);
    const Lanes unit = 1.0 / inverses;
    Lanes *column = triangle;
    for (int64_t j = 0; j < modes; ++j) {
        const int64_t below = modes - j;
        const Lanes pivot = column[0], inverse = 1.0 / pivot;
        negative += pivot < all(0.0) ? all(1.0) : all(0.0);
        determinant *= pivot * unit;
        Lanes *other = column + below;
        for (int64_t k = 1; k < below; ++k) {
            const Lanes factor = column[k] * inverse;
            for (int64_t r = k; r < below; ++r) other[r - k] -= factor * column[r];
            solution[j + k] -= factor * solution[j];
            other += below - k;
            // What the solution needs once more stands where it is not changed again.
            column[k] = factor;
        }
        solution[j] *= inverse;
        column += below;
    }
    for (int64_t j = modes - 1; j >= 0; --j) {
        column -= modes - j;
        for (int64_t k = 1; k < modes - j; ++k) solution[j] -= column[k] * solution[j + k];
    }
    Lanes correction{}, left_out{};
    for (int64_t k = 0; k < modes; ++k) {
        const Lanes part = 0.5 * loads[k] * solution[k];
        correction += part;
        if (k >= modes - 2) left_out += size(part);
    }
    if (space.antiderivative) left_out += beyond(space, along, length, density, loads);
    Lanes cubic{}, rest{}, farthest{};
    for (int64_t h = 0; h < half; ++h) {
        Lanes value[2] = {}, slope[2] = {};
        for (int64_t k = 0; k < modes; ++k) {
            value[k % 2] += space.values[h * modes + k] * solution[k];
            slope[k % 2] += space.slopes[h * modes + k] * solution[k];
        }
        shift[h] = value[0] + value[1], shift[points - 1 - h] = value[0] - value[1];
        tilt[h] = slope[1] + slope[0], tilt[points - 1 - h] = slope[1] - slope[0];
    }
    for (int64_t p = 0; p < points; ++p) {
        const Lanes weighted = space.weights[p] * along.speed[p], away = size(shift[p]);
        const Lanes slope = tilt[p] * along.inverse[p], steep = slope * slope;
        const Lanes square = shift[p] * shift[p], bent = along.curvature[p] * square;
        farthest = larger(farthest, away);
        cubic += away * square * weighted;
        rest += (size(along.kappa[p]) * away * steep * 0.5 + steep * steep * 0.125 + bent * bent) *
                weighted;
    }
    left_out += cubic * variation * (1.0 / 6.0) + rest;
    left_out += settings.quadrature_safety *
                quadrature_error(space, settings, along.speed, half, density, density + half);
    const Lanes error = settings.safety * left_out +
                        settings.path_rounding * (10.0 + double(space.size)) * length;
    const Lanes infinite = all(INFINITY);
    const auto known = size(error) < infinite;
    constexpr double PI = 3.14159265358979323846;
    const Lanes uncertainty = variation * farthest * length * length * (1.0 / (PI * PI));
    const auto clear = size(determinant) > uncertainty + settings.eigenvalue_rounding;
    const Lanes counted = clear ? negative : all(-1.0);
    const Lanes index = positive * length < all(settings.lyapunov) ? all(0.0) : counted;
    result.raw = length;
    result.correction = correction;
    result.error = known ? error : infinite;
    result.residual = turn * length;
    result.index = known ? index : all(-1.0);
}

// How far paths go outside [0, 1], in u or v; less than 0 inside.
INLINE Lanes reach(const DiagonalSpace &space, const Nets &nets, const Lanes *offset) {
    Lanes low[2] = {all(0.0), all(0.0)}, high[2] = {all(1.0), all(1.0)};
    for (int64_t p = 0; p < space.between; ++p) {
        const Lanes q = mapped(space.across + p * space.inner, offset, space.inner);
        for (int axis = 0; axis < 2; ++axis) {
            const Lanes x = axis ? space.beside[p] - q : space.beside[p] + q;
            low[axis] = x < low[axis] ? x : low[axis];
            high[axis] = x > high[axis] ? x : high[axis];
        }
    }
    Lanes result = all(-1.0);
    for (int axis = 0; axis < 2; ++axis)
        for (const Lanes &x : {low[axis], high[axis]}) {
            const Lanes there = nets.start[axis] + nets.way[axis] * x;
            result = larger(result, larger(-there, there - 1.0));
        }
    return result;
}

INLINE void leave(const Lanes *offset, int64_t inner, int i, int64_t problem, DiagonalPaths &paths) {
    const int64_t row = paths.counts[1]++;
    paths.left[row] = problem;
    for (int64_t k = 0; k < inner; ++k) paths.offset[row * inner + k] = lane(offset[k], i);
}

// A path is done where Newton's method came to rest, and its length is good, or it runs far outside.
INLINE void write(const DiagonalSpace &space, const DiagonalSettings &settings, const Nets &nets,
                  const Lanes *offset, const Lanes &last_step, const Measured &measured, Lanes *room,
                  int64_t begin, int count, DiagonalPaths &paths) {
    const int64_t n = space.inner, nodes = 2 * (n + 2);
    Lanes way{}, most{};
    for (int axis = 0; axis < 2; ++axis) {
        Lanes *line = room + axis * (n + 2);
        line[0] = nets.start[axis];
        line[n + 1] = nets.end[axis];
        for (int64_t k = 0; k < n; ++k) {
            const Lanes x = axis ? space.times[k] - offset[k] : space.times[k] + offset[k];
            line[k + 1] = nets.start[axis] + nets.way[axis] * x;
        }
        for (int64_t k = 0; k <= n; ++k) way += size(line[k + 1] - line[k]);
    }
    for (int64_t k = 0; k < n; ++k) most = larger(most, size(offset[k]));
    const Lanes chord = root(dot(nets.chord, nets.chord)), out = reach(space, nets, offset);
    for (int i = 0; i < count; ++i) {
        const double raw = lane(measured.raw, i), correction = lane(measured.correction, i);
        const double error = lane(measured.error, i) + settings.rounding, residual = lane(measured.residual, i);
        // The correction is of leading order; and steep lengths need differences of neighboring
        // points first, which this form does not take.
        const bool trusted = std::fabs(correction) <= settings.trusted_correction * raw &&
                             residual <= settings.trusted_residual;
        const bool good = trusted && error <= settings.tolerance * raw &&
                          !(raw < settings.steep * lane(way, i));
        const bool at_rest = lane(last_step, i) < settings.small;
        if (!(at_rest && (good || lane(out, i) > settings.far_outside))) {
            if (lane(most, i) < settings.most_offset) leave(offset, n, i, begin + i, paths);
            continue;
        }
        const int64_t row = paths.counts[0]++;
        paths.problem[row] = begin + i;
        for (int64_t k = 0; k < nodes; ++k) paths.values[row * nodes + k] = lane(room[k], i);
        paths.raw[row] = raw, paths.correction[row] = correction;
        paths.error[row] = error, paths.residual[row] = residual;
        paths.index[row] = int64_t(lane(measured.index, i));
        paths.reach[row] = lane(out, i), paths.chord[row] = lane(chord, i);
        paths.trusted[row] = trusted, paths.good[row] = good;
    }
}

// Solve all problems, from offsets at the nodes of the space before, (count, before); where there
// are none, from Newton's steps on that space, which begin on the straight line.
static void solve(const DiagonalProblems &problems, const DiagonalSpace &guess,
                  const DiagonalSpace &space, const DiagonalSettings &settings, const double *before,
                  DiagonalPaths &paths) {
    const int64_t n = space.inner, points = space.points, modes = space.modes;
    const int64_t side = n > space.before ? n : space.before;
    const int64_t system = (side + 1) * side, values = 2 * (n + 2);
    const int64_t jacobi = 6 * points + modes * (modes + 5) / 2 + 1;
    const int64_t most = jacobi > system ? jacobi : system;
    const int64_t vectors = n + space.before + 4 * points + (most > values ? most : values);
    std::vector<double> whole((vectors + 1) * LANES);
    const uintptr_t align = sizeof(Lanes), place = reinterpret_cast<uintptr_t>(whole.data());
    Lanes *offset = reinterpret_cast<Lanes *>((place + align - 1) / align * align);
    Lanes *old = offset + n, *speed = old + space.before;
    const Along along{speed, speed + points, speed + 2 * points, speed + 3 * points};
    Lanes *room = speed + 4 * points;
    Nets nets;
    for (int64_t begin = 0; begin < problems.count; begin += LANES) {
        const int64_t rest = problems.count - begin;
        const int count = rest < LANES ? int(rest) : LANES;
        load(problems, begin, nets);
        const double longest = settings.longest_step;
        for (int64_t k = 0; k < space.before; ++k) {
            old[k] = Lanes{};
            for (int i = 0; i < LANES && before; ++i)
                put(old[k], i, before[(begin + (i < count ? i : count - 1)) * space.before + k]);
        }
        if (!before) newton(guess, guess.inner, settings.guess_steps, longest, nets, old, room);
        for (int64_t i = 0; i < n; ++i)
            offset[i] = mapped(space.carry + i * space.before, old, space.before);
        // Most problems are solved on 8 functions: there the compiler knows how long the loops are.
        const Lanes step = n == 7 ? newton(space, 7, settings.steps, longest, nets, offset, room)
                                  : newton(space, n, settings.steps, longest, nets, offset, room);
        follow(space, nets, offset, along);
        Measured measured;
        if (points == 24 && modes == 16)
            measure(space, settings, along, room, 12, 16, measured);
        else
            measure(space, settings, along, room, points / 2, modes, measured);
        write(space, settings, nets, offset, step, measured, room, begin, count, paths);
    }
}

// The lengths of paths on patches of any degree, as in `lengths.measure`.
static void lengths(const Paths &paths, const LengthTables &space, const LengthSettings &settings,
                    const double *values, const Lengths &found) {
    const int64_t points = space.points, modes = space.modes, nodes = paths.nodes;
    std::vector<double> whole((10 * points + modes * (modes + 5) / 2 + 2) * LANES);
    const uintptr_t align = sizeof(Lanes), place = reinterpret_cast<uintptr_t>(whole.data());
    Lanes *speed = reinterpret_cast<Lanes *>((place + align - 1) / align * align);
    const Along along{speed, speed + points, speed + 2 * points, speed + 3 * points};
    std::vector<double> room(path_room(paths));
    for (int64_t begin = 0; begin < paths.count; begin += LANES) {
        const int64_t rest = paths.count - begin;
        // Lanes past the last path keep what they hold.
        const int count = rest < LANES ? int(rest) : LANES;
        for (int i = 0; i < count; ++i)
            path_geometry(paths, space.bend, begin + i, values + 2 * nodes * (begin + i),
                          reinterpret_cast<double *>(speed) + i, LANES, room.data());
        Measured measured;
        if (points == 24 && modes == 16)
            measure(space, settings, along, speed + 4 * points, 12, 16, measured);
        else
            measure(space, settings, along, speed + 4 * points, points / 2, modes, measured);
        for (int i = 0; i < count; ++i) {
            const int64_t number = begin + i;
            const double *u = values + 2 * nodes * number, raw = lane(measured.raw, i);
            const double correction = lane(measured.correction, i);
            double way = 0.0;
            for (int64_t k = 1; k < 2 * nodes; ++k)
                if (k != nodes) way += std::fabs(u[k] - u[k - 1]);
            found.raw[number] = raw, found.correction[number] = correction;
            found.residual[number] = lane(measured.residual, i);
            found.error[number] = lane(measured.error, i);
            if (raw < settings.steep * way)
                found.error[number] +=
                    settings.cancellation * path_terms(paths, space.bend, number, u, room.data());
            found.index[number] = int64_t(lane(measured.index, i));
            found.trusted[number] = std::fabs(correction) <= settings.trusted_correction * raw &&
                                    found.residual[number] <= settings.trusted_residual;
        }
    }
}

// A strip of triangles unfolded into a plane, and the shortest path within it; the Python form is
// `routes.strips`.
//
// The path is found by a funnel (D. T. Lee, F. P. Preparata, Networks 14 (1984)). Places in the
// plane are complex numbers.

#include <complex>

#include "kernels.h"

namespace bodymeasure {

using Place = std::complex<double>;

// A triangle mesh: (faces, 3) vertices, and for each side where the third corner is if the side is
// the line from 0 to 1.
struct Triangles {
    const int64_t *faces;
    const Place *apex;
};

// A strip, and what is found; `count` faces, between which there are count - 1 sides.
struct Strip {
    int64_t count;
    const int64_t *strip;
    double scale;  // the length of the first side of the first face
    const double *start_weights, *end_weights;
    int64_t *sides, *names;  // (count - 1,) and (count - 1, 2): the vertices to the left and right
    Place *left, *right, *ends;
    int64_t *bends;  // (2 * count, 2)
};

namespace {

double cross(Place a, Place b) { return a.real() * b.imag() - a.imag() * b.real(); }

int side_of(const int64_t *corners, int64_t first, int64_t second) {
    for (int side = 0; side < 3; ++side) {
        const int64_t a = corners[side], b = corners[(side + 1) % 3];
        if ((a == first && b == second) || (a == second && b == first)) return side;
    }
    return -1;
}

int shared_side(const int64_t *corners, const int64_t *beyond) {
    for (int side = 0; side < 3; ++side)
        if (side_of(beyond, corners[side], corners[(side + 1) % 3]) >= 0) return side;
    return -1;
}

Place weighted(const double *weights, const Place *places) {
    return weights[0] * places[0] + weights[1] * places[1] + weights[2] * places[2];
}

// Fill the sides, the vertices and their places; false if two faces in a row share no side.
bool unfold(const Triangles &mesh, const Strip &strip) {
    const int64_t first = strip.strip[0];
    // The places of the corners of the face at hand.
    Place places[3] = {0.0, strip.scale, strip.scale * mesh.apex[3 * first]};
    strip.ends[0] = weighted(strip.start_weights, places);
    for (int64_t number = 0; number + 1 < strip.count; ++number) {
        const int64_t *corners = mesh.faces + 3 * strip.strip[number];
        const int64_t next = strip.strip[number + 1], *beyond = mesh.faces + 3 * next;
        const int side = shared_side(corners, beyond);
        if (side < 0) return false;
        const int after = (side + 1) % 3, third = (side + 2) % 3;
        int one = side, other = after;
        // The third corner lies behind: to the right of the line from the left to the right.
        if (cross(places[after] - places[side], places[third] - places[side]) >= 0.0) {
            one = after;
            other = side;
        }
        const int64_t left = corners[one], right = corners[other];
        const Place a = places[one], b = places[other];
        strip.sides[number] = side;
        strip.names[2 * number] = left;
        strip.names[2 * number + 1] = right;
        strip.left[number] = a;
        strip.right[number] = b;
        int entered = 0;
        while (beyond[entered] != left) ++entered;
        const int following = (entered + 1) % 3, before = (entered + 2) % 3;
        Place now[3];
        now[entered] = a;
        if (beyond[following] == right) {
            now[following] = b;
            now[before] = a + (b - a) * mesh.apex[3 * next + entered];
        } else {
            // The side runs the other way in this face.
            now[before] = b;
            now[following] = a + (b - a) * (1.0 - std::conj(mesh.apex[3 * next + before]));
        }
        for (int k = 0; k < 3; ++k) places[k] = now[k];
    }
    strip.ends[1] = weighted(strip.end_weights, places);
    return true;
}

// Fill the bends of the shortest path: the number of the side, and 0 for left or 1 for right.
int64_t funnel(const Strip &strip) {
    const int64_t count = strip.count - 1;
    int64_t found = 0, number = 0, ats[2] = {-1, -1};
    Place tip = strip.ends[0], sides[2] = {tip, tip};
    while (number <= count && found < 2 * strip.count) {
        const Place both[2] = {number < count ? strip.left[number] : strip.ends[1],
                               number < count ? strip.right[number] : strip.ends[1]};
        for (int which = 0; which < 2; ++which) {
            const double sign = which ? 1.0 : -1.0;
            const Place turn = both[which] - tip;
            // The funnel only gets narrower. A side on which the tip itself is does not limit it.
            if (sides[which] != tip && sign * cross(sides[which] - tip, turn) < 0.0) continue;
            const Place far = sides[1 - which];
            const bool inside = sign * cross(far - tip, turn) < 0.0;
            if (inside || tip == both[which] || tip == far || both[which] == far) {
                sides[which] = both[which];
                ats[which] = number;
                continue;
            }
            // It closes: the path bends about the other side's corner.
            tip = far;
            number = ats[1 - which];
            strip.bends[2 * found] = number;
            strip.bends[2 * found + 1] = 1 - which;
            ++found;
            sides[0] = sides[1] = tip;
            ats[0] = ats[1] = number;
            break;
        }
        ++number;
    }
    return found;
}

}  // namespace

}  // namespace bodymeasure

// Returns the number of bends; -1 if two faces in a row share no side.
EXPORTED int64_t bodymeasure_unfold(const bodymeasure::Triangles *mesh,
                                    const bodymeasure::Strip *strip) {
    return bodymeasure::unfold(*mesh, *strip) ? bodymeasure::funnel(*strip) : -1;
}

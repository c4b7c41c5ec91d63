// Ways over a triangle mesh pulled straight; the Python form, with its sources, is `routes.strips`.
//
// A way along edges becomes a strip of faces. It is unfolded into a plane, whose places are complex
// numbers, and a funnel finds the shortest path within it. Where that bends about a vertex, and the
// angle on the other side is less than pi, the strip is led round that side, for as long as that
// makes the path shorter.

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

using Numbers = std::vector<int64_t>;

namespace {

constexpr int MOST_ROUNDS = 60;
constexpr double STRAIGHT = 1e-9, SHORTER = 1e-12, PI = 3.141592653589793;

struct Bend {
    int64_t number;
    int side;  // 0 for left, 1 for right
};

struct Strip {
    Numbers faces;
    double weights[2][3];
};

struct Unfolded {
    Place ends[2];
    std::vector<int> sides;
    Numbers names[2];  // the vertices to the left and to the right, and their places
    std::vector<Place> places[2];
    std::vector<Bend> bends;
    double length;

    void clear() {
        sides.clear(), bends.clear();
        for (int k = 0; k < 2; ++k) names[k].clear(), places[k].clear();
    }

    Place stop(size_t number) const {
        if (number == 0) return ends[0];
        if (number > bends.size()) return ends[1];
        return places[bends[number - 1].side][bends[number - 1].number];
    }
};

double cross(Place a, Place b) { return a.real() * b.imag() - a.imag() * b.real(); }

bool has(const int64_t *corners, int64_t vertex) {
    return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

int shared_side(const int64_t *corners, const int64_t *beyond) {
    for (int side = 0; side < 3; ++side)
        if (has(beyond, corners[side]) && has(beyond, corners[(side + 1) % 3])) return side;
    return -1;
}

// Append the fewest faces about a vertex from the last of a strip to the face `last`, or to one with
// the vertex `to` if that is not -1; false if no such face is joined to it.
bool turn(const Triangles &mesh, int64_t vertex, int64_t last, int64_t to, Numbers &strip) {
    Numbers queue{strip.back()}, before{-1};
    for (size_t at = 0; at < queue.size(); ++at) {
        const int64_t here = queue[at], *corners = mesh.faces + 3 * here;
        if (to < 0 ? here == last : has(corners, to)) {
            Numbers way;
            for (int64_t k = at; before[k] >= 0; k = before[k]) way.push_back(queue[k]);
            strip.insert(strip.end(), way.rbegin(), way.rend());
            return true;
        }
        for (int side = 0; side < 3; ++side) {
            const int64_t there = mesh.over[3 * here + side];
            if (there < 0 || (corners[side] != vertex && corners[(side + 1) % 3] != vertex)) continue;
            if (std::find(queue.begin(), queue.end(), there) != queue.end()) continue;
            queue.push_back(there);
            before.push_back(at);
        }
    }
    return false;
}

// Leave out faces that the strip only enters and leaves by the same side.
Numbers without_returns(const Numbers &strip) {
    Numbers result;
    for (const int64_t face : strip) {
        const size_t count = result.size();
        if (count > 0 && result[count - 1] == face) continue;
        if (count > 1 && result[count - 2] == face)
            result.pop_back();
        else
            result.push_back(face);
    }
    return result;
}

// Put a point on the next face, if it lies exactly on the side between both.
bool put_on(const int64_t *corners, const int64_t *beyond, double *weights) {
    double there[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        const int64_t *at = std::find(beyond, beyond + 3, corners[k]);
        if (at != beyond + 3)
            there[at - beyond] = weights[k];
        else if (weights[k] != 0.0)
            return false;
    }
    std::copy(there, there + 3, weights);
    return true;
}

// Leave out faces of which the path only has a point.
void trim(const Triangles &mesh, Strip &strip) {
    const auto corners = [&](int64_t number) { return mesh.faces + 3 * strip.faces[number]; };
    int64_t first = 0, last = strip.faces.size() - 1;
    while (first < last && put_on(corners(first), corners(first + 1), strip.weights[0])) ++first;
    while (first < last && put_on(corners(last), corners(last - 1), strip.weights[1])) --last;
    strip.faces = Numbers(strip.faces.begin() + first, strip.faces.begin() + last + 1);
}

// Find where the shortest path bends.
void pull(Unfolded &way) {
    const int64_t count = way.sides.size();
    int64_t number = 0, ats[2] = {-1, -1};
    Place tip = way.ends[0], sides[2] = {tip, tip};
    for (; number <= count && way.bends.size() < size_t(2 * count + 2); ++number) {
        for (int which = 0; which < 2; ++which) {
            const Place now = number < count ? way.places[which][number] : way.ends[1];
            const double sign = which ? 1.0 : -1.0;
            // The funnel only gets narrower. A side on which the tip itself is does not limit it.
            if (sides[which] != tip && sign * cross(sides[which] - tip, now - tip) < 0.0) continue;
            const Place far = sides[1 - which];
            if (sign * cross(far - tip, now - tip) < 0.0 || tip == now || tip == far || now == far) {
                sides[which] = now;
                ats[which] = number;
                continue;
            }
            // It closes: the path bends about the other side's corner.
            tip = far;
            number = ats[1 - which];
            way.bends.push_back({number, 1 - which});
            sides[0] = sides[1] = tip;
            ats[0] = ats[1] = number;
            break;
        }
    }
    way.length = 0.0;
    for (size_t k = 0; k <= way.bends.size(); ++k) way.length += std::abs(way.stop(k + 1) - way.stop(k));
}

// False if two faces in a row share no side, or the places of a corner or an end are not finite: those
// compare with nothing, so that a funnel among them may close on what is no corner.
bool unfold(const Triangles &mesh, const Strip &strip, Unfolded &way) {
    const auto weighted = [](const double *weights, const Place *places) {
        return weights[0] * places[0] + weights[1] * places[1] + weights[2] * places[2];
    };
    const int64_t first = strip.faces[0];
    const double *a = mesh.vertices + 3 * mesh.faces[3 * first];
    const double *b = mesh.vertices + 3 * mesh.faces[3 * first + 1];
    const double scale = std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) +
                                   (b[2] - a[2]) * (b[2] - a[2]));
    // The places of the corners of the face at hand.
    Place places[3] = {0.0, scale, scale * mesh.apex[3 * first]};
    way.clear();
    way.ends[0] = weighted(strip.weights[0], places);
    for (size_t number = 0; number + 1 < strip.faces.size(); ++number) {
        const int64_t *corners = mesh.faces + 3 * strip.faces[number];
        const int64_t next = strip.faces[number + 1], *beyond = mesh.faces + 3 * next;
        const int side = shared_side(corners, beyond);
        if (side < 0) return false;
        const int after = (side + 1) % 3, third = (side + 2) % 3;
        int ends[2] = {side, after};
        // The third corner lies behind: to the right of the line from the left to the right.
        if (cross(places[after] - places[side], places[third] - places[side]) >= 0.0)
            std::swap(ends[0], ends[1]);
        way.sides.push_back(side);
        for (int k = 0; k < 2; ++k) {
            way.names[k].push_back(corners[ends[k]]);
            way.places[k].push_back(places[ends[k]]);
        }
        const Place left = places[ends[0]], right = places[ends[1]];
        const int entered = std::find(beyond, beyond + 3, corners[ends[0]]) - beyond;
        const int following = (entered + 1) % 3, before = (entered + 2) % 3;
        places[entered] = left;
        if (beyond[following] == corners[ends[1]]) {
            places[following] = right;
            places[before] = left + (right - left) * mesh.apex[3 * next + entered];
        } else {
            // The side runs the other way in this face.
            places[before] = right;
            places[following] = left + (right - left) * (1.0 - std::conj(mesh.apex[3 * next + before]));
        }
    }
    way.ends[1] = weighted(strip.weights[1], places);
    Place nothing = 0.0 * (way.ends[0] + way.ends[1]);
    for (const std::vector<Place> &side : way.places)
        for (const Place place : side) nothing += 0.0 * place;
    if (nothing != 0.0) return false;
    pull(way);
    return true;
}

// The faces about a vertex from the first of some to the last, round the other way; empty if they do
// not hang together there.
Numbers other_side(const Triangles &mesh, int64_t vertex, const int64_t *faces, int64_t count) {
    Numbers result{faces[0]};
    int came = shared_side(mesh.faces + 3 * faces[0], mesh.faces + 3 * faces[1]);
    while (result.back() != faces[count - 1] || result.size() == 1) {
        const int64_t here = result.back(), *corners = mesh.faces + 3 * here;
        int side = 0;
        while (side < 3 && (side == came ||
                            (corners[side] != vertex && corners[(side + 1) % 3] != vertex)))
            ++side;
        const int64_t there = side < 3 ? mesh.over[3 * here + side] : -1;
        if (there < 0 || result.size() > MOST_ROUNDS) return {};
        const int64_t *back = mesh.over + 3 * there;
        if (std::count(back, back + 3, here) != 1) return {};
        came = std::find(back, back + 3, here) - back;
        result.push_back(there);
    }
    return result;
}

// Lead the strip round the other side of vertices where that is shorter; false if it is nowhere.
bool lead_round(const Triangles &mesh, const Unfolded &way, Numbers &strip) {
    Numbers result;
    int64_t done = 0;
    for (size_t number = 0; number < way.bends.size(); ++number) {
        const Numbers &names = way.names[way.bends[number].side];
        int64_t first = way.bends[number].number, last = first;
        const int64_t vertex = names[first];
        while (first > 0 && names[first - 1] == vertex) --first;
        while (last + 1 < int64_t(names.size()) && names[last + 1] == vertex) ++last;
        if (first < done) continue;
        const Place before = way.stop(number), there = way.stop(number + 1), after = way.stop(number + 2);
        // An end may lie in the vertex.
        if (there == before || there == after) continue;
        const double bend = std::fabs(std::arg((before - there) * std::conj(after - there)));
        // The path bends towards the strip's outside, whose angle is what the strip leaves of all.
        if (!(mesh.angle[vertex] - (2.0 * PI - bend) < PI - STRAIGHT)) continue;
        const Numbers round = other_side(mesh, vertex, &strip[first], last + 2 - first);
        if (round.empty()) continue;
        result.insert(result.end(), strip.begin() + done, strip.begin() + first);
        result.insert(result.end(), round.begin(), round.end());
        done = last + 2;
    }
    if (!done) return false;
    result.insert(result.end(), strip.begin() + done, strip.end());
    strip = without_returns(result);
    return true;
}

// Where the path crosses the sides: 0 at their first corner, 1 at their second.
void fill_along(const Triangles &mesh, const Strip &strip, const Unfolded &found, double *along) {
    size_t leg = 0;
    for (int64_t number = 0; number < int64_t(found.sides.size()); ++number) {
        const auto bend = [&]() {
            return leg < found.bends.size() ? found.bends[leg].number : int64_t(found.sides.size());
        };
        while (number > bend()) ++leg;
        const Place a = found.places[0][number], b = found.places[1][number];
        const Place p = found.stop(leg), q = found.stop(leg + 1);
        double t = q == b;
        // A path along a side is on it everywhere: it may count as crossing at either corner.
        if (p == a || p == b) {
            t = p == b;
        } else if (number != bend()) {
            const double across = cross(q - p, b - a);
            t = across != 0.0 ? -cross(q - p, a - p) / across : 0.0;
            t = std::min(std::max(t, 0.0), 1.0);
        }
        const int64_t corner = mesh.faces[3 * strip.faces[number] + found.sides[number]];
        along[number] = corner == found.names[0][number] ? t : 1.0 - t;
    }
}

}  // namespace

int64_t straighten(const Triangles &mesh, Way &way) {
    Numbers faces{way.faces[0]};
    for (int64_t k = 0; k < way.count; ++k) {
        const int64_t to = k + 1 < way.count ? way.vertices[k + 1] : -1;
        if (!turn(mesh, way.vertices[k], way.faces[1], to, faces)) return NO_WAY;
    }
    Strip strip{without_returns(faces), {}};
    std::copy(&way.weights[0][0], &way.weights[0][0] + 6, &strip.weights[0][0]);
    trim(mesh, strip);
    Unfolded found, other;
    if (!unfold(mesh, strip, found)) return UNKNOWN_WAY;
    for (int round = 0; round < MOST_ROUNDS; ++round) {
        Strip shorter = strip;
        if (!lead_round(mesh, found, shorter.faces)) break;
        trim(mesh, shorter);
        if (!unfold(mesh, shorter, other)) return UNKNOWN_WAY;
        if (other.length > found.length * (1.0 - SHORTER)) break;
        std::swap(strip, shorter);
        std::swap(found, other);
    }
    const int64_t count = strip.faces.size();
    if (count > way.most) return UNKNOWN_WAY;
    std::copy(strip.faces.begin(), strip.faces.end(), way.strip);
    std::copy(found.sides.begin(), found.sides.end(), way.sides);
    std::copy(&strip.weights[0][0], &strip.weights[0][0] + 6, &way.weights[0][0]);
    fill_along(mesh, strip, found, way.along);
    way.length = found.length;
    return count;
}

}  // namespace bodymeasure

// Returns the number of faces of the strip; -1 if the faces about a vertex do not hang together, and
// -2 if there is no room for the strip, two of its faces share no side, or its places are not finite.
EXPORTED int64_t bodymeasure_straight_way(const bodymeasure::Triangles *mesh, bodymeasure::Way *way) {
    return bodymeasure::straighten(*mesh, *way);
}

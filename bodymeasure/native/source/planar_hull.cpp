// The corners of the convex hull of points in a plane; its other form is Qhull, by SciPy.
//
// A. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Inf. Process. Lett. 9
// (1979) 216-219: the points in order, from left to right below and back above, less those at which
// the way does not turn to the left.

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernels.h"

// Of `count` points (x, y), the numbers of the corners counterclockwise; returns how many they are.
EXPORTED int64_t bodymeasure_planar_hull(int64_t count, const double *points, int64_t *corners) {
    std::vector<int64_t> order(count), way;
    std::iota(order.begin(), order.end(), 0);
    const auto x = [=](int64_t i) { return points[2 * i]; };
    const auto y = [=](int64_t i) { return points[2 * i + 1]; };
    std::sort(order.begin(), order.end(), [=](int64_t i, int64_t j) {
        return x(i) < x(j) || (x(i) == x(j) && y(i) < y(j));
    });
    for (int side = 0; side < 2; ++side, std::reverse(order.begin(), order.end())) {
        const size_t first = way.size() + 1;
        for (int64_t k : order) {
            while (way.size() > first) {
                const int64_t i = way[way.size() - 2], j = way.back();
                if ((x(j) - x(i)) * (y(k) - y(j)) > (y(j) - y(i)) * (x(k) - x(j))) break;
                way.pop_back();
            }
            way.push_back(k);
        }
        way.pop_back();  // It begins the other side.
    }
    std::copy(way.begin(), way.end(), corners);
    return way.size();
}

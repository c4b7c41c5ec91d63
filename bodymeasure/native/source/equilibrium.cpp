// The equilibrium of a string between tangent planes; the NumPy form is `taut.equilibrium`.
//
// Springs k join nodes; node i is kept where n_w step + gap_w >= 0 for its walls w = 0, 1. With a set
// of walls that hold, the step solves (K - bend) step = force + sum_w load_w n_w and
// n_w step = -gap_w: each node has a frame whose first columns span the normals that hold it, in
// which some coordinates are prescribed. What is left is block tridiagonal, and solved by Cholesky's
// method. Walls with a load below zero are let go, those that are cut through hold from then on: a
// primal-dual active set (M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13 (2002) 865-888).

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels.h"

namespace bodymeasure {

struct StringModel {
    int64_t count, most_exchanges;
    const double *springs;       // (count + 1)
    const double *force;         // (count, 3)
    const double *normal, *gap;  // (count, 2, 3), (count, 2)
    const uint8_t *there;        // (count, 2)
    const double *bend;          // (count, 3, 3)
};

namespace {

// A node: its frame, whose columns are rows here, which of its coordinates are prescribed, and as
// what; its block and that with the next node, in frames; its force there.
struct Node {
    double frame[3][3], prescribed[3], block[3][3], next[3][3], force[3];
    // Cholesky's factor of what is left of the block, and its quotient with the next one.
    double factor[3][3], quotient[3][3], solution[3];
    bool fixed[3];
};

// T. Duff et al., Building an orthonormal basis, revisited, JCGT 6 (2017).
void complete(const double *n, double (*frame)[3]) {
    const double sign = n[2] >= 0.0 ? 1.0 : -1.0, a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
    const double rows[3][3] = {{n[0], n[1], n[2]},
                               {1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
                               {b, sign + n[1] * n[1] * a, -n[1]}};
    std::copy(&rows[0][0], &rows[0][0] + 9, &frame[0][0]);
}

void frame_of(const double *normal, const double *gap, const uint8_t *held, Node &node) {
    const bool second = held[1] && !held[0], both = held[0] && held[1];
    complete(second ? normal + 3 : normal, node.frame);
    std::fill(node.prescribed, node.prescribed + 3, 0.0);
    std::fill(node.fixed, node.fixed + 3, false);
    if (!held[0] && !held[1]) return;
    node.fixed[0] = true;
    node.prescribed[0] = second ? -gap[1] : -gap[0];
    if (!both) return;
    const double *one = normal, *two = normal + 3, cosine = dot(one, two);
    double(*frame)[3] = node.frame;
    for (int c = 0; c < 3; ++c) frame[1][c] = two[c] - cosine * one[c];
    const double sine = std::sqrt(dot(frame[1], frame[1]));
    for (int c = 0; c < 3; ++c) frame[1][c] /= sine;
    for (int c = 0; c < 3; ++c)
        frame[2][c] = one[(c + 1) % 3] * frame[1][(c + 2) % 3] -
                      one[(c + 2) % 3] * frame[1][(c + 1) % 3];
    node.fixed[1] = true;
    node.prescribed[1] = (-gap[1] - cosine * node.prescribed[0]) / sine;
}

// The product of the matrix with vectors, one entry of three for each node.
template <typename Vector>
void apply(const std::vector<Node> &nodes, Vector vector, double (*result)[3]) {
    const int64_t count = nodes.size();
    for (int64_t k = 0; k < count; ++k) {
        for (int i = 0; i < 3; ++i) {
            double sum = 0.0;
            for (int j = 0; j < 3; ++j) {
                sum += nodes[k].block[i][j] * vector(k)[j];
                if (k + 1 < count) sum += nodes[k].next[i][j] * vector(k + 1)[j];
                if (k > 0) sum += nodes[k - 1].next[j][i] * vector(k - 1)[j];
            }
            result[k][i] = sum;
        }
    }
}

// The coordinates that are not prescribed; false if the matrix is not positive definite.
bool solve(std::vector<Node> &nodes, double (*right)[3]) {
    const int64_t count = nodes.size();
    apply(nodes, [&](int64_t k) { return nodes[k].prescribed; }, right);
    for (int64_t k = 0; k < count; ++k) {
        Node &node = nodes[k];
        double(*l)[3] = node.factor;
        for (int i = 0; i < 3; ++i) {
            double value = node.fixed[i] ? 0.0 : node.force[i] - right[k][i];
            for (int j = 0; j <= i; ++j) {
                const bool free = !node.fixed[i] && !node.fixed[j];
                double entry = free ? node.block[i][j] : i == j ? 1.0 : 0.0;
                if (k > 0)
                    for (int m = 0; m < 3; ++m)
                        entry -= nodes[k - 1].quotient[m][i] * nodes[k - 1].quotient[m][j];
                for (int m = 0; m < j; ++m) entry -= l[i][m] * l[j][m];
                if (i == j && !(entry > 0.0)) return false;
                l[i][j] = i == j ? std::sqrt(entry) : entry / l[j][j];
            }
            if (k > 0)
                for (int m = 0; m < 3; ++m)
                    value -= nodes[k - 1].quotient[m][i] * nodes[k - 1].solution[m];
            for (int j = 0; j < i; ++j) value -= l[i][j] * node.solution[j];
            node.solution[i] = value / l[i][i];
        }
        if (k + 1 == count) break;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                double entry = node.fixed[i] || nodes[k + 1].fixed[j] ? 0.0 : node.next[i][j];
                for (int m = 0; m < i; ++m) entry -= l[i][m] * node.quotient[m][j];
                node.quotient[i][j] = entry / l[i][i];
            }
        }
    }
    for (int64_t k = count - 1; k >= 0; --k) {
        Node &node = nodes[k];
        for (int i = 2; i >= 0; --i) {
            double value = node.solution[i];
            if (k + 1 < count)
                for (int j = 0; j < 3; ++j)
                    value -= node.quotient[i][j] * nodes[k + 1].solution[j];
            for (int m = i + 1; m < 3; ++m) value -= node.factor[m][i] * node.solution[m];
            node.solution[i] = value / node.factor[i][i];
        }
    }
    for (Node &node : nodes)
        for (int i = 0; i < 3; ++i) node.solution[i] += node.prescribed[i];
    return true;
}

// The loads of a node's walls whose sum is the reaction, which is given in its frame.
void loads_of(const double *normal, const uint8_t *held, const Node &node, const double *reaction,
              double *load) {
    for (int w = 0; w < 2; ++w) {
        load[w] = 0.0;
        for (int i = 0; i < 3; ++i) load[w] += dot(normal + 3 * w, node.frame[i]) * reaction[i];
    }
    if (!held[0] || !held[1]) return;
    load[1] = reaction[1] / dot(node.frame[1], normal + 3);
    load[0] -= dot(normal, normal + 3) * load[1];
}

}  // namespace

bool equilibrium(const StringModel &model, double *step, double *load, uint8_t *held) {
    const int64_t count = model.count;
    std::vector<Node> nodes(count);
    std::vector<double> room(3 * count);
    double(*right)[3] = reinterpret_cast<double(*)[3]>(room.data());
    std::vector<uint8_t> now(held, held + 2 * count), holds(2 * count);
    std::vector<std::vector<uint8_t>> seen;
    for (int64_t exchange = 0; exchange < model.most_exchanges; ++exchange) {
        for (int64_t k = 0; k < count; ++k)
            frame_of(model.normal + 6 * k, model.gap + 2 * k, &now[2 * k], nodes[k]);
        for (int64_t k = 0; k < count; ++k) {
            Node &node = nodes[k];
            const double stiff = model.springs[k] + model.springs[k + 1];
            for (int i = 0; i < 3; ++i) {
                const double *row = node.frame[i], *bend = model.bend + 9 * k;
                node.force[i] = dot(row, model.force + 3 * k);
                const double bent[3] = {
                    row[0] * bend[0] + row[1] * bend[3] + row[2] * bend[6],
                    row[0] * bend[1] + row[1] * bend[4] + row[2] * bend[7],
                    row[0] * bend[2] + row[1] * bend[5] + row[2] * bend[8]};
                for (int j = 0; j < 3; ++j) {
                    node.block[i][j] =
                        stiff * dot(row, node.frame[j]) - dot(bent, node.frame[j]);
                    if (k + 1 < count)
                        node.next[i][j] = -model.springs[k + 1] * dot(row, nodes[k + 1].frame[j]);
                }
            }
        }
        if (!solve(nodes, right)) return false;
        apply(nodes, [&](int64_t k) { return nodes[k].solution; }, right);
        for (int64_t k = 0; k < count; ++k) {
            const Node &node = nodes[k];
            for (int i = 0; i < 3; ++i) right[k][i] -= node.force[i];
            for (int c = 0; c < 3; ++c) {
                step[3 * k + c] = 0.0;
                for (int i = 0; i < 3; ++i)
                    step[3 * k + c] += node.frame[i][c] * node.solution[i];
            }
            loads_of(model.normal + 6 * k, &now[2 * k], node, right[k], load + 2 * k);
            for (int64_t w = 2 * k; w < 2 * k + 2; ++w) {
                const bool below = dot(model.normal + 3 * w, step + 3 * k) < -model.gap[w];
                holds[w] = now[w] ? load[w] > 0.0 : below && model.there[w];
            }
        }
        if (holds == now || std::find(seen.begin(), seen.end(), holds) != seen.end()) break;
        seen.push_back(now);
        now = holds;
    }
    for (int64_t w = 0; w < 2 * count; ++w) {
        held[w] = now[w];
        load[w] = now[w] && load[w] > 0.0 ? load[w] : 0.0;
    }
    return true;
}

}  // namespace bodymeasure

// The steps (count, 3), the loads (count, 2), and the walls that hold (count, 2), which are a guess
// at first; returns 0 where the matrix is not positive definite.
EXPORTED int64_t bodymeasure_equilibrium(const bodymeasure::StringModel *model, double *step,
                                         double *load, uint8_t *held) {
    return bodymeasure::equilibrium(*model, step, load, held);
}

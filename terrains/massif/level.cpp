#include "terrains/massif/level.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace terrains::massif {
namespace {

constexpr std::array<int, 8> kStepX{1, -1, 0, 0, 1, 1, -1, -1}, kStepY{0, 0, 1, -1, 1, -1, 1, -1};
constexpr double kDiagonal = 1.4142135623730951;

template <class Visit>
void for_neighbours(const Level& g, int a, Visit visit) {
    const int i = a % g.side, j = a / g.side;
    if (i > 0 && j > 0 && i < g.squares && j < g.squares) {
        for (int e = 0; e < 8; ++e) visit(a + kStepY[e] * g.side + kStepX[e], e);
        return;
    }
    for (int e = 0; e < 8; ++e) {
        const int p = i + kStepX[e], q = j + kStepY[e];
        if (p >= 0 && q >= 0 && p < g.side && q < g.side) visit(q * g.side + p, e);
    }
}

// Catmull–Rom weights of the four vertices around a position.
std::array<double, 4> cubic_weights(double t) {
    return {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2,
            (t - 1) * t * t / 2};
}

}  // namespace

void flood(Level& g) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
    std::vector<char> seen(g.size, 0);
    g.filled = g.height;
    g.order.clear();
    for (std::size_t a = 0; a < g.size; ++a)
        if (g.base[a] > kNotBase) {
            seen[a] = 1;
            front.push({g.height[a], static_cast<int>(a)});
        }
    while (!front.empty()) {
        const auto [z, a] = front.top();
        front.pop();
        g.order.push_back(a);
        for_neighbours(g, a, [&, z = z](int b, int) {
            if (seen[b]) return;
            seen[b] = 1;
            g.filled[b] = std::max(g.height[b], z + 1e-6);
            front.push({g.filled[b], b});
        });
    }
}

void route(Level& g, const Noise& chance) {
    g.receiver.resize(g.size);
    g.distance.assign(g.size, 1);
    g.drainage.assign(g.size, g.dx * g.dx);
    for (int a = 0; a < static_cast<int>(g.size); ++a) {
        g.receiver[a] = a;
        if (g.base[a] > kNotBase) continue;
        const std::uint64_t bits = chance.bits(a);
        double steepest = 0;
        for_neighbours(g, a, [&](int b, int e) {
            const double away = e < 4 ? g.dx : g.dx * kDiagonal;
            // On average the flow then follows the slope, whatever its direction (Fairfield and Leymarie 1991).
            const double blurred =
                e < 4 ? g.dx : g.dx * (1 + static_cast<double>((bits >> (8 * e)) & 255) / 255);
            const double slope = (g.filled[a] - g.filled[b]) / blurred;
            if (slope <= steepest) return;
            steepest = slope;
            g.receiver[a] = b;
            g.distance[a] = away;
        });
    }
    for (auto a = g.order.rbegin(); a != g.order.rend(); ++a)
        if (g.receiver[*a] != *a) g.drainage[g.receiver[*a]] += g.drainage[*a];
}

double slope(const Level& g, const Values& height, std::size_t a) {
    const int i = static_cast<int>(a % g.side), j = static_cast<int>(a / g.side);
    const int west = std::min(i, 1), east = std::min(g.squares - i, 1);
    const int south = std::min(j, 1), north = std::min(g.squares - j, 1);
    const double gx = (height[a + east] - height[a - west]) / ((east + west) * g.dx);
    const double gy = (height[a + north * g.side] - height[a - south * g.side]) / ((north + south) * g.dx);
    return std::sqrt(gx * gx + gy * gy);
}

Values blurred(const Level& g, const Values& values, int reach) {
    Values rows(g.size), result(g.size);
    const auto mean = [&](const Values& from, int line, int at, int stride, int across) {
        const int first = std::max(0, at - reach), last = std::min(g.squares, at + reach);
        double sum = 0;
        for (int k = first; k <= last; ++k) sum += from[std::size_t(line) * across + std::size_t(k) * stride];
        return sum / (last - first + 1);
    };
    for (int j = 0; j < g.side; ++j)
        for (int i = 0; i < g.side; ++i) rows[std::size_t(j) * g.side + i] = mean(values, j, i, 1, g.side);
    for (int j = 0; j < g.side; ++j)
        for (int i = 0; i < g.side; ++i) result[std::size_t(j) * g.side + i] = mean(rows, i, j, g.side, 1);
    return result;
}

double sampled(const Values& values, int side, double x, double y) {
    const double cx = std::clamp(x, 0.0, side - 1.0), cy = std::clamp(y, 0.0, side - 1.0);
    const int i = std::min(static_cast<int>(cx), side - 2), j = std::min(static_cast<int>(cy), side - 2);
    const double* v = values.data() + std::size_t(j) * side + i;
    return mixed(mixed(v[0], v[1], cx - i), mixed(v[side], v[side + 1], cx - i), cy - j);
}

double smoothly_sampled(const Values& values, int side, double x, double y) {
    const double cx = std::clamp(x, 0.0, side - 1.0), cy = std::clamp(y, 0.0, side - 1.0);
    const int i = std::min(static_cast<int>(cx), side - 2), j = std::min(static_cast<int>(cy), side - 2);
    const auto wx = cubic_weights(cx - i), wy = cubic_weights(cy - j);
    double sum = 0;
    for (int q = 0; q < 4; ++q) {
        const double* row = values.data() + std::size_t(std::clamp(j + q - 1, 0, side - 1)) * side;
        double across = 0;
        for (int p = 0; p < 4; ++p) across += wx[p] * row[std::clamp(i + p - 1, 0, side - 1)];
        sum += wy[q] * across;
    }
    return sum;
}

}  // namespace terrains::massif

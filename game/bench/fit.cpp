#include "game/bench/fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/core/check.h"

namespace game {
namespace {

using Numbers = std::vector<double>;

// Solves a·x = b in place, a symmetric and positive
// semidefinite. Returns false if there is no unique solution.
bool solve(std::vector<Numbers>& a, Numbers& b) {
    constexpr double kNothing = 1e-9;  // relative to the original diagonal
    const std::size_t n = b.size();
    Numbers diagonal(n);
    for (std::size_t i = 0; i < n; ++i) diagonal[i] = a[i][i];
    for (std::size_t i = 0; i < n; ++i) {
        if (!(a[i][i] > kNothing * diagonal[i])) return false;
        for (std::size_t j = i + 1; j < n; ++j) {
            const double share = a[j][i] / a[i][i];
            for (std::size_t k = i; k < n; ++k) a[j][k] -= share * a[i][k];
            b[j] -= share * b[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    return true;
}

void subtract_means(std::vector<Numbers>& columns) {
    for (Numbers& column : columns) {
        double sum = 0;
        for (const double value : column) sum += value;
        for (double& value : column) value -= sum / static_cast<double>(column.size());
    }
}

double dot(const Numbers& a, const Numbers& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> costs, std::span<const Numbers> factors) {
    // The logarithms: columns of factors, then the costs.
    std::vector<Numbers> columns(factors.size() + 1);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        bool counts = costs[i] > 0;
        for (const Numbers& factor : factors) {
            CHECK(factor.size() == costs.size());
            counts &= factor[i] > 0;
        }
        if (!counts) continue;
        for (std::size_t f = 0; f < factors.size(); ++f) columns[f].push_back(std::log(factors[f][i]));
        columns.back().push_back(std::log(costs[i]));
    }
    if (columns.back().size() < factors.size() + 2) return std::nullopt;
    subtract_means(columns);

    const Numbers& cost = columns.back();
    std::vector<Numbers> normal(factors.size(), Numbers(factors.size()));
    Numbers right(factors.size());
    for (std::size_t f = 0; f < factors.size(); ++f) {
        for (std::size_t g = 0; g < factors.size(); ++g) normal[f][g] = dot(columns[f], columns[g]);
        right[f] = dot(columns[f], cost);
    }
    const Numbers projected = right;
    if (!solve(normal, right)) return std::nullopt;
    const double all = dot(cost, cost), explained = dot(right, projected);
    return PowerLaw{right, all > 0 ? std::clamp(explained / all, 0.0, 1.0) : 1};
}

}  // namespace game

#include "sim/front/moving_quadratic.h"

#include <cmath>

namespace sim::front {
namespace {

// 1/σ² of what is known of each unknown beforehand, in cells and windows of time (docs of the class give
// their order): a front is straight and steady unless rows say otherwise; of its place nothing is known.
constexpr std::array<double, MovingQuadratic::kUnknowns> kPrior{
    1e-6, 1, 1 / (0.5 * 0.5), 1 / (50.0 * 50.0), 1, 1 / (10.0 * 10.0)};

constexpr int row_of(int i) {
    return i * (i + 1) / 2;
}

}  // namespace

void MovingQuadratic::add(double s, double z, double D, double weight) {
    const double term[kUnknowns] = {1, s, s * s / 2, z, z * s, z * z / 2};
    for (int i = 0; i < kUnknowns; ++i) {
        const double weighted = weight * term[i];
        for (int j = 0; j <= i; ++j) matrix_[row_of(i) + j] += weighted * term[j];
        right_[i] += weighted * D;
    }
}

// By Cholesky's factors: the prior makes the matrix positive definite.
void MovingQuadratic::solve() {
    auto factor = matrix_;
    for (int i = 0; i < kUnknowns; ++i) {
        double* row = &factor[row_of(i)];
        row[i] += kPrior[i];
        for (int j = 0; j < i; ++j) {
            const double* above = &factor[row_of(j)];
            for (int k = 0; k < j; ++k) row[j] -= row[k] * above[k];
            row[j] *= above[j];  // the reciprocal of the diagonal
            row[i] -= row[j] * row[j];
        }
        row[i] = 1 / std::sqrt(row[i]);
    }
    solution_ = right_;
    for (int i = 0; i < kUnknowns; ++i) {
        for (int k = 0; k < i; ++k) solution_[i] -= factor[row_of(i) + k] * solution_[k];
        solution_[i] *= factor[row_of(i) + i];
    }
    for (int i = kUnknowns - 1; i >= 0; --i) {
        for (int k = i + 1; k < kUnknowns; ++k) solution_[i] -= factor[row_of(k) + i] * solution_[k];
        solution_[i] *= factor[row_of(i) + i];
    }
}

}  // namespace sim::front

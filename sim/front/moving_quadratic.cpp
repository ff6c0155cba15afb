#include "sim/front/moving_quadratic.h"

namespace sim::front {
namespace {

constexpr int kUnknowns = MovingQuadratic::kUnknowns;

// Prior 1/σ² of each unknown but the last, in cells and windows of time; moving_quadratic.h gives their
// order. A front is straight and steady unless rows say otherwise. Its place has almost no prior.
constexpr std::array<double, kUnknowns - 1> kPrior{1e-6, 1, 1 / (0.5 * 0.5), 1 / (50.0 * 50.0), 1};

// Indices into Sums, by the powers of s and z. The sums with D follow, in the order of the unknowns.
enum Power { k1, kS, kSS, kSSS, kSSSS, kZ, kSZ, kSSZ, kSSSZ, kZZ, kSZZ, kSSZZ, kZZZ, kSZZZ, kZZZZ };

// The lower triangle of the normal equations: the sum for each entry, and its factor from the halves in the
// terms s²/2 and z²/2.
struct Entry {
    Power power;
    double times;
};
constexpr Entry kMatrix[kUnknowns][kUnknowns] = {
    {{k1, 1}},
    {{kS, 1}, {kSS, 1}},
    {{kSS, 0.5}, {kSSS, 0.5}, {kSSSS, 0.25}},
    {{kZ, 1}, {kSZ, 1}, {kSSZ, 0.5}, {kZZ, 1}},
    {{kSZ, 1}, {kSSZ, 1}, {kSSSZ, 0.5}, {kSZZ, 1}, {kSSZZ, 1}},
    {{kZZ, 0.5}, {kSZZ, 0.5}, {kSSZZ, 0.25}, {kZZZ, 0.5}, {kSZZZ, 0.5}, {kZZZZ, 0.25}}};

}  // namespace

// Factorises L D Lᵀ; the prior makes the matrix positive definite.
void MovingQuadratic::solve() {
    double factor[kUnknowns][kUnknowns], reciprocal[kUnknowns];  // L below its unit diagonal; inverse of D
    auto& c = solution_;
    for (int i = 0; i < kUnknowns; ++i) c[i] = sums.of[Sums<double>::kPowers + i];
    c[2] *= 0.5, c[5] *= 0.5;
    for (int i = 0; i < kUnknowns; ++i) {
        double* row = factor[i];
        const auto entry = [&](int j) { return sums.of[kMatrix[i][j].power] * kMatrix[i][j].times; };
        double diagonal = entry(i) + (i < kUnknowns - 1 ? kPrior[i] : 1 / (gain * gain));
        for (int j = 0; j < i; ++j) {
            row[j] = entry(j);
            for (int k = 0; k < j; ++k) row[j] -= row[k] * factor[j][k];
        }
        for (int j = 0; j < i; ++j) {
            const double times_D = row[j];
            row[j] *= reciprocal[j];
            diagonal -= times_D * row[j];
            c[i] -= row[j] * c[j];
        }
        reciprocal[i] = 1 / diagonal;
    }
    for (int i = kUnknowns - 1; i >= 0; --i) {
        c[i] *= reciprocal[i];
        for (int k = i + 1; k < kUnknowns; ++k) c[i] -= factor[k][i] * c[k];
    }
}

}  // namespace sim::front

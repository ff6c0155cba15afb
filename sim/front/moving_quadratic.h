#pragma once

#include <array>

namespace sim::front {

// A small piece of a moving front, in coordinates that turn and travel with nobody: s along it, D across, and
// z the time, 0 now and below 0 before.
//
//     D(s, z) = c₀ + c₁ s + c₂ s²/2 + z (v₀ + v₁ s) + a z²/2
//
// Fitted by weighted least squares; of unknowns that the rows do not tell, a weak prior keeps what is plain.
class MovingQuadratic {
  public:
    static constexpr int kUnknowns = 6;

    // The front was at D(s, z), give or take σ: weight 1/σ².
    void add(double s, double z, double D, double weight);

    // Solves for what was added until now; may be called again after more rows.
    void solve();

    // Of the last solution.
    double at(double s, double z) const {
        const auto& c = solution_;
        return c[0] + s * (c[1] + s / 2 * c[2]) + z * (c[3] + s * c[4] + z / 2 * c[5]);
    }
    double slope(double s) const { return solution_[1] + solution_[2] * s; }  // ∂D/∂s now
    double bend() const { return solution_[2]; }                              // ∂²D/∂s²
    double speed(double s) const { return solution_[3] + solution_[4] * s; }  // ∂D/∂z now

  private:
    // Lower triangle of the normal equations, row after row, and their right side.
    std::array<double, kUnknowns*(kUnknowns + 1) / 2> matrix_{};
    std::array<double, kUnknowns> right_{}, solution_{};
};

}  // namespace sim::front

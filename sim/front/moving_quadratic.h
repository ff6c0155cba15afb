#pragma once

#include <array>

namespace sim::front {

// A small piece of a moving front, in a fixed frame: s along it, D across it, and time z, which is 0 now and
// negative before.
//
//     D(s, z) = c₀ + c₁ s + c₂ s²/2 + z (v₀ + v₁ s) + a z²/2
//
// Fitted by weighted least squares. A weak prior decides unknowns that the rows leave undetermined.
class MovingQuadratic {
  public:
    static constexpr int kUnknowns = 6;

    // Sums over rows; Number is one value or several lanes. First the weights times the powers of s and z
    // that products of the terms above contain, then the weights times D and those terms without their
    // halves. moving_quadratic.cpp gives the order.
    template <class Number>
    struct Sums {
        static constexpr int kPowers = 15, kAll = kPowers + kUnknowns;
        Number of[kAll]{};

        // Adds a row: the front was at D(s, z) within σ; weight 1/σ².
        [[gnu::always_inline]] void add(const Number& s, const Number& z, const Number& D,
                                        const Number& weight) {
            const Number ws = weight * s, wss = ws * s, wz = weight * z, wzz = wz * z;
            add_now(s, D, weight);
            of[5] += wz, of[6] += wz * s, of[7] += wss * z, of[8] += wss * s * z;
            of[9] += wzz, of[10] += wzz * s, of[11] += wss * z * z;
            of[12] += wzz * z, of[13] += wzz * z * s, of[14] += wzz * z * z;
            of[kPowers + 3] += wz * D, of[kPowers + 4] += wz * s * D, of[kPowers + 5] += wzz * D;
        }
        // Adds a row at z = 0.
        [[gnu::always_inline]] void add_now(const Number& s, const Number& D, const Number& weight) {
            const Number ws = weight * s, wss = ws * s;
            of[0] += weight, of[1] += ws, of[2] += wss, of[3] += wss * s, of[4] += wss * s * s;
            of[kPowers] += weight * D, of[kPowers + 1] += ws * D, of[kPowers + 2] += wss * D;
        }
        // Adds rows summed elsewhere, with their weights multiplied by `times`.
        [[gnu::always_inline]] void add(const Sums& more, const Number& times) {
            for (int i = 0; i < kAll; ++i) of[i] += times * more.of[i];
        }
    };

    Sums<double> sums;  // of all rows so far
    double gain = 10;   // prior σ of a, > 0

    // Solves for the unknowns. May be called again after more rows.
    void solve();

    // The last solution.
    double at(double s, double z) const {
        const auto& c = solution_;
        return c[0] + s * (c[1] + s / 2 * c[2]) + z * (c[3] + s * c[4] + z / 2 * c[5]);
    }
    double slope(double s) const { return solution_[1] + solution_[2] * s; }  // ∂D/∂s now
    double bend() const { return solution_[2]; }                              // ∂²D/∂s²
    double speed(double s) const { return solution_[3] + solution_[4] * s; }  // ∂D/∂z now

  private:
    std::array<double, kUnknowns> solution_{};
};

}  // namespace sim::front

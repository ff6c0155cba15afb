#pragma once

#include <array>
#include <cstddef>

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

    // Sums over rows, of which Number is one or several side by side: weight times the powers of s and z that
    // products of the terms above have, and times D and those terms. Which is where: moving_quadratic.cpp.
    template <class Number>
    struct Sums {
        std::array<Number, 15> power{};
        std::array<Number, kUnknowns> with_D{};

        // The front was at D(s, z), give or take σ: weight 1/σ².
        void add(const Number& s, const Number& z, const Number& D, const Number& weight) {
            const Number ws = weight * s, wss = ws * s, wz = weight * z, wzz = wz * z;
            add_now(s, D, weight, ws, wss);
            power[5] += wz, power[6] += wz * s, power[7] += wss * z, power[8] += wss * s * z;
            power[9] += wzz, power[10] += wzz * s, power[11] += wss * z * z;
            power[12] += wzz * z, power[13] += wzz * z * s, power[14] += wzz * z * z;
            with_D[3] += wz * D, with_D[4] += wz * s * D, with_D[5] += wzz * D;
        }
        // The same at z = 0.
        void add_now(const Number& s, const Number& D, const Number& weight) {
            const Number ws = weight * s;
            add_now(s, D, weight, ws, ws * s);
        }
        // Rows that were added up elsewhere, each weight times so much.
        void add(const Sums& more, const Number& times = 1) {
            for (std::size_t i = 0; i < power.size(); ++i) power[i] += times * more.power[i];
            for (std::size_t i = 0; i < with_D.size(); ++i) with_D[i] += times * more.with_D[i];
        }

      private:
        void add_now(const Number& s, const Number& D, const Number& weight, const Number& ws,
                     const Number& wss) {
            power[0] += weight, power[1] += ws, power[2] += wss, power[3] += wss * s, power[4] += wss * s * s;
            with_D[0] += weight * D, with_D[1] += ws * D, with_D[2] += wss * D;
        }
    };

    Sums<double> sums;  // of all rows until now

    // Solves for them; may be called again after more rows.
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
    std::array<double, kUnknowns> solution_{};
};

}  // namespace sim::front

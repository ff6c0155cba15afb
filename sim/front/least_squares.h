#pragma once

#include <algorithm>
#include <cmath>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace sim::front {

// The r that minimises Σ (a·r − b)² over rows (a, b), and of all such the shortest: where every a lies on
// one line r does too, and without rows it is 0. Serves the velocity of a front and the gradient of a
// texture. From the normal equations, by the eigenvectors of their matrix.
struct LeastSquares {
    double xx = 0, xy = 0, yy = 0, xb = 0, yb = 0;

    void add(const glm::dvec2& a, double b) {
        xx += a.x * a.x, xy += a.x * a.y, yy += a.y * a.y;
        xb += a.x * b, yb += a.y * b;
    }

    // Rows count as lying on one line where the lesser eigenvalue is this share of the greater: rounding
    // leaves as much.
    static constexpr double kSingular = 1e-10;

    // What the sums Σ a b are multiplied by, whatever the b: inverse or, for rows on one line, pseudo-inverse
    // of Σ a aᵀ.
    glm::dmat2 inverse() const {
        const double mean = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
        const double greater = mean + spread;
        if (!(greater > 0)) return glm::dmat2(0);
        const double determinant = xx * yy - xy * xy;
        if (determinant > kSingular * greater * greater) return glm::dmat2(yy, -xy, -xy, xx) / determinant;
        // Only along the eigenvector of the greater eigenvalue: the longer of two ways to write it.
        const glm::dvec2 one(greater - yy, xy), other(xy, greater - xx);
        const double one2 = one.x * one.x + one.y * one.y, other2 = other.x * other.x + other.y * other.y;
        const glm::dvec2 along = one2 > other2 ? one : other;
        const double scale = 1 / (greater * std::max(one2, other2));
        return glm::dmat2(along * (along.x * scale), along * (along.y * scale));
    }

    glm::dvec2 solve() const { return inverse() * glm::dvec2(xb, yb); }
};

}  // namespace sim::front

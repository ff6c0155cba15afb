#pragma once

#include <algorithm>
#include <cmath>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace sim::front {

// Finds the shortest r that minimises Σ (a·r − b)² over rows (a, b). If every a lies on one line, so does r;
// without rows it is 0. Used for the slowness of a front and the gradient of a texture. Solved from the
// normal equations, by the eigenvectors of their matrix if it is singular.
struct LeastSquares {
    double xx = 0, xy = 0, yy = 0, xb = 0, yb = 0;

    void add(const glm::dvec2& a, double b) {
        xx += a.x * a.x, xy += a.x * a.y, yy += a.y * a.y;
        xb += a.x * b, yb += a.y * b;
    }

    // Rows count as lying on one line if the lesser eigenvalue is at most this share of the greater, which
    // rounding can leave.
    static constexpr double kSingular = 1e-10;

    // The matrix by which to multiply Σ a b, whatever the b: the inverse of Σ a aᵀ or, for rows on one line,
    // its pseudo-inverse.
    glm::dmat2 inverse() const {
        const double mean = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
        const double greater = mean + spread;
        if (!(greater > 0)) return glm::dmat2(0);
        const double determinant = xx * yy - xy * xy;
        if (determinant > kSingular * greater * greater) return glm::dmat2(yy, -xy, -xy, xx) / determinant;
        // Project on the eigenvector of the greater eigenvalue. Of the two ways to write it take the longer.
        const glm::dvec2 one(greater - yy, xy), other(xy, greater - xx);
        const double one2 = one.x * one.x + one.y * one.y, other2 = other.x * other.x + other.y * other.y;
        const glm::dvec2 along = one2 > other2 ? one : other;
        const double scale = 1 / (greater * std::max(one2, other2));
        return glm::dmat2(along * (along.x * scale), along * (along.y * scale));
    }

    glm::dvec2 solve() const { return inverse() * glm::dvec2(xb, yb); }
};

}  // namespace sim::front

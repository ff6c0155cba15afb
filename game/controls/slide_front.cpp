#include "game/controls/slide_front.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "game/scene/surface.h"

namespace game {
namespace {

constexpr double kSlow = 2;        // m/s in plan; slower flow has no front to follow
constexpr double kReach = 80;      // m, of the disc around the front, but
constexpr double kLeastReach = 5;  // cells
constexpr int kShifts = 3;         // of the disc in a frame

struct Sum {
    double weight = 0;
    glm::dvec2 at{0}, velocity{0};

    // By R v², because what is deep and fast counts, and the less the farther it is from the middle.
    void add(const sim::View& world, int x, int y, double near) {
        const glm::dvec2 v(world.velocity_x(x, y), world.velocity_y(x, y));
        const double speed2 = glm::dot(v, v);
        if (speed2 < kSlow * kSlow) return;
        const double w = static_cast<double>(world.rolling(x, y)) * speed2 * near;
        weight += w;
        at += w * glm::dvec2(x, y);
        velocity += w * v;
    }
};

// Over the disc around a place; in cells.
Sum around(const sim::View& world, glm::dvec2 middle, double reach) {
    Sum sum;
    const int from_x = std::max(static_cast<int>(std::ceil(middle.x - reach)), 0),
              to_x = std::min(static_cast<int>(middle.x + reach), world.grid.nx - 1),
              from_y = std::max(static_cast<int>(std::ceil(middle.y - reach)), 0),
              to_y = std::min(static_cast<int>(middle.y + reach), world.grid.ny - 1);
    for (int y = from_y; y <= to_y; ++y)
        for (int x = from_x; x <= to_x; ++x) {
            const glm::dvec2 away = (glm::dvec2(x, y) - middle) / reach;
            if (const double near = 1 - glm::dot(away, away); near > 0) sum.add(world, x, y, near);
        }
    return sum;
}

// Of discs that cover the grid, the one in which most moves.
Sum strongest(const sim::View& world, double reach) {
    Sum best;
    const int apart = static_cast<int>(reach);
    for (int y = 0; y < world.grid.ny; y += apart)
        for (int x = 0; x < world.grid.nx; x += apart) {
            const Sum sum = around(world, glm::dvec2(x, y), reach);
            if (sum.weight > best.weight) best = sum;
        }
    return best;
}

}  // namespace

void SlideFront::see(const sim::View& world) {
    const double dx = static_cast<double>(world.grid.dx), reach = std::max(kReach / dx, kLeastReach);
    Sum sum;
    if (front_) sum = around(world, glm::dvec2(front_->at) / dx, reach);
    if (sum.weight == 0) sum = strongest(world, reach);
    for (int i = 0; i < kShifts && sum.weight > 0; ++i) sum = around(world, sum.at / sum.weight, reach);
    if (sum.weight == 0 || glm::length(sum.velocity) == 0) return front_.reset();
    const glm::dvec2 at = dx * sum.at / sum.weight;
    front_ = Front{glm::dvec3(at, surface_height(world, at)), glm::normalize(sum.velocity)};
}

}  // namespace game

#include "sim/world/disc.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

// Far beside any grid, where nothing is to be found, all places are the same: an int must not run over.
int vertex(double at) {
    return static_cast<int>(std::clamp(at, -1e9, 1e9));
}

}  // namespace

Disc::Disc(const Command& c, double dx) : x(c.x), y(c.y), radius(c.radius) {
    if (radius < dx) {
        x = dx * std::rint(x / dx);
        y = dx * std::rint(y / dx);
        radius = 0.5 * dx;
    }
    x0 = vertex(std::ceil((x - radius) / dx));
    x1 = vertex(std::floor((x + radius) / dx));
    y0 = vertex(std::ceil((y - radius) / dx));
    y1 = vertex(std::floor((y + radius) / dx));
}

double Disc::weight(int i, int j, double dx, Profile profile) const {
    const double ex = i * dx - x, ey = j * dx - y;
    const double distance = std::sqrt(ex * ex + ey * ey);
    if (distance > radius) return 0;
    return profile == Profile::kCone ? 1 - distance / radius : 1;
}

double Disc::total_weight(double dx, Profile profile) const {
    const double across = radius / dx;
    const double area = 3.14159265358979323846 * across * across;
    if (area > 1 << 20) return profile == Profile::kCone ? area / 3 : area;
    double sum = 0;
    for (int j = y0; j <= y1; ++j)
        for (int i = x0; i <= x1; ++i) sum += weight(i, j, dx, profile);
    return sum;
}

}  // namespace sim

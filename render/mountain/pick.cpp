#include "render/mountain/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

namespace render {
namespace {

constexpr double kEarly = 0.02;  // of the distance to a place: ground met there does not hide it

constexpr double kNever = std::numeric_limits<double>::infinity();
// Extent of a triangle beyond its edges, in cells, so that no ray slips through between two triangles.
constexpr double kOverlap = 1e-9;

// The part of a line inside a region, in multiples of its direction.
struct Span {
    double begin, end;

    // Keeps only the part between two values of a coordinate.
    void keep_between(double low, double high, double from, double along) {
        if (along == 0) {
            if (from < low || from > high) end = -1;
            return;
        }
        const double a = (low - from) / along, b = (high - from) / along;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
};

// One of the two coordinates of the traversal from square to square.
struct Axis {
    int square;     // current
    int step;       // −1, 0 or 1
    double next;    // distance along the ray to the end of the square
    double length;  // of a square, along the ray

    Axis(double from, double along, double begin, int squares)
        : square(std::clamp(static_cast<int>(std::floor(from + begin * along)), 0, squares - 1)),
          step(along > 0   ? 1
               : along < 0 ? -1
                           : 0),
          next(step == 0 ? kNever : (square + (step > 0 ? 1 : 0) - from) / along),
          length(step == 0 ? kNever : 1 / std::abs(along)) {}

    void advance() {
        square += step;
        next += length;
    }
};

double height(const sim::View& world, int x, int y) {
    return world.datum + world.bedrock(x, y) + world.depth(x, y) + world.rolling(x, y);
}

bool is_ground(const sim::View& world, int x, int y) {
    return world.site(x, y) != sim::Site::kDrain;
}

// A plane z₀ + u · rise_u + v · rise_v, to be intersected from above by a ray in cells with heights in
// metres. u and v are measured from the corner of a square.
struct Plane {
    double z, rise_u, rise_v;

    double meet(const glm::dvec3& from, const glm::dvec3& along) const {
        const double sinking = along.z - along.x * rise_u - along.y * rise_v;
        const double above = from.z - z - from.x * rise_u - from.y * rise_v;
        return sinking < 0 ? above / -sinking : kNever;
    }
};

//   d ─── c     the plane of a b c where u ≥ v, of a c d where u ≤ v
//   │   ╱ │
//   │ ╱   │
//   a ─── b
double meet_square(const sim::View& world, int x, int y, glm::dvec3 from, const glm::dvec3& along) {
    if (!is_ground(world, x, y) || !is_ground(world, x + 1, y + 1)) return kNever;
    from -= glm::dvec3(x, y, 0);
    const double a = height(world, x, y), c = height(world, x + 1, y + 1);
    double nearest = kNever;
    const auto try_plane = [&](const Plane& plane, double side) {
        const double t = plane.meet(from, along);
        if (!(t >= 0 && t < nearest)) return;
        const double u = from.x + t * along.x, v = from.y + t * along.y;
        const bool inside = std::min(u, v) >= -kOverlap && std::max(u, v) <= 1 + kOverlap;
        if (inside && side * (u - v) >= -kOverlap) nearest = t;
    };
    if (is_ground(world, x + 1, y)) {
        const double b = height(world, x + 1, y);
        try_plane({a, b - a, c - b}, 1);
    }
    if (is_ground(world, x, y + 1)) {
        const double d = height(world, x, y + 1);
        try_plane({a, c - d, d - a}, -1);
    }
    return nearest;
}

}  // namespace

Ray ray_through(const Camera& camera, double aspect, glm::dvec2 point) {
    const glm::dmat4 axes =
        glm::transpose(view_matrix(camera));  // columns: right, up and backward in the world
    const double reach = std::tan(glm::radians(camera.field_of_view_deg) / 2);
    const glm::dvec3 along = glm::dvec3(axes[0]) * (point.x * reach * aspect) +
                             glm::dvec3(axes[1]) * (point.y * reach) - glm::dvec3(axes[2]);
    return {eye(camera), glm::normalize(along)};
}

std::optional<glm::dvec3> pick(const sim::View& world, const Ray& ray) {
    // Use cells in plan, so that squares are whole numbers. Lengths along the ray stay in metres.
    const glm::dvec3 cells(1 / static_cast<double>(world.grid.dx), 1 / static_cast<double>(world.grid.dx), 1);
    const glm::dvec3 from = ray.from * cells, along = ray.along * cells;
    const int columns = world.grid.nx - 1, rows = world.grid.ny - 1;

    Span over_grid{0, kNever};
    over_grid.keep_between(0, columns, from.x, along.x);
    over_grid.keep_between(0, rows, from.y, along.y);
    if (over_grid.begin > over_grid.end) return std::nullopt;

    // Squares are visited in order along the ray, so the first hit is the nearest.
    Axis x(from.x, along.x, over_grid.begin, columns), y(from.y, along.y, over_grid.begin, rows);
    while (x.square >= 0 && y.square >= 0 && x.square < columns && y.square < rows) {
        const double t = meet_square(world, x.square, y.square, from, along);
        if (t < kNever) return ray.from + t * ray.along;
        if (x.step == 0 && y.step == 0) break;
        (x.next < y.next ? x : y).advance();
    }
    return std::nullopt;
}

bool is_hidden(const sim::View& world, glm::dvec3 place, glm::dvec3 eye) {
    const double away = glm::distance(eye, place);
    const auto met = pick(world, {eye, (place - eye) / away});
    return met && glm::distance(eye, *met) < away * (1 - kEarly);
}

bool is_hidden(const sim::View& world, const Surroundings& around, glm::dvec3 place, glm::dvec3 eye) {
    if (is_hidden(world, place, eye)) return true;
    const double away = glm::distance(eye, place);
    const auto met = around.meet(eye - glm::dvec3(0, 0, world.datum), (place - eye) / away);
    return met && *met < away * (1 - kEarly);
}

}  // namespace render

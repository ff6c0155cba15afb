#include "render/mountain/overview.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/mountain/ground_mesh.h"

namespace render {
namespace {

constexpr double kAspect = 16.0 / 9.0;
constexpr double kOffFallLine = 28;  // degrees
constexpr double kFlatSlope = 0.01;  // tangent below which there is no fall line

struct Bounds {
    double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();  // m
};

Bounds height_bounds(const sim::View& world) {
    Bounds bounds;
    for (int y = 0; y < world.grid.ny; ++y) {
        for (int x = 0; x < world.grid.nx; ++x) {
            if (world.site(x, y) == sim::Site::kDrain) continue;
            const double z = world.bedrock(x, y) + world.depth(x, y);
            bounds.lowest = std::min(bounds.lowest, z);
            bounds.highest = std::max(bounds.highest, z);
        }
    }
    return bounds;
}

// Mean slope over all squares whose corners are ground: (dz/dx, dz/dy).
glm::dvec2 mean_slope(const sim::View& world) {
    glm::dvec2 sum(0);
    std::int64_t count = 0;
    for (int y = 0; y + 1 < world.grid.ny; ++y) {
        for (int x = 0; x + 1 < world.grid.nx; ++x) {
            if (world.site(x, y) == sim::Site::kDrain || world.site(x + 1, y) == sim::Site::kDrain ||
                world.site(x, y + 1) == sim::Site::kDrain)
                continue;
            const double z = world.bedrock(x, y);
            sum += glm::dvec2(world.bedrock(x + 1, y) - z, world.bedrock(x, y + 1) - z);
            ++count;
        }
    }
    return count == 0 ? sum : sum / (static_cast<double>(count) * world.grid.dx);
}

// The terrain's extent to each side of an image, as seen from the origin: the largest of ±x − tan·z and ±y −
// tan·z, with x right, y up, z forward. The camera sees all terrain once it stands back so far that none is
// positive.
struct Reach {
    double right = kNone, left = kNone, up = kNone, down = kNone;  // m

    void add(glm::dvec3 p, double tan_x, double tan_y) {
        right = std::max(right, p.x - tan_x * p.z);
        left = std::max(left, -p.x - tan_x * p.z);
        up = std::max(up, p.y - tan_y * p.z);
        down = std::max(down, -p.y - tan_y * p.z);
    }

    static constexpr double kNone = std::numeric_limits<double>::lowest();
};

Reach reach(const sim::View& world, const glm::dmat4& turn, glm::dvec3 centre, double base, double tan_x,
            double tan_y) {
    Reach r;
    for (int y = 0; y < world.grid.ny; ++y) {
        for (int x = 0; x < world.grid.nx; ++x) {
            if (world.site(x, y) == sim::Site::kDrain) continue;
            const glm::dvec2 at = glm::dvec2(x, y) * static_cast<double>(world.grid.dx);
            for (const double z : {base, static_cast<double>(world.bedrock(x, y)) + world.depth(x, y)}) {
                const glm::dvec3 seen(turn * glm::dvec4(glm::dvec3(at, z) - centre, 0));
                r.add({seen.x, seen.y, -seen.z}, tan_x, tan_y);
            }
        }
    }
    return r;
}

// From the low side of a terrain at `centre`, a little off the fall line.
Camera from_low_side(const sim::View& world, glm::dvec3 centre, double elevation_deg) {
    const glm::dvec2 slope = mean_slope(world);
    Camera camera;
    camera.elevation_deg = elevation_deg;
    camera.azimuth_deg = 180;
    camera.distance_m = 1000;
    if (glm::length(slope) > kFlatSlope)
        camera.azimuth_deg =
            std::fmod(glm::degrees(std::atan2(-slope.x, -slope.y)) + kOffFallLine + 360, 360);
    camera.target = centre;
    return camera;
}

glm::dvec3 centre_of(const sim::Grid& grid, Bounds bounds) {
    return {0.5 * (grid.nx - 1) * grid.dx, 0.5 * (grid.ny - 1) * grid.dx,
            0.5 * (bounds.lowest + bounds.highest)};
}

// Moves the camera back, and aside within its image plane; heights so far are above the world's datum.
void place(Camera& camera, const glm::dmat4& turn, double distance_m, glm::dvec2 aside) {
    camera.distance_m = distance_m;
    camera.target += glm::dvec3(glm::transpose(turn) * glm::dvec4(aside, 0, 0));
}

}  // namespace

Camera overview(const sim::View& world) {
    constexpr double kElevation = 28;  // degrees
    constexpr double kFilled = 0.95;   // share of the image that the terrain fills
    const Bounds bounds = height_bounds(world);
    const glm::dvec3 centre = centre_of(world.grid, bounds);
    Camera camera = from_low_side(world, centre, kElevation);
    if (bounds.lowest <= bounds.highest) {
        const double tan_y = kFilled * std::tan(glm::radians(camera.field_of_view_deg) / 2),
                     tan_x = tan_y * kAspect;
        const glm::dmat4 turn = view_matrix(camera);
        const Reach r = reach(world, turn, centre, bounds.lowest - block_depth(world.grid), tan_x, tan_y);
        place(camera, turn, std::max((r.right + r.left) / (2 * tan_x), (r.up + r.down) / (2 * tan_y)),
              0.5 * glm::dvec2(r.right - r.left, r.up - r.down));
    }
    camera.target.z += world.datum;
    return camera;
}

Camera landscape_view(const sim::View& world) {
    constexpr double kElevation = 14;  // degrees
    constexpr double kAcross = 0.85;   // width of the terrain as a share of that of the image
    constexpr double kSkyline = 0.7;   // height of the highest ground in the image, from −1 to 1
    const Bounds bounds = height_bounds(world);
    const glm::dvec3 centre = centre_of(world.grid, bounds);
    Camera camera = from_low_side(world, centre, kElevation);
    if (bounds.lowest <= bounds.highest) {
        const double tan_y = std::tan(glm::radians(camera.field_of_view_deg) / 2);
        const double across = kAcross * kAspect * tan_y, skyline = kSkyline * tan_y;
        const glm::dmat4 turn = view_matrix(camera);
        const Reach r = reach(world, turn, centre, bounds.lowest, across, skyline);
        const double distance_m = (r.right + r.left) / (2 * across);
        place(camera, turn, distance_m, {0.5 * (r.right - r.left), r.up - skyline * distance_m});
    }
    camera.target.z += world.datum;
    return camera;
}

}  // namespace render

#include "game/controls/probe.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "game/scene/surface.h"
#include "game/session/session.h"

namespace game {
namespace {

constexpr double kBeside = 1e-6;  // of a cell; a ray at the border may miss it by a rounding error
constexpr double kLevel = 1e-3;   // tangent

bool on_grid(const sim::Grid& grid, glm::dvec2 at) {
    const glm::dvec2 p = at / static_cast<double>(grid.dx);
    return p.x >= -kBeside && p.y >= -kBeside && p.x <= grid.nx - 1 + kBeside && p.y <= grid.ny - 1 + kBeside;
}

// Gradient of the bilinear patch: tangents toward east and north.
glm::dvec2 gradient(const sim::View& world, const Square& square) {
    const auto height = [&](int x, int y) {
        return static_cast<double>(world.bedrock(x, y)) + world.depth(x, y) + world.rolling(x, y);
    };
    const auto [x, y, across] = square;
    const double south_west = height(x, y), south_east = height(x + 1, y), north_west = height(x, y + 1),
                 north_east = height(x + 1, y + 1);
    return glm::dvec2(glm::mix(south_east - south_west, north_east - north_west, across.y),
                      glm::mix(north_west - south_west, north_east - south_east, across.x)) /
           static_cast<double>(world.grid.dx);
}

// The nearest object within a quarter of a cell, so that a thin one can be met too.
std::optional<sim::Thing> thing_at(const sim::View& world, glm::dvec2 at) {
    std::optional<sim::Thing> nearest;
    double least = static_cast<double>(world.grid.dx) / 4;
    for (const sim::Thing& thing : world.things->list)
        if (const double distance = sim::distance_from(thing, at.x, at.y);
            distance < least || (distance == 0 && !nearest))
            nearest = thing, least = distance;
    return nearest;
}

std::optional<double> aspect(glm::dvec2 rise) {
    if (glm::length(rise) < kLevel) return std::nullopt;
    const double degrees = glm::degrees(std::atan2(-rise.x, -rise.y));
    return degrees < 0 ? std::fmod(degrees + 360, 360)
                       : degrees;  // a rounding error below 0 gives 0, not 360
}

}  // namespace

bool has_data(const Square& square, const sim::Field<sim::Site>& site) {
    for (const int y : {square.y, square.y + 1})
        for (const int x : {square.x, square.x + 1})
            if (site(x, y) == sim::Site::kDrain) return false;
    return true;
}

glm::dvec2 slope_of_ground(const sim::View& world, const Square& square) {
    const auto [x, y, across] = square;
    const auto at = [&](int i, int j) { return glm::dvec2(ground_slope(world, i, j)); };
    return glm::mix(glm::mix(at(x, y), at(x + 1, y), across.x),
                    glm::mix(at(x, y + 1), at(x + 1, y + 1), across.x), across.y);
}

double zero_of_heights(const sim::View& world, const terrains::Georeference& georeference) {
    double lowest = 0;
    if (georeference.has_coordinates()) return lowest;
    for (int y = 0; y < world.grid.ny; ++y)
        for (int x = 0; x < world.grid.nx; ++x)
            if (world.site(x, y) != sim::Site::kDrain)
                lowest = std::min(lowest, static_cast<double>(world.bedrock(x, y)) + world.datum);
    return lowest;
}

std::optional<Reading> Probe::read(const sim::View& world, glm::dvec2 at) {
    if (!on_grid(world.grid, at)) return std::nullopt;
    const Square square = square_under(world.grid, at);
    if (!has_data(square, world.site)) return std::nullopt;

    Reading reading;
    reading.standing = between(square, world.depth);
    reading.rolling = between(square, world.rolling);
    reading.at = {at, between(square, world.bedrock) + reading.standing + reading.rolling + world.datum};
    reading.height = reading.at.z - zero_;
    const glm::dvec2 rise = gradient(world, square);
    reading.slope_deg = glm::degrees(std::atan(glm::length(rise)));
    reading.aspect_deg = aspect(rise);
    const glm::dvec2 ground = slope_of_ground(world, square);
    reading.thickness = reading.rolling / std::sqrt(1 + glm::dot(ground, ground));
    // A layer too thin to see has no visible speed, even between vertices of a fast flow.
    if (reading.rolling >= static_cast<double>(Peaks::kVisible)) {
        const glm::dvec2 velocity(between(square, world.velocity_x), between(square, world.velocity_y));
        reading.speed_plan = glm::length(velocity);
        reading.speed_slope = speed_along_slope(velocity, ground);
    }

    const int x = square.x + (square.across.x >= 0.5), y = square.y + (square.across.y >= 0.5);
    if (world.mixture) {
        reading.lower_share =
            static_cast<double>(world.rolling(x, y) > 0 ? sim::share_in_rolling(world, x, y)
                                                        : sim::share_at_surface(world, x, y));
    }

    if (world.things) {
        reading.thing = thing_at(world, at);
        reading.forest = world.things->forest(x, y);
        reading.water = between(square, world.things->water);
        reading.earth = between(square, world.things->earth);
    }

    if (densities_) {
        const bool mixed = world.mixture && reading.rolling > 0;
        reading.pressure =
            impact_pressure(densities_->of(mixed ? *reading.lower_share : 0), reading.speed_slope);
    }

    if (last_ != at) {
        locator_.describe({at.x, at.y}, where_);
        last_ = at;
    }
    reading.where = where_;
    return reading;
}

}  // namespace game

#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/scene/pressure.h"
#include "game/scene/surface.h"
#include "sim/world/state.h"
#include "sim/world/things.h"
#include "terrains/georeference.h"
#include "terrains/locator.h"

namespace game {

// The values shown for a point on the surface.
struct Reading {
    glm::dvec3 at{0};      // m; z above the terrain's zero
    double height = 0;     // m, as shown: z above zero_of_heights()
    double slope_deg = 0;  // of the surface
    // Downslope direction: 0 north, 90 east, below 360; nothing if the slope is gentler than 1 in 1000.
    std::optional<double> aspect_deg;
    double standing = 0, rolling = 0;  // m, vertical
    double thickness = 0;              // m, of the rolling layer, normal to the slope of the ground
    // m/s, of the rolling layer, along the slope of the ground and in plan; 0 if it is thinner than
    // Peaks::kVisible.
    double speed_slope = 0, speed_plan = 0;
    std::optional<double> pressure;  // kPa, impact pressure; nothing if a density is unknown
    // Fraction of the lower material at the nearest vertex, 0 to 1: in the rolling layer, else at the surface
    // of the standing layer; nothing in a world with one material.
    std::optional<double> lower_share;
    std::optional<sim::Thing> thing;  // that stands there, with what became of it
    sim::Stems forest;                // at the nearest vertex
    double water = 0;                 // share of the standing layer that is saturated, 0 to 1
    double earth = 0;                 // m, by which the ground was raised there; negative: lowered
    std::array<char, 96>
        where{};  // "47.30012° N 11.43210° E, UTM 32T 683912 5240010"; empty without georeference
};

// The height that is shown as 0, m above the terrain's zero: that zero, which is sea level on a terrain with a place
// on Earth. Without such a place, if ground lies below zero, its lowest point, because nothing there is at −30 m.
double zero_of_heights(const sim::View& world, const terrains::Georeference& georeference);

// Whether all four vertices around a place have data.
bool has_data(const Square& square, const sim::Field<sim::Site>& site);
// Tangents of the ground along which the rolling layer moves, interpolated between the vertices: at a vertex they are
// those that its peaks were found with.
glm::dvec2 slope_of_ground(const sim::View& world, const Square& square);

// Reads the world at single points. Does not allocate.
class Probe {
  public:
    // `densities`: of the world's materials; without them there is no pressure.
    explicit Probe(const terrains::Georeference& georeference, std::optional<Densities> densities = {},
                   double zero = 0)
        : locator_(georeference), densities_(densities), zero_(zero) {}

    // Interpolates bilinearly between the four surrounding vertices. Nothing outside the grid or if one of
    // the four has no data. A point up to a millionth of a cell outside counts as on the border.
    std::optional<Reading> read(const sim::View& world, glm::dvec2 at);
    double zero() const { return zero_; }

  private:
    terrains::Locator locator_;
    std::optional<Densities> densities_;
    double zero_;                     // m, zero_of_heights()
    std::optional<glm::dvec2> last_;  // the point described by where_
    std::array<char, 96> where_{};
};

}  // namespace game

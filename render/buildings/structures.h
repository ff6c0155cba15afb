#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/world/things.h"

namespace render {

enum class StructureKind {
    kStation,  // of a chairlift, at either end
    kPylon,    // of a chairlift
    kHouse,    // of any size and material
};
enum class StructureState {
    kIntact,
    kDamaged,
    kDestroyed,
    kBuried,  // it stands, and nothing of it looks out
};

// What a house is made of, from weak to strong.
enum class HouseMaterial {
    kGlass,     // panes in a frame of steel
    kWood,      // on a base of stone
    kBrick,     // plastered
    kConcrete,  // with a flat roof
};
// By the load that destroys it, kPa.
constexpr HouseMaterial material_of(double strength) {
    return strength <= 2    ? HouseMaterial::kGlass
           : strength <= 7  ? HouseMaterial::kWood
           : strength <= 20 ? HouseMaterial::kBrick
                            : HouseMaterial::kConcrete;
}

// Something that people have built. Places are metres from vertex (0, 0).
struct Structure {
    StructureKind kind = StructureKind::kHouse;
    glm::dvec2 at{0};        // its middle
    double heading_deg = 0;  // of its front, or along the rope: 0 north, 90 east
    StructureState state = StructureState::kIntact;
    // Of a house, m: along its heading, across it, and the height of its roof.
    double length_m = 0, width_m = 0, height_m = 0;
    HouseMaterial material = HouseMaterial::kWood;
    bool operator==(const Structure&) const = default;
};

// A road that is kept clear of snow.
struct Road {
    std::vector<glm::dvec2> points;  // of its middle, at least two
    double width_m = 6;
    bool operator==(const Road&) const = default;
};

// A chairlift: `count` of Structures::all, in a row, between which its rope hangs. A station at either end. Where one
// is destroyed, the rope tears: of the span beside it only the end at the other one is left.
struct Lift {
    std::size_t first = 0, count = 0;
    bool operator==(const Lift&) const = default;
};

// A piece of a row of snow nets, between posts of steel.
struct Net {
    glm::dvec2 from{0}, to{0};  // m
    double height_m = 3;
    StructureState state = StructureState::kIntact;
    bool operator==(const Net&) const = default;
};

// What people have built on a mountain, as it is drawn.
struct Structures {
    std::vector<Structure> all;
    std::vector<Road> roads;
    std::vector<Lift> lifts;
    std::vector<Net> nets;

    bool empty() const { return all.empty() && roads.empty() && nets.empty(); }
    bool operator==(const Structures&) const = default;
};

// Half of the length (along the heading) and of the width of what stands on the ground, m.
constexpr glm::dvec2 half_footprint(const Structure& structure) {
    switch (structure.kind) {
        case StructureKind::kHouse:
            return {structure.length_m / 2, structure.width_m / 2};
        case StructureKind::kStation:
            return {sim::kStationLength / 2, sim::kStationWidth / 2};
        case StructureKind::kPylon:
            break;
    }
    return glm::dvec2(sim::kPylonWidth / 2);
}
constexpr double height_of(const Structure& structure) {
    switch (structure.kind) {
        case StructureKind::kHouse:
            return structure.height_m;
        case StructureKind::kStation:
            return sim::kStationHeight;
        case StructureKind::kPylon:
            break;
    }
    return sim::kPylonHeight;
}

}  // namespace render

#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace render {

enum class StructureKind {
    kHut,      // of wood, on a base of stone
    kStation,  // of a chairlift, at either end
    kPylon,    // of a chairlift
};
enum class StructureState {
    kIntact,
    kDamaged,
    kDestroyed,
    kBuried,  // it stands, and nothing of it looks out
};

// Something that people have built. Places are metres from vertex (0, 0).
struct Structure {
    StructureKind kind = StructureKind::kHut;
    glm::dvec2 at{0};        // its middle
    double heading_deg = 0;  // of its front, or along the rope: 0 north, 90 east
    StructureState state = StructureState::kIntact;
    bool operator==(const Structure&) const = default;
};

// A road that is kept clear of snow.
struct Road {
    std::vector<glm::dvec2> points;  // of its middle, at least two
    double width_m = 6;
    bool operator==(const Road&) const = default;
};

// A chairlift: `count` of Structures::all, in a row, between which its rope hangs. A station at either end.
struct Lift {
    std::size_t first = 0, count = 0;
    bool operator==(const Lift&) const = default;
};

// What people have built on a mountain. For the eye alone: nothing flows differently because of it.
struct Structures {
    std::vector<Structure> all;
    std::vector<Road> roads;
    std::vector<Lift> lifts;

    bool empty() const { return all.empty() && roads.empty(); }
    bool operator==(const Structures&) const = default;
};

// Sizes, m.
inline constexpr double kHutLength = 11, kHutWidth = 9, kHutHeight = 7.5;
inline constexpr double kStationLength = 9, kStationWidth = 7, kStationHeight = 7;
inline constexpr double kPylonHeight = 14;

// Half of the length (along the heading) and of the width of what stands on the ground, m.
constexpr glm::dvec2 half_footprint(StructureKind kind) {
    switch (kind) {
        case StructureKind::kHut:
            return {kHutLength / 2, kHutWidth / 2};
        case StructureKind::kStation:
            return {kStationLength / 2, kStationWidth / 2};
        case StructureKind::kPylon:
            break;
    }
    return {0.6, 0.6};
}
constexpr double height_of(StructureKind kind) {
    switch (kind) {
        case StructureKind::kHut:
            return kHutHeight;
        case StructureKind::kStation:
            return kStationHeight;
        case StructureKind::kPylon:
            break;
    }
    return kPylonHeight;
}

}  // namespace render

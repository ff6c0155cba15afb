#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/buildings/structures.h"
#include "render/mountain/surroundings.h"
#include "render/view/look.h"
#include "sim/world/state.h"

namespace render {

// A corner of a triangle of a structure. Space as in shaders. Vertex attributes of structure.vert.
struct StructureVertex {
    glm::vec4 at;      // m; what it is made of: BUILT_*
    glm::vec4 normal;  // unit vector; a number of the structure's own, 0 to 1
    glm::vec4
        face;  // place on its face, m across and up; light that reaches it, 0 to 1; a number of its own, 0 to 1
    // Of what rests on the surface: place, height of the surface there at tick 0, m; 1: rises and sinks with it, 2: sinks.
    glm::vec4 rests;
};

// A corner of a piece of rope, or of its shadow. Vertex attributes of rope.vert.
struct RopeVertex {
    glm::vec4 at;     // m; side of the rope, −1 or 1
    glm::vec4 along;  // unit vector; half its width, m
};

// A corner of a shadow on the ground, or of light from windows. Vertex attributes of structure_shadow.vert.
struct StructureShadowVertex {
    glm::vec4 at;    // m; strength, 0 to 1
    glm::vec4 foot;  // m, of what casts it; 0: a shadow, 1: light
};

// Faces of a structure, or of a piece of a road or a lift, that are drawn together or not at all.
struct StructurePart {
    struct Range {
        std::uint32_t first = 0, count = 0;  // in StructureMesh::faces
    };
    Range near, far;  // with all details; as it is seen where a pixel is larger than they are
    glm::vec3 middle{0};
    float radius = 0;  // m, of a ball around its faces
};

// Triangles of structures, three vertices each.
struct StructureMesh {
    std::vector<StructureVertex> faces;
    std::vector<StructurePart> parts;
    std::vector<RopeVertex> ropes;
    std::vector<StructureShadowVertex> shadows;
};

// The ground that structures stand on, at tick 0.
struct BuildingGround {
    const sim::View& world;              // of which only what never changes is read
    std::span<const float> first_depth;  // m, of the standing layer, one value per vertex
    // Depth of the standing layer at tick 0, m, and share of the lower material at its surface.
    std::span<const glm::vec2> first_cover;
    glm::vec2 snowy;  // 1 if the upper and the lower material is snow, that lies on roofs
};

// BuildingGround::snowy of a world that looks like this.
glm::vec2 snowy(const Look& look);

// Makes the mesh. Equal arguments give equal meshes. `sun`: unit vector to the light that casts shadows, z > 0.
StructureMesh structure_mesh(const Structures& structures, const BuildingGround& ground,
                             const glm::vec3& sun);

}  // namespace render

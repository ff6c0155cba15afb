#pragma once

#include <array>
#include <span>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/core/grid.h"

namespace sim::front {

// A triangle mesh in the plane, with the edges that fronts may cross. Positions are in metres; vertices,
// edges and triangles are numbered from 0.
struct Mesh {
    struct Edge {
        int a, b;  // vertices, a < b
    };
    struct Spoke {
        int vertex, edge;  // the other end, and the edge to it
    };

    std::vector<glm::vec2> position;
    std::vector<std::array<int, 3>> triangle;       // corners, in the order given
    std::vector<std::array<int, 3>> triangle_edge;  // from each corner to the next
    std::vector<Edge> edge;
    std::vector<std::array<int, 2>> edge_triangle;  // on either side; -1 on the border
    std::vector<float> length;                      // of each edge, m
    std::vector<float> cell;                        // shortest edge at each vertex, m; 0 if it has none
    std::vector<Spoke> spokes;                      // by vertex, then by the other end's number
    std::vector<int> first_spoke;                   // for each vertex, plus one for the end

    // Vertices of a heightfield along x; 0 for other meshes. A heightfield's edges are numbered by kind:
    // along x row by row, along y, then the diagonals from lower left to upper right.
    int columns = 0;

    int vertices() const { return static_cast<int>(position.size()); }
    int edges() const { return static_cast<int>(edge.size()); }
    std::span<const Spoke> around(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {spokes.data() + first_spoke[v], spokes.data() + first_spoke[v + 1]};
    }
    glm::vec2 along(int e) const { return position[edge[e].b] - position[edge[e].a]; }  // from a to b, m
};

// Why triangles do not form a mesh, and where. The first fault found is reported.
struct MeshFault {
    enum class Kind {
        kNotFinite,        // vertex: a coordinate is infinite or NaN
        kNoSuchVertex,     // triangle: a corner does not exist
        kDegenerate,       // triangle: no area, or a side too short or too long
        kTooManyTriangles  // triangle: the third on one of its edges
    };
    Kind kind;
    int where;  // number of the vertex or triangle
};

// Builds a mesh from any triangles, in any orientation. Holes and separate parts are allowed.
std::variant<Mesh, MeshFault> mesh_of(std::vector<glm::vec2> position,
                                      std::vector<std::array<int, 3>> triangle);

// Builds the mesh of a heightfield: each square is split by the diagonal from its lower left corner.
Mesh mesh_of(const Grid& grid);

}  // namespace sim::front

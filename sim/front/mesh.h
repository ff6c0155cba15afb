#pragma once

#include <array>
#include <span>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/core/grid.h"

namespace sim::front {

// Triangles in the plane, with the edges that fronts cross. Positions in metres; vertices, edges and
// triangles are counted from 0.
struct Mesh {
    struct Edge {
        int a, b;  // vertices, a < b
    };
    struct Spoke {
        int vertex, edge;  // the other end, and what leads there
    };

    std::vector<glm::vec2> position;
    std::vector<std::array<int, 3>> triangle;       // corners, as they were given
    std::vector<std::array<int, 3>> triangle_edge;  // from each corner to the next
    std::vector<Edge> edge;
    std::vector<std::array<int, 2>> edge_triangle;  // on either side; -1: the edge is on the border
    std::vector<float> length;                      // of each edge, m
    std::vector<float> cell;                        // shortest edge at each vertex, m; 0: it has none
    std::vector<Spoke> spokes;                      // vertex after vertex, by the number of the other end
    std::vector<int> first_spoke;                   // of each vertex, and one more

    // Of a heightfield its vertices along x, else 0. A heightfield's edges are those along x, row after row,
    // then those along y, then the diagonals from lower left to upper right.
    int columns = 0;

    int vertices() const { return static_cast<int>(position.size()); }
    int edges() const { return static_cast<int>(edge.size()); }
    std::span<const Spoke> around(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {spokes.data() + first_spoke[v], spokes.data() + first_spoke[v + 1]};
    }
    glm::vec2 along(int e) const { return position[edge[e].b] - position[edge[e].a]; }  // from a to b, m
};

// Why triangles are no mesh, and where: the first that is found.
struct MeshFault {
    enum class Kind {
        kNotFinite,        // vertex: a coordinate is infinite or no number
        kNoSuchVertex,     // triangle: a corner that there is not
        kDegenerate,       // triangle: no area, or a side too short or too long
        kTooManyTriangles  // triangle: the third on one of its edges
    };
    Kind kind;
    int where;  // number of the vertex or triangle
};

// Any triangles, holes and separate parts among them, in any orientation.
std::variant<Mesh, MeshFault> mesh_of(std::vector<glm::vec2> position,
                                      std::vector<std::array<int, 3>> triangle);

// The mesh of a heightfield: each square in two triangles, by the diagonal from its lower left corner.
Mesh mesh_of(const Grid& grid);

}  // namespace sim::front

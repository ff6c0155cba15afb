// Decodes an index of the cut mesh. An index encodes all of its vertex, so that none is stored. With V
// vertices, E edges and T triangles:
//   0 … V − 1     the vertices of the mesh
//   V …           two for each edge: where the front crosses it, on the side of its vertex a and on that of its b
//   V + 2E …      three for each triangle that is cut on all its edges: the middle of its crossings, on the side of each corner

struct Triangle {
    int corner[3];
    int edge[3];  // from each corner to the next
};

layout(std430, binding = SLOT_MESH_POSITIONS) readonly buffer MeshPositions { vec2 mesh_positions[]; };
layout(std430, binding = SLOT_MESH_TRIANGLES) readonly buffer MeshTriangles { Triangle mesh_triangles[]; };
layout(std430, binding = SLOT_MESH_EDGES) readonly buffer MeshEdges { ivec2 mesh_edges[]; };
layout(std430, binding = SLOT_CROSSINGS) readonly buffer Crossings { float crossings[]; };

struct CutVertex {
    vec2 position;  // m
    int side;       // the vertex of the mesh itself, or the one on whose side of the front this copy lies
    bool on_front;  // a copy
};

int first_on_edges() { return mesh_positions.length(); }
int first_in_triangles() { return first_on_edges() + 2 * mesh_edges.length(); }

bool is_cut(int edge) { return crossings[edge] >= 0.0; }

// Computed from the edge's own a to b, so that both triangles beside it get the same bits. Nothing is fused
// or divided, here and below, so that the bits are those of sim/front/remesh_reference on every machine.
vec2 crossing_of(int edge) {
    vec2 a = mesh_positions[mesh_edges[edge].x], b = mesh_positions[mesh_edges[edge].y];
    precise vec2 at = a + crossings[edge] * (b - a);
    return at;
}

vec2 middle_of(int triangle) {
    const float kThird = 0.33333334;
    int edge[3] = mesh_triangles[triangle].edge;
    precise vec2 at = kThird * (crossing_of(edge[0]) + crossing_of(edge[1]) + crossing_of(edge[2]));
    return at;
}

// gl_VertexID of the cut mesh.
CutVertex cut_vertex(int index) {
    if (index < first_on_edges()) return CutVertex(mesh_positions[index], index, false);
    if (index < first_in_triangles()) {
        int number = index - first_on_edges(), edge = number >> 1;
        return CutVertex(crossing_of(edge), mesh_edges[edge][number & 1], true);
    }
    int number = index - first_in_triangles(), triangle = number / 3;
    return CutVertex(middle_of(triangle), mesh_triangles[triangle].corner[number % 3], true);
}

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/base/triangle_run.h"
#include "render/gl/gl_handle.h"
#include "sim/front/mesh.h"
#include "sim/front/tracker.h"

namespace render {

// Cuts a mesh along its fronts in shaders, bit-identical to sim/front/remesh_reference, vertex by vertex. No
// vertex is stored: a program puts cut_vertex.glsl before its vertex shader, which computes a vertex's
// position and side of the front from gl_VertexID.
class Remesher {
  public:
    // The number of triangles that fits the buffers of any OpenGL.
    static constexpr std::size_t kMostTriangles = 1'800'000;

    static tl::expected<Remesher, std::string> create(const std::filesystem::path& shaders);

    // Uploads an uncut mesh of 1 to kMostTriangles triangles. Allocates all buffers; later calls allocate
    // none.
    void send_mesh(const sim::front::Mesh& mesh);
    // Cuts the mesh at these points and nowhere else. They are a tracker's points, or none, with edges
    // ascending. The cost grows with their number, not with the mesh. Leaves one of its own programs current.
    void cut(std::span<const sim::front::Point> points);

    void bind() const;  // the buffers that cut_vertex.glsl reads
    // Draws all triangles with the current program, with the mesh's winding: the first piece of each, in their order,
    // then the further pieces, which have no order.
    void draw() const;
    // Draws the same of these runs of the mesh's triangles, which are ascending, and all further pieces.
    void draw(std::span<const TriangleRun> runs) {
        draw_first_pieces(runs);
        draw_further_pieces();
    }
    // Draws the first piece of each triangle of these runs: the triangle itself, if it is not cut.
    void draw_first_pieces(std::span<const TriangleRun> runs);
    // Draws the other pieces of all cut triangles.
    void draw_further_pieces() const;
    // Their number.
    int further_pieces() const { return further_pieces_; }

    // The indices of draw(), three per triangle. Waits for the GPU. For tests.
    std::vector<std::uint32_t> indices() const;

  private:
    struct ChangedEdge {
        std::int32_t edge;
        float crossing;  // 0.01 … 0.99 from a to b; below 0: no longer cut
    };

    void list_changes(std::span<const sim::front::Point> points);
    void add_change(int edge, float crossing);
    int further_pieces_of(int triangle) const;
    void run_over_changes() const;

    ProgramName cut_edges_, cut_triangles_;
    Buffer positions_, triangles_, edges_, crossings_, changed_edge_buffer_, changed_triangle_buffer_,
        indices_, command_;
    VertexArray vertices_;  // has no attributes, but holds the index buffer
    std::vector<std::array<int, 2>> edge_triangle_;
    std::vector<std::array<int, 3>> triangle_edge_;
    std::vector<std::uint8_t> is_cut_;   // of each edge
    std::vector<int> cut_, cut_before_;  // edges, ascending
    std::vector<ChangedEdge> changed_edges_;
    std::vector<std::int32_t> changed_triangles_;
    std::vector<std::uint8_t> is_listed_;  // of each triangle, while changes are listed
    GLuint uncut_count_ = 0;               // number of indices of the uncut mesh
    int further_pieces_ = 0;
    std::vector<GLsizei> run_counts_;  // while runs are drawn: numbers of indices
    std::vector<const void*> run_offsets_;
};

}  // namespace render

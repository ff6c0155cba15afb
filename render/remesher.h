#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "render/gl_handle.h"
#include "sim/front/mesh.h"
#include "sim/front/tracker.h"

namespace render {

// A mesh cut along its fronts by shaders: the triangles of sim/front/remesh_reference, vertex by vertex and
// bit by bit. No vertex is stored: whoever draws puts cut_vertex.glsl before a vertex shader, which makes of
// gl_VertexID where the vertex lies and on which side of the front.
class Remesher {
  public:
    // For which any OpenGL's buffers suffice.
    static constexpr std::size_t kMostTriangles = 1'800'000;

    static tl::expected<Remesher, std::string> create(const std::filesystem::path& shaders);

    // The mesh, cut nowhere yet. At least one triangle, at most kMostTriangles. Makes all buffers; nothing
    // after it makes any.
    void send_mesh(const sim::front::Mesh& mesh);
    // Cuts the mesh at these points and nowhere else: those of a tracker, or none; edges ascending. What it
    // costs grows with their number, not with the mesh. Leaves a program of its own current.
    void cut(std::span<const sim::front::Point> points);

    void bind() const;  // what cut_vertex.glsl reads
    // All triangles, with the program that is current; turned as those of the mesh are. Pieces have no order.
    void draw() const;

    // As draw() has them, three for each triangle; waits for the GPU. For tests.
    std::vector<std::uint32_t> indices() const;

  private:
    struct ChangedEdge {
        std::int32_t edge;
        float crossing;  // 0.01 … 0.99 from a to b; below 0: no longer cut
    };

    void list_changes(std::span<const sim::front::Point> points);
    void add_change(int edge, float crossing);
    void run_over_changes() const;

    ProgramName cut_edges_, cut_triangles_;
    Buffer positions_, triangles_, edges_, crossings_, changed_edge_buffer_, changed_triangle_buffer_,
        indices_, command_;
    VertexArray vertices_;  // none, but the indices hang on it
    std::vector<std::array<int, 2>> edge_triangle_;
    std::vector<int> cut_, cut_before_;  // edges, ascending
    std::vector<ChangedEdge> changed_edges_;
    std::vector<std::int32_t> changed_triangles_;
    std::vector<std::uint8_t> is_listed_;  // of each triangle, while changes are listed
    GLuint uncut_count_ = 0;               // of indices, where nothing is cut
};

}  // namespace render

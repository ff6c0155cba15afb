#include "render/passes/remesher.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "assets/shaders/slots.glsl"
#include "render/gl/program.h"
#include "sim/core/check.h"
#include "sim/front/remesh_reference.h"

namespace render {
namespace {

constexpr int kMostPieces = 6;  // of a triangle
constexpr std::array<int, 4> kFurtherPieces{0, 2, 2,
                                            5};  // of a triangle with so many cuts, as in cut_triangles.comp
constexpr std::size_t kTrianglesPerRun = 16;     // at least, on the whole
constexpr float kNotCut = -1;

const void* at_index(std::size_t index) {
    return in_buffer(index * sizeof(GLuint));
}

// The layout of glDrawElementsIndirect. Shaders see only the count, at SLOT_CUT_COUNT.
struct DrawCommand {
    GLuint count, instances, first_index;
    GLint first_vertex;
    GLuint first_instance;
};

// The layout of cut_vertex.glsl.
struct Triangle {
    std::array<std::int32_t, 3> corner, edge;
};

template <class T>
GLsizeiptr bytes(const std::vector<T>& values) {
    return static_cast<GLsizeiptr>(sizeof(T) * values.size());
}

template <class T>
Buffer buffer_of(const std::vector<T>& values) {
    return make_storage(sizeof(T) * values.size(), values.data());
}

// Binds the listed part of a buffer, so that shaders can read its length.
template <class T>
void send_list(GLuint slot, const Buffer& buffer, const std::vector<T>& values) {
    glNamedBufferSubData(buffer.name(), 0, bytes(values), values.data());
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, slot, buffer.name(), 0, bytes(values));
}

void run(const ProgramName& program, std::size_t threads) {
    glUseProgram(program.name());
    glDispatchCompute(static_cast<GLuint>((threads + GROUP_ROW - 1) / GROUP_ROW), 1, 1);
}

}  // namespace

tl::expected<Remesher, std::string> Remesher::create(const std::filesystem::path& shaders) {
    auto cut_edges = link_program(shaders, {{GL_COMPUTE_SHADER, {"slots.glsl", "cut_edges.comp"}}});
    if (!cut_edges) return tl::unexpected(cut_edges.error());
    auto cut_triangles =
        link_program(shaders, {{GL_COMPUTE_SHADER, {"slots.glsl", "cut_vertex.glsl", "cut_triangles.comp"}}});
    if (!cut_triangles) return tl::unexpected(cut_triangles.error());
    Remesher remesher;
    remesher.cut_edges_ = std::move(*cut_edges);
    remesher.cut_triangles_ = std::move(*cut_triangles);
    return remesher;
}

void Remesher::send_mesh(const sim::front::Mesh& mesh) {
    const std::size_t edges = mesh.edge.size(), triangles = mesh.triangle.size();
    CHECK(triangles > 0 && triangles <= kMostTriangles);
    edge_triangle_ = mesh.edge_triangle;
    triangle_edge_ = mesh.triangle_edge;
    is_cut_.assign(edges, 0);
    further_pieces_ = 0;
    run_counts_.reserve(triangles / kTrianglesPerRun + 1);
    run_offsets_.reserve(triangles / kTrianglesPerRun + 1);
    is_listed_.assign(triangles, 0);
    cut_.clear();
    for (std::vector<int>* list : {&cut_, &cut_before_}) list->reserve(edges);
    changed_edges_.reserve(edges);
    changed_triangles_.reserve(triangles);

    std::vector<Triangle> corners_and_edges;
    for (std::size_t t = 0; t < triangles; ++t)
        corners_and_edges.push_back({mesh.triangle[t], mesh.triangle_edge[t]});
    positions_ = buffer_of(mesh.position);
    triangles_ = buffer_of(corners_and_edges);
    edges_ = buffer_of(mesh.edge);
    crossings_ = buffer_of(std::vector<float>(edges, kNotCut));
    changed_edge_buffer_ = make_storage(sizeof(ChangedEdge) * edges);
    changed_triangle_buffer_ = make_storage(sizeof(std::int32_t) * triangles);

    uncut_count_ = static_cast<GLuint>(3 * triangles);
    const DrawCommand command{uncut_count_, 1, 0, 0, 0};
    command_ = make_storage(sizeof(command), &command);
    indices_ = make_storage(kMostPieces * sizeof(mesh.triangle[0]) * triangles);
    glNamedBufferSubData(indices_.name(), 0, bytes(mesh.triangle), mesh.triangle.data());
    vertices_ = make_vertex_array();
    glVertexArrayElementBuffer(vertices_.name(), indices_.name());
}

void Remesher::cut(std::span<const sim::front::Point> points) {
    list_changes(points);
    if (!changed_edges_.empty()) run_over_changes();
}

// Lists the edges that are cut, those that no longer are, and the triangles beside either.
void Remesher::list_changes(std::span<const sim::front::Point> points) {
    cut_.swap(cut_before_);
    cut_.clear();
    changed_edges_.clear();
    changed_triangles_.clear();
    auto before = cut_before_.begin();
    const auto add_gone_until = [&](int edge) {
        for (; before != cut_before_.end() && *before < edge; ++before) add_change(*before, kNotCut);
    };
    for (const sim::front::Point& point : points) {
        CHECK(cut_.empty() || cut_.back() < point.edge);
        add_gone_until(point.edge);
        if (before != cut_before_.end() && *before == point.edge) ++before;
        cut_.push_back(point.edge);
        add_change(point.edge, std::clamp(point.f, sim::front::kNearestToEnd, 1 - sim::front::kNearestToEnd));
    }
    add_gone_until(static_cast<int>(edge_triangle_.size()));
    // All cut triangles are listed.
    further_pieces_ = 0;
    for (const std::int32_t triangle : changed_triangles_) {
        is_listed_[triangle] = 0;
        further_pieces_ += further_pieces_of(triangle);
    }
}

int Remesher::further_pieces_of(int triangle) const {
    const auto [a, b, c] = triangle_edge_[triangle];
    return kFurtherPieces[is_cut_[a] + is_cut_[b] + is_cut_[c]];
}

void Remesher::add_change(int edge, float crossing) {
    changed_edges_.push_back({edge, crossing});
    is_cut_[edge] = crossing >= 0;
    for (const int triangle : edge_triangle_[edge])
        if (triangle >= 0 && is_listed_[triangle] == 0) {
            is_listed_[triangle] = 1;
            changed_triangles_.push_back(triangle);
        }
}

void Remesher::run_over_changes() const {
    bind();
    bind_storage(SLOT_CUT_INDICES, indices_);
    bind_storage(SLOT_CUT_COUNT, command_);
    send_list(SLOT_CHANGED_EDGES, changed_edge_buffer_, changed_edges_);
    send_list(SLOT_CHANGED_TRIANGLES, changed_triangle_buffer_, changed_triangles_);
    // Drop the pieces beyond the triangles' own slots: all triangles with pieces there are listed.
    glClearNamedBufferSubData(command_.name(), GL_R32UI, offsetof(DrawCommand, count), sizeof(GLuint),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &uncut_count_);
    run(cut_edges_, changed_edges_.size());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    run(cut_triangles_, changed_triangles_.size());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

void Remesher::bind() const {
    bind_storage(SLOT_MESH_POSITIONS, positions_);
    bind_storage(SLOT_MESH_TRIANGLES, triangles_);
    bind_storage(SLOT_MESH_EDGES, edges_);
    bind_storage(SLOT_CROSSINGS, crossings_);
}

void Remesher::draw() const {
    glBindVertexArray(vertices_.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command_.name());
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void Remesher::draw_first_pieces(std::span<const TriangleRun> runs) {
    if (runs.empty()) return;
    run_counts_.clear();
    run_offsets_.clear();
    for (const auto& [first, last] : runs) {
        run_counts_.push_back(3 * (last - first));
        run_offsets_.push_back(at_index(3 * static_cast<std::size_t>(first)));
    }
    glBindVertexArray(vertices_.name());
    glMultiDrawElements(GL_TRIANGLES, run_counts_.data(), GL_UNSIGNED_INT, run_offsets_.data(),
                        static_cast<GLsizei>(runs.size()));
}

void Remesher::draw_further_pieces() const {
    if (further_pieces_ == 0) return;
    glBindVertexArray(vertices_.name());
    glDrawElements(GL_TRIANGLES, 3 * further_pieces_, GL_UNSIGNED_INT, at_index(uncut_count_));
}

std::vector<std::uint32_t> Remesher::indices() const {
    DrawCommand command{};
    glGetNamedBufferSubData(command_.name(), 0, sizeof(command), &command);
    std::vector<std::uint32_t> values(command.count);
    glGetNamedBufferSubData(indices_.name(), 0, bytes(values), values.data());
    return values;
}

}  // namespace render

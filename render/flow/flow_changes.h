#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/flow/flow_vertices.h"
#include "sim/front/flow_view.h"

namespace render {

// Finds what of a flow is drawn otherwise than at the last call, by comparing it with a copy. The flow may have
// advanced, gone back to an earlier state, or be another one. The cost grows with the groups of vertices where anything
// ever moved, which are compared, and with what changed; later calls with one mesh allocate nothing.
class FlowChanges {
  public:
    // Vertices from `first` to before `last`.
    struct Range {
        int first, last;
    };

    // The flow's mesh is a heightfield.
    void find(const sim::front::FlowView& flow);
    // Lets the next call find that everything changed.
    void forget() { columns_ = 0; }

    std::span<const FlowVertex> vertices() const { return vertices_; }
    // Vertices that are drawn otherwise, ascending: another offset or mix of the vertex that each shows, another deposit
    // or stretch, another gradient beside a front, or a front that crosses one of its edges elsewhere. All of them, if
    // the mesh is new.
    std::span<const int> changed() const { return changed_; }
    // All vertices of which any byte of offsets, mix or FlowVertex changed, with others between them, ascending.
    std::span<const Range> ranges() const { return ranges_; }
    // Vertices beside fronts, or any byte of their gradients, changed.
    bool gradients_changed() const { return gradients_changed_; }

  private:
    struct Crossing {
        int edge;
        float at;
    };

    bool is_new(const sim::front::Mesh& mesh) const;
    void begin(const sim::front::Mesh& mesh);
    void remember(const sim::front::FlowView& flow);
    void compare_groups(const sim::front::FlowView& flow);
    void compare_in(std::size_t group, const sim::front::FlowView& flow);
    void compare_crossings(const sim::front::FlowView& flow);
    void compare_gradients(const sim::front::TextureLayers& layers);
    void describe_again(const sim::front::FlowView& flow);
    void number_beside(const sim::front::TextureLayers& layers);
    void remember_fronts(const sim::front::FlowView& flow);
    void add(int vertex);
    void add_near(int vertex);
    void mark_group(int vertex);
    void finish_lists();
    void find_ranges();

    int columns_ = 0;  // of the mesh; 0: none is known
    std::size_t count_ = 0;
    glm::vec2 end_{0};  // its last vertex, m

    // As drawn last.
    std::vector<sim::front::TextureLayers::Offsets> offsets_;
    std::vector<sim::front::TextureLayers::Mix> mixes_;
    std::vector<FlowVertex> vertices_;
    std::vector<std::uint8_t> touched_;  // groups
    std::vector<int> beside_;
    std::vector<sim::front::TextureLayers::Gradients> gradients_;
    std::vector<Crossing> crossings_;

    std::vector<int> changed_;
    std::vector<std::uint8_t> is_changed_;  // of each vertex, while changes are listed
    std::vector<int> repainted_;            // vertices whose offsets or mix changed
    std::vector<std::uint8_t> is_repainted_;
    std::vector<int> near_;  // vertices whose description may change
    std::vector<std::uint8_t> is_near_;
    std::vector<std::uint8_t> differs_;  // of each group: some byte changed
    std::vector<Range> ranges_;
    bool gradients_changed_ = false;
};

}  // namespace render

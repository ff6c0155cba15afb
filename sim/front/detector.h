#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/front/mesh.h"

namespace sim::front {

// Which edges a front crosses.
struct Rule {
    enum class Kind {
        kGradient,  // ‖v_b − v_a‖ ≥ max(threshold · length, jump): equation (1) of the paper
        kRelative,  // ‖v_b − v_a‖ ≥ max(jump, ratio · (‖v_a‖ + ‖v_b‖)): for what moves beside what rests
        kLevel  // the scalar lies above `level` at one end and not at the other
    };
    Kind kind = Kind::kGradient;
    float threshold = 0;  // M, 1/s, ≥ 0
    float jump = 0;       // J, m/s, ≥ 0
    float ratio = 0.7f;   // 0 … 1
    float level = 0;      // in the scalar's unit

    // An edge that is cut stays cut until the jump falls below this share of what cuts it, so that a flow at
    // the limit does not flicker. No level has it.
    float hold = 0.7f;  // 0 … 1
};

// For a grid of squares of `cell` metres and fronts across which velocity jumps by `jump`: a threshold by
// which diagonals qualify.
Rule gradient_rule(float jump, float cell);
// For avalanches: jump 0.3 m/s and ratio 0.7, held to 0.55.
Rule avalanche_rule();
// For a flow that is to be taken as having no fronts: nothing is ever cut.
Rule uncut_rule();

// What is known of a flow at one moment, at each vertex.
struct Flow {
    std::span<const glm::vec2> velocity;  // m/s
    std::span<const float> scalar;        // thickness of a rolling layer, say; may be empty but for kLevel
};

// Finds the edges that are cut, step after step, and what became of them since the step before.
class Detector {
  public:
    // The mesh must outlive it.
    Detector(const Mesh& mesh, const Rule& rule);

    // Looks at every edge once. Fields must have a value for each vertex of the mesh.
    void update(const Flow& flow);

    const Mesh& mesh() const { return mesh_; }
    const Rule& rule() const { return rule_; }

    std::span<const int> cut() const { return cut_; }  // edges, ascending
    bool is_cut(int edge) const { return slot_[edge] >= 0; }
    int slot(int edge) const { return slot_[edge]; }  // of a cut edge its place in cut(), else -1
    // Of each in cut() the place that it had there a step before; -1: it is cut since now.
    std::span<const int> before() const { return before_; }
    struct Gone {
        int edge, before;  // and the place it had in cut()
    };
    std::span<const Gone> vanished() const { return vanished_; }  // edges ascending
    // Vertices that a front passed: their own velocity jumped since the step before by what cuts an edge half
    // as long as the shortest at them, or their scalar crossed the level. Ascending.
    std::span<const int> flipped() const { return flipped_; }
    bool has_flipped(int vertex) const {
        return std::binary_search(flipped_.begin(), flipped_.end(), vertex);
    }

  private:
    float least_jump(float length) const;  // of velocity, that cuts an edge of this length, m/s
    void find_jumps(const Flow& flow);
    template <bool relative>
    void find_jumps(const glm::vec2* velocity);
    void find_crossings();
    void find_rises(const float* scalar);
    void find_jumps_in_time(const glm::vec2* velocity);
    template <class Test>
    void test_rows(const Test& test);
    template <class Look>
    void look_at_groups(const Look& look) const;
    void find_flips(const Flow& flow);
    void list_changes();

    const Mesh& mesh_;
    Rule rule_;
    bool first_ = true;
    std::vector<std::uint8_t> on_, was_on_;           // of each edge
    std::vector<glm::vec2> velocity_;                 // of the step before
    std::vector<std::uint8_t> above_, above_before_;  // of each vertex, the level
    std::vector<float> speed_;                        // of each vertex, m/s; of the relative rule alone
    std::vector<int> cut_, previous_, before_, flipped_, slot_;
    std::vector<Gone> vanished_;
    struct Range {
        std::size_t first, last;
    };
    std::vector<Range> with_cut_;  // edges among which some are cut
};

}  // namespace sim::front

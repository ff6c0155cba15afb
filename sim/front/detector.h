#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/front/mesh.h"
#include "sim/front/scan.h"

namespace sim::front {

// The rule by which an edge is a cut edge: an edge that a discontinuity front crosses.
struct Rule {
    enum class Kind {
        kGradient,  // ‖v_b − v_a‖ ≥ max(threshold · length, jump): equation (1) of the paper
        kRelative,  // ‖v_b − v_a‖ ≥ max(jump, ratio · (‖v_a‖ + ‖v_b‖)): for flow beside ground at rest
        kLevel  // the scalar is above `level` at one end only
    };
    Kind kind = Kind::kGradient;
    float threshold = 0;  // M, 1/s, ≥ 0
    float jump = 0;       // J, m/s, ≥ 0
    float ratio = 0.7f;   // 0 … 1
    float level = 0;      // in the scalar's unit

    // A cut edge stays cut until the jump falls below this share of the jump that cuts it, so that a flow at
    // the limit does not flicker. kLevel ignores it.
    float hold = 0.7f;  // 0 … 1
};

// The rule for a grid of squares of `cell` metres and fronts where velocity jumps by `jump`. Its threshold is
// low enough that diagonals qualify.
Rule gradient_rule(float jump, float cell);
// The rule for avalanches: jump 0.3 m/s and ratio 0.7, held to 0.55.
Rule avalanche_rule();
// The rule for a flow without fronts: no edge is ever cut.
Rule uncut_rule();

// The flow at one moment, at each vertex.
struct Flow {
    std::span<const glm::vec2> velocity;  // m/s, finite
    // e.g. thickness of a rolling layer; may be empty unless the rule is kLevel
    std::span<const float> scalar;
};

// Finds the cut edges in each step, and what became of those of the previous step.
class Detector {
  public:
    // The mesh must outlive the detector. Results do not depend on the instruction set, which the machine
    // must have.
    Detector(const Mesh& mesh, const Rule& rule, InstructionSet set = best_instruction_set());

    // Checks every edge once. Fields must have a value for each vertex of the mesh.
    void update(const Flow& flow);

    const Mesh& mesh() const { return mesh_; }
    const Rule& rule() const { return rule_; }

    std::span<const int> cut() const { return cut_; }  // edges, ascending
    bool is_cut(int edge) const { return slot_[edge] >= 0; }
    int slot(int edge) const { return slot_[edge]; }  // index of a cut edge in cut(), else -1
    // For each edge of cut(), its index in the previous step's cut(); -1: newly cut.
    std::span<const int> before() const { return before_; }
    struct Gone {
        int edge, before;  // `before`: its index in the previous cut()
    };
    std::span<const Gone> vanished() const { return vanished_; }  // edges ascending
    // Vertices that a front has passed: their own velocity jumped since the previous step by what cuts an
    // edge half as long as their shortest one, or their scalar crossed the level. Ascending.
    std::span<const int> flipped() const { return flipped_; }
    bool has_flipped(int vertex) const {
        return std::binary_search(flipped_.begin(), flipped_.end(), vertex);
    }

  private:
    using Word = scan::Word;
    // Edges of one kind. A heightfield has three: along x, along y and diagonal. An edge starts at vertex (x,
    // y), and bits are laid out like those of vertices. An irregular mesh has one kind, in one row.
    struct Family {
        int first_edge, columns, rows;
        int step;                 // from vertex a to vertex b
        std::size_t word, words;  // index of the first word; words per row
        float least;  // jump of velocity that cuts one of them (in an irregular mesh, the shortest), m/s
        std::size_t word_at(int x, int y) const {
            return word + static_cast<std::size_t>(y) * words + static_cast<std::size_t>(x / scan::kWord);
        }
    };

    void lay_families();
    float least_jump(float length) const;  // jump that cuts an edge of this length, m/s
    void scan(const glm::vec2* velocity);
    void scan_row(const glm::vec2* velocity, int y);
    void find_jumps(const glm::vec2* velocity);
    void find_jumps_one_by_one(const glm::vec2* velocity);
    bool jumps_enough(const glm::vec2& a, const glm::vec2& b, float least, bool was_cut) const;
    void find_flips(const glm::vec2* velocity);
    void find_above(const float* scalar);
    void find_crossings();
    void find_crossings_one_by_one();
    template <class Look>
    void each_word(const std::vector<Word>& words, const Look& look) const;
    template <class Look>
    void each_vertex(const std::vector<Word>& words, const Look& look) const;
    void list_changes();

    const Mesh& mesh_;
    Rule rule_;
    const scan::Kernels& kernels_;
    bool first_ = true;
    int columns_, rows_;  // of vertices; an irregular mesh has one row
    std::vector<Family> families_;
    float least_jump_ = 0, least_change_ = 0;  // least jump that may cut an edge; that may be a flip, m/s
    std::vector<Word> on_, was_on_;            // per edge: cut now, cut before
    std::vector<glm::vec2> velocity_;          // of the previous step, m/s
    std::vector<Word> above_, above_before_;   // per vertex: scalar above the level
    // Per vertex: velocity may jump from here; has jumped since the previous step; has changed at all.
    std::vector<Word> jumps_, changes_, others_;
    std::vector<int> cut_, before_, flipped_, slot_;
    std::vector<Gone> vanished_;
};

}  // namespace sim::front

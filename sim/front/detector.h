#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/front/mesh.h"
#include "sim/front/scan.h"

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
    std::span<const glm::vec2> velocity;  // m/s, finite
    std::span<const float> scalar;        // thickness of a rolling layer, say; may be empty but for kLevel
};

// Finds the edges that are cut, step after step, and what became of them since the step before.
class Detector {
  public:
    // The mesh must outlive it. Lists do not depend on the instruction set, which the machine must have.
    Detector(const Mesh& mesh, const Rule& rule, InstructionSet set = best_instruction_set());

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
    using Word = scan::Word;
    // Edges of one kind: in a heightfield those along x, along y and the diagonals, from vertex (x, y) on,
    // whose bits lie as those of vertices do; in an irregular mesh all, in one row.
    struct Family {
        int first_edge, columns, rows;
        int step;                 // from a to b
        std::size_t word, words;  // where its bits begin, and of a row
        float least;  // jump of velocity that cuts one of them, or of an irregular mesh's the shortest, m/s
        std::size_t word_at(int x, int y) const {
            return word + static_cast<std::size_t>(y) * words + static_cast<std::size_t>(x / scan::kWord);
        }
    };

    void lay_families();
    float least_jump(float length) const;  // of velocity, that cuts an edge of this length, m/s
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
    int columns_, rows_;  // of vertices; an irregular mesh's are one row
    std::vector<Family> families_;
    float least_jump_ = 0, least_change_ = 0;  // of velocity, that may cut an edge, that may be a flip, m/s
    std::vector<Word> on_, was_on_;            // of edges: which are cut
    std::vector<glm::vec2> velocity_;          // of the step before, m/s
    std::vector<Word> above_, above_before_;   // of vertices, the level
    // Of vertices: from which velocity may jump, whose has since the step before, whose is another at all.
    std::vector<Word> jumps_, changes_, others_;
    std::vector<int> cut_, before_, flipped_, slot_;
    std::vector<Gone> vanished_;
};

}  // namespace sim::front

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/triangle_run.h"
#include "render/flow/flow_vertices.h"
#include "render/view/look.h"
#include "sim/world/state.h"

namespace render {

// Finds the triangles of a heightfield's mesh that may show a flow, by the rules by which flow.vert hides a triangle, so
// that no other needs to be drawn. A triangle that flow.vert hides may still be among them, but none that it shows is
// left out. The triangles of square (x, y) are 2 (y (nx − 1) + x), beside its lower right corner, and the next one.
// Later calls on one grid allocate nothing.
class FlowTriangles {
  public:
    // flow.vert reads the change of the standing layer in steps of a 127th of MOST_CHANGE, rounded, and shows it from one
    // step on: from 1.97 mm. m.
    static constexpr float kLeastRise = 0.0018f;
    // Bits of a square.
    static constexpr std::uint8_t kLowerRight = 1, kUpperLeft = 2;

    // `undisturbed`: as in FrameInput. `vertices`: one per vertex of the world's grid. look.flow is set.
    void find(const sim::View& world, std::span<const float> undisturbed,
              std::span<const FlowVertex> vertices, const Look& look);

    // 1 or 0 of each vertex: whether the flow may be seen there. Unless the look has it everywhere.
    std::span<const std::uint8_t> seen() const { return seen_; }
    // The triangles, ascending, with some others in short gaps.
    std::span<const TriangleRun> runs() const { return runs_; }
    // Which triangles of each square may show the flow, row by row: now and at the last call. Before the first call on a
    // grid all did.
    std::span<const std::uint8_t> shown() const { return shown_; }
    std::span<const std::uint8_t> shown_before() const { return shown_before_; }

    // Adds triangles after all in `runs`. Joins them with the last run if the gap is short, because a run costs as much as
    // some dozens of hidden triangles.
    static void append(std::vector<TriangleRun>& runs, const TriangleRun& more);

  private:
    void mark_row(const sim::View& world, std::span<const float> undisturbed,
                  std::span<const FlowVertex> vertices, float visible, int y);
    void find_runs();

    sim::Grid grid_;
    std::vector<std::uint8_t> seen_;
    std::vector<std::uint8_t> shown_, shown_before_;
    std::vector<TriangleRun> runs_;
};

}  // namespace render

#pragma once

#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"
#include "sim/front/flow_view.h"
#include "sim/world/state.h"

namespace game {

// Smallest jump that cuts an edge of a test flow, m/s; across its fronts the jump is at least 0.14.
inline constexpr float kJump = 0.05f;

// Level ground, a unit square, with a flow and its textures.
class LevelFlow {
  public:
    // `squares` along each side. If not `cut`, the fronts are ignored.
    LevelFlow(int squares, bool cut);
    LevelFlow(const LevelFlow&) = delete;  // the view refers to the mesh
    LevelFlow& operator=(const LevelFlow&) = delete;

    // Steps from 0 s on, at 60 steps/s. Bit-identical for any number of workers.
    void advance(const sim::fields::TestFlow& flow, double seconds, sim::Workers& workers);

    // The share of the ground whose visible texture has a stretch above 2 (greatest over least).
    double drawn_out() const;

    sim::View ground() const { return sim::view(ground_); }
    const sim::front::FlowView& view() const { return view_; }

  private:
    sim::Grid grid_;
    sim::front::Mesh mesh_;
    sim::front::FlowView view_;
    sim::State ground_;
};

}  // namespace game

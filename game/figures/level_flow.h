#pragma once

#include "sim/core/workers.h"
#include "sim/fields/test_flows.h"
#include "sim/front/flow_view.h"
#include "sim/world/state.h"

namespace game {

// Cuts an edge of a test flow, m/s; across its fronts it is at least 0.14.
inline constexpr float kJump = 0.05f;

// Level ground, a unit square, that flows, and how its textures lie on it.
class LevelFlow {
  public:
    // `squares` along each side. Not `cut`: as if there were no fronts.
    LevelFlow(int squares, bool cut);
    LevelFlow(const LevelFlow&) = delete;  // the view refers to the mesh
    LevelFlow& operator=(const LevelFlow&) = delete;

    // From 0 s on, at 60 steps/s. However many workers: the same bits.
    void advance(const sim::fields::TestFlow& flow, double seconds, sim::Workers& workers);

    // The share of the ground whose texture, as it is seen, is drawn out: greatest over least stretch
    // above 2.
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

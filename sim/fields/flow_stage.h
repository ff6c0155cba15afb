#pragma once

#include <optional>
#include <vector>

#include "sim/fields/test_flows.h"
#include "sim/front/flow_view.h"

namespace sim::fields {

// The parameters of a test flow that may change while it runs.
struct FlowNumbers {
    double speed = 0.2;      // of the flow, sides of the square per second, 0 to 1
    double front_speed = 1;  // of the front, as a multiple of its usual speed, −4 to 4
    double smooth = 0;       // of an added smooth field, sides per second, 0 to 0.1
    bool cut = true;         // false: as if there were no fronts
    front::PointSource source = front::PointSource::kFit;
    bool operator==(const FlowNumbers&) const = default;
};

// Plays a test flow on a level square heightfield of any size, step after step. A view: it does not affect a
// world.
class FlowStage {
  public:
    // `flow` gives kind, angle and place; `numbers` gives the speeds. The grid must be square.
    FlowStage(const Grid& grid, const TestFlow& flow, const FlowNumbers& numbers);
    FlowStage(const FlowStage&) = delete;  // the view refers to the mesh
    FlowStage& operator=(const FlowStage&) = delete;

    // Takes effect in the next step. A change of `source` or `cut` starts a new view but keeps the textures.
    void set(const FlowNumbers& numbers);
    const FlowNumbers& numbers() const { return numbers_; }

    // Advances by `dt` seconds, in enough parts that no front moves more than 0.3 cells in one. A front that
    // jumps farther leaves both ends of an edge on one side.
    void advance(double dt, Workers& workers);

    const front::FlowView& view() const { return *view_; }

  private:
    void begin_view();

    Grid grid_;
    double side_;  // m
    TestFlow flow_;
    FlowNumbers numbers_;
    float jump_;  // jump of velocity that cuts an edge, m/s
    front::Mesh mesh_;
    std::optional<front::FlowView> view_;
    bool begins_anew_ = false;         // start a new view in the next step
    double front_time_ = 0;            // s
    std::vector<glm::vec2> velocity_;  // m/s
};

}  // namespace sim::fields

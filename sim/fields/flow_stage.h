#pragma once

#include <optional>
#include <vector>

#include "sim/fields/test_flows.h"
#include "sim/front/flow_view.h"

namespace sim::fields {

// What of a flow may change while it runs.
struct FlowNumbers {
    double speed = 0.2;      // of what flows, sides of the square per second, 0 to 1
    double front_speed = 1;  // of the front, times its usual, −4 to 4
    double smooth = 0;       // of a field without jumps on top, sides per second, 0 to 0.1
    bool cut = true;         // false: as if there were no fronts
    front::PointSource source = front::PointSource::kFit;
    bool operator==(const FlowNumbers&) const = default;
};

// A test flow on a level square heightfield of any size, played step after step. A view: nothing of it
// reaches a world.
class FlowStage {
  public:
    // `flow` tells kind, angle and place; its speeds are those of `numbers`. The grid is square.
    FlowStage(const Grid& grid, const TestFlow& flow, const FlowNumbers& numbers);
    FlowStage(const FlowStage&) = delete;  // the view refers to the mesh
    FlowStage& operator=(const FlowStage&) = delete;

    // From the next step on. Another source, and cuts or none, begin with the textures as they lie.
    void set(const FlowNumbers& numbers);
    const FlowNumbers& numbers() const { return numbers_; }

    // `dt` seconds on, in as many parts as it takes for no front to go farther than 0.3 cells in one: whoever
    // jumps farther leaves both ends of an edge on one side.
    void advance(double dt, Workers& workers);

    const front::FlowView& view() const { return *view_; }

  private:
    void begin_view();

    Grid grid_;
    double side_;  // m
    TestFlow flow_;
    FlowNumbers numbers_;
    float jump_;  // of velocity, by which an edge is cut, m/s
    front::Mesh mesh_;
    std::optional<front::FlowView> view_;
    bool begins_anew_ = false;         // the view, in the next step
    double front_time_ = 0;            // s
    std::vector<glm::vec2> velocity_;  // m/s
};

}  // namespace sim::fields

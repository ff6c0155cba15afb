#pragma once

#include <vector>

#include "sim/front/flow_view.h"
#include "sim/state.h"

namespace sim::front {

// The fronts of a world's rolling layer: where it is as deep as one sees it, and how its texture lies. A
// view.
class WorldFronts {
  public:
    // What is slower than this rests, m/s: its texture stays where it is.
    static constexpr float kLeastSpeed = 0.3f;

    // `visible`: how deep a rolling layer is to be seen, m, > 0.
    WorldFronts(const Grid& grid, float visible, const LayerRule& layers);
    WorldFronts(const WorldFronts&) = delete;  // what it is made of refers to its mesh
    WorldFronts& operator=(const WorldFronts&) = delete;

    // To the world as it is `dt` seconds later, > 0.
    void advance(const View& world, double dt, Workers& workers);

    const FlowView& view() const { return view_; }

  private:
    float visible_;
    Mesh mesh_;
    FlowView view_;
    std::vector<glm::vec2> velocity_;  // m/s; 0 where nothing is seen to move
    std::vector<float> rolling_;       // m
};

}  // namespace sim::front

#pragma once

#include <optional>
#include <vector>

#include "sim/front/flow_view.h"
#include "sim/world/state.h"

namespace game {

// The fronts of a world's rolling layer: where it is as deep as one sees it, and how its texture lies. A
// view.
class WorldFronts {
  public:
    // What is slower than this rests, m/s: its texture stays where it is.
    static constexpr float kLeastSpeed = 0.3f;

    // `visible`: how deep a rolling layer is to be seen, m, > 0. `first_depth`: how deep what lies was before
    // anything moved, m, grid.size() values; without them nothing is known to have come to lie.
    WorldFronts(const sim::Grid& grid, float visible, const sim::front::LayerRule& layers,
                std::vector<float> first_depth = {});
    WorldFronts(const WorldFronts&) = delete;  // what it is made of refers to its mesh
    WorldFronts& operator=(const WorldFronts&) = delete;

    // To the world as it is `dt` seconds later, > 0, in three stages: where its fronts are; textures with
    // them; and what is seen of these.
    void track(const sim::View& world, double dt, sim::Workers& workers);
    void carry(double dt, sim::Workers& workers) { view_->carry(flow(), dt, workers); }
    void settle(double dt, sim::Workers& workers) { view_->settle(dt, workers); }

    const sim::front::FlowView& view() const { return *view_; }
    // Of the moment that was tracked last: velocities, 0 where nothing is seen to move, and depths.
    sim::front::Flow flow() const { return {velocity_, rolling_}; }

    // How its textures lie, to come back to: fronts follow from the world alone.
    const sim::front::TextureLayers::Memory& memory() const { return view_->layers().memory(); }
    // `world` as it was then; what is seen is what was seen.
    void restore(const sim::View& world, const sim::front::TextureLayers::Memory& memory,
                 sim::Workers& workers);

  private:
    void begin();
    void read(const sim::View& world, sim::Workers& workers);

    float visible_;
    sim::front::LayerRule rule_;
    sim::front::Mesh mesh_;
    std::optional<sim::front::FlowView> view_;
    std::vector<glm::vec2> velocity_;        // m/s; 0 where nothing is seen to move
    std::vector<float> rolling_;             // m
    std::vector<float> first_depth_, rise_;  // m; empty: unknown
};

}  // namespace game

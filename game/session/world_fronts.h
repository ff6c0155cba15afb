#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/front/flow_view.h"
#include "sim/world/state.h"

namespace game {

// Tracks the visible front of the rolling layer and advects its texture. A view: never affects the world.
class WorldFronts {
  public:
    // Slower vertices count as at rest, m/s: their texture does not move.
    static constexpr float kLeastSpeed = 0.3f;

    // `visible`: least visible depth of the rolling layer, m, > 0. `undisturbed`: standing depth without what slid, m,
    // grid.size() values; if empty, deposits are unknown.
    WorldFronts(const sim::Grid& grid, float visible, const sim::front::LayerRule& layers,
                std::span<const float> undisturbed = {});
    WorldFronts(const WorldFronts&) = delete;  // members refer to mesh_
    WorldFronts& operator=(const WorldFronts&) = delete;

    // Advances to `world`, `dt` > 0 seconds later, in three stages: tracks fronts, advects textures, blends
    // them.
    void track(const sim::View& world, double dt, sim::Workers& workers);
    void carry(double dt, sim::Workers& workers) { view_->carry(flow(), dt, workers); }
    void settle(double dt, sim::Workers& workers) { view_->settle(dt, workers); }

    const sim::front::FlowView& view() const { return *view_; }
    // Velocity and depth of the world tracked last; velocity is 0 where no motion is visible.
    sim::front::Flow flow() const { return {velocity_, rolling_}; }

    // State of the textures, for a checkpoint. Fronts follow from the world alone.
    const sim::front::TextureLayers::Memory& memory() const { return view_->layers().memory(); }
    // Goes back to `memory`, taken when the world was `world`; restores the blend.
    void restore(const sim::View& world, const sim::front::TextureLayers::Memory& memory,
                 sim::Workers& workers);
    // Goes to `world` with textures that have never moved.
    void begin_anew(const sim::View& world, sim::Workers& workers);

  private:
    void begin();
    void read(const sim::View& world, sim::Workers& workers);

    float visible_;
    sim::front::LayerRule rule_;
    sim::front::Mesh mesh_;
    std::optional<sim::front::FlowView> view_;
    std::vector<glm::vec2> velocity_;     // m/s; 0 where no motion is visible
    std::vector<float> rolling_;          // m
    std::span<const float> undisturbed_;  // m; empty: unknown
    std::vector<float> rise_;             // m; of d above it
};

}  // namespace game

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "game/scene/goal.h"
#include "game/ui/facts.h"
#include "render/view/camera.h"
#include "sim/core/grid.h"

namespace game {

// The outlines of a challenge's zone, of the areas that it counts in, and of where its scene is going to act, as a camera
// sees them on the ground; and how much each of those areas has come to. All of one goal.
class GoalLines {
  public:
    // What the lines depend on, beside the goal.
    struct View {
        render::Camera camera;
        int width = 0, height = 0;  // px
        std::int64_t ground = 0;    // another number after the surface has changed
        bool operator==(const View&) const = default;
    };
    // Traces them anew if the view is another. `time`: the tick of the world, and its length, s. `seen`: where a place of
    // the ground is on the screen, px; nothing if it is hidden. `amount` is asked after the surface has changed.
    struct Time {
        std::int64_t tick = 0;
        double tick_s = 1;
    };
    void trace(const Goal& goal, const sim::Grid& grid, const View& view, const Time& time,
               const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
               const std::function<double(const Quantity&)>& amount);

    const std::vector<ui::GoalLine>& lines() const { return lines_; }
    const std::vector<ui::GoalEvent>& events() const { return events_; }
    const std::vector<ui::GoalCount>& counts() const { return counts_; }

  private:
    std::optional<View> view_;
    std::vector<ui::GoalLine> lines_;
    std::vector<ui::GoalEvent> events_;
    std::vector<ui::GoalCount> counts_;
    std::vector<double> amounts_;  // in each area that counts
};

}  // namespace game

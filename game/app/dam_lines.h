#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "game/ui/facts.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// What a dam near the cursor comes to, as a camera sees it: upright lines from where the ground was to the top of the earth
// that fills it up, its greatest height and its volume.
class DamLines {
  public:
    static constexpr int kReach = 24;  // cells around the cursor in which earth is looked for, east and north
    static constexpr float kLeastHeight = 0.5f;  // m, of earth that is hatched

    // What the lines depend on.
    struct View {
        render::Camera camera;
        int width = 0, height = 0;  // px
        int x = 0, y = 0;           // vertex under the cursor
        std::int64_t changed = 0;   // counts changes of the things that stand there
        bool operator==(const View&) const = default;
    };
    // Traces them anew if the view is another; what comes to lie on the dam alone does not. `cubic_metres`: of quanta times cells. `seen`: where a place is on the screen, px,
    // and nothing if the ground hides it; `on_screen`: the same for what the ground may hide.
    void trace(const sim::View& world, const View& view,
               const std::function<double(std::int64_t)>& cubic_metres,
               const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
               const std::function<std::optional<glm::dvec2>(glm::dvec3)>& on_screen);
    void clear();

    const std::vector<ui::GoalLine>& lines() const { return lines_; }
    const std::optional<ui::DamNote>& note() const { return note_; }

  private:
    std::optional<View> view_;
    std::vector<ui::GoalLine> lines_;
    std::optional<ui::DamNote> note_;
};

}  // namespace game

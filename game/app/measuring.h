#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "game/analysis/slide_history.h"
#include "game/controls/cross_section.h"
#include "game/session/session.h"
#include "game/ui/facts.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game {

// What is measured of one open world: a cross-section along a line that the user draws on the ground, and what moves over
// time. A view, which never affects the world.
class Measuring {
  public:
    // The next press on the terrain begins a line; or no longer.
    void wait_for_line(bool waits) { waits_ = waits; }
    // Whether a press on the terrain belongs to the line, and is no stroke.
    bool takes_press() const { return waits_ || from_; }
    // A line that is shorter than two cells is none, and the earlier one stays. `zero`: the height that is shown as 0.
    void press(glm::dvec2 at) { from_ = at; }
    void move_to(glm::dvec2 at, double cell, double zero);
    void release();

    // Call in each frame in which this is shown: reads the world along the line, and begins the history.
    void see(const Session& session, std::int64_t known_until);
    // Call after each tick: goes on with the history, once it has begun.
    void see_tick(const Session& session, std::int64_t known_until);
    const CrossSection& section() const { return section_; }
    const SlideHistory& history() const { return history_; }
    const std::vector<ui::HouseMark>& houses() const { return houses_; }

    // What the line on the screen depends on, beside the line.
    struct View {
        render::Camera camera;
        int width = 0, height = 0;  // px
        std::int64_t ground = 0;    // another number after the surface has changed
        bool operator==(const View&) const = default;
    };
    // Traces it anew if the view or the line is another. `seen`: where a place of the ground is on the screen, px;
    // nothing if it is hidden.
    void trace(const View& view, const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen);
    ui::SectionNote note() const { return {section_, takes_press(), pieces_, from_px_, to_px_}; }

  private:
    void trace_line(const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen);
    void trace_houses(const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen);

    bool waits_ = false;
    std::optional<glm::dvec2> from_;  // m, of the line that is being drawn
    CrossSection section_;
    SlideHistory history_;
    std::optional<View> view_;
    std::optional<SectionLine> traced_;
    std::vector<ui::GoalLine> pieces_;
    std::vector<ui::HouseMark> houses_;
    std::optional<glm::dvec2> from_px_, to_px_;
};

}  // namespace game

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "game/controls/brush.h"
#include "game/controls/events.h"
#include "game/scene/goal.h"
#include "sim/core/grid.h"
#include "sim/world/command.h"
#include "sim/world/params.h"

namespace game {

// The user's hand on the world: the tool in it, the stroke that it draws, and the parameters that it has set for
// the next tick. It becomes commands; nothing else of it reaches the world.
class Hand {
  public:
    const Brush& brush() const { return brush_; }
    void set(const Brush& brush) { brush_ = brush; }
    void choose(Tool tool) { brush_.tool = tool; }
    // Takes a tool that the challenge has, if it holds none of them, and brings it into the challenge's limits.
    void fit(const Goal& goal);
    // For another ground: a radius of 1/50 of it, but at least 2.5 cells so that the grid resolves it. All else as at first.
    void suit(const sim::Grid& grid);
    // Each step is a factor. Radius and strength stay within their ranges.
    void resize(double steps, const sim::Grid& grid);
    void strengthen(double steps);
    void pour_otherwise() {
        brush_.standing = !brush_.standing;
    }  // onto the standing layer, or into the rolling

    // What it does, or would do at a press.
    const Deed& deed(Modifiers with) const { return stroke_ ? stroke_->deed() : deed_of(brush_.tool, with); }

    void press(Modifiers with, glm::dvec2 at, double level, double cell);
    // The cursor is there, or off the terrain. After the release it no longer moves the stroke.
    void move_to(std::optional<glm::dvec2> at);
    void release();
    void drop() { stroke_.reset(); }  // ends the stroke at once
    const std::optional<Stroke>& stroke() const { return stroke_; }

    // Sets a parameter in the next tick. Returns what is wrong with it, if anything.
    std::optional<std::string> set_number(const sim::Params& params, std::size_t param, double value);
    // Forgets the parameters that are not set yet; false if there are none.
    bool drop_numbers();

    // The commands of tick `tick` of `ticks` in a frame, valid until the next call. `may_act`: false if the tick is
    // in the past, where parameters wait and strokes have ended.
    std::span<const sim::Command> commands_of(int tick, int ticks, double tick_s, bool may_act);
    // Whether the stroke has commands for a tick now. Parameters wait.
    bool would_act(double tick_s);
    // Whether it has had commands on this ground.
    bool has_acted() const { return has_acted_; }
    // Ends the ticks of a frame, of which `share` was done.
    void arrive(double share);

  private:
    Brush brush_;
    std::optional<Stroke> stroke_;
    bool has_acted_ = false;
    std::vector<sim::Command> numbers_;   // set for the next tick
    std::vector<sim::Command> commands_;  // of one tick; kept to reuse its memory
};

}  // namespace game

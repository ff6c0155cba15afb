#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "game/controls/tools.h"
#include "sim/core/grid.h"
#include "sim/world/command.h"

namespace game {

// The tool in the hand, and how it is set.
struct Brush {
    using Numbers = std::array<double, kMostToolNumbers>;

    Tool tool = Tool::kPour;
    double radius = 20;                                  // m, kLeastRadius to kMostRadius
    std::array<Numbers, kTools> numbers = usual_ones();  // of each tool, as in its row (tools.h)
    bool standing = false;             // pour onto the standing layer, else into the rolling layer
    sim::Part of = sim::Part::kUpper;  // which material is poured, in a world with two
    double turn = 0;                   // degrees, of the next house; 0 north, 90 east
    // Of the ground, degrees: vertices outside are left alone.
    double least_slope = sim::Command::kNoLeast, most_slope = sim::Command::kNoMost;

    static constexpr double kLeastRadius = 0.1, kMostRadius = 1000;
    static std::array<Numbers, kTools> usual_ones();
    Numbers& own() { return numbers[static_cast<std::size_t>(tool)]; }
    const Numbers& of_tool(Tool which) const { return numbers[static_cast<std::size_t>(which)]; }
    const Numbers& own() const { return of_tool(tool); }
    bool operator==(const Brush&) const = default;
};

// Useful radii on a grid, m: half a cell to half of the terrain, within the brush's own range.
struct RadiusRange {
    double least, most;
};
RadiusRange radius_range(const sim::Grid& grid);

// Radius of the ring that shows what a deed reaches, m.
double ring_radius(const Brush& brush, const Deed& deed, const sim::Grid& grid);

// A stroke, from button press to release, converted to commands tick by tick in world units.
class Stroke {
  public:
    // Begins at a place, m, with the modifiers that are held there; it keeps its tool to its end. `level`: height of
    // the ground there above the terrain's zero, m. `cell`: m, of the grid.
    Stroke(Tool tool, Modifiers with, glm::dvec2 at, double level = 0, double cell = 1)
        : tool_(tool),
          deed_(&deed_of(tool, with)),
          level_(level),
          cell_(cell),
          first_(at),
          from_(at),
          to_(at) {}

    const Deed& deed() const { return *deed_; }
    glm::dvec2 first() const { return first_; }

    // Sets the cursor position, m; nothing while the cursor is off the terrain.
    void move_to(std::optional<glm::dvec2> at) { to_ = at; }
    // The button is released: the next commands are the last ones.
    void release() { released_ = true; }
    bool released() const { return released_; }
    // Where the piece of a line begins that the next commands may build.
    std::optional<glm::dvec2> line_from() const;
    // The direction in which a house was turned, degrees.
    std::optional<double> turn() const { return turned_; }

    // Adds the commands of tick `tick` of `ticks`. The ticks share the path since the last arrive() evenly. A path
    // longer than half a radius per tick is filled with several discs that share the amount; a path longer than
    // eight radii is a jump.
    void commands_of(int tick, int ticks, const Brush& brush, double tick_s,
                     std::vector<sim::Command>& commands);
    // Ends the ticks of a frame, or the completed `share` of them; the next path begins there.
    void arrive(double share);

  private:
    sim::Command command(const Brush& brush, glm::dvec2 at) const;
    void spread(glm::dvec2 from, glm::dvec2 to, const Brush& brush, double tick_s,
                std::vector<sim::Command>& commands);
    void burst(glm::dvec2 at, const Brush& brush, std::vector<sim::Command>& commands);
    void place(glm::dvec2 at, const Brush& brush, std::vector<sim::Command>& commands);
    void line(glm::dvec2 to, const Brush& brush, std::vector<sim::Command>& commands);

    Tool tool_;
    const Deed* deed_;
    double level_, cell_;
    glm::dvec2 first_;  // of the piece, if it draws a line
    std::optional<glm::dvec2> from_, to_;
    std::optional<glm::dvec2> last_;  // position of the last command that acts at once
    std::optional<double> turned_;
    bool released_ = false;
};

}  // namespace game

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "sim/core/grid.h"
#include "sim/world/command.h"

namespace game {

enum class Tool { kPour, kDig, kBlast };
inline constexpr std::size_t kTools = 3;

// What the left button does to the ground.
struct Brush {
    Tool tool = Tool::kPour;
    double radius = 20;  // m, kLeastRadius to kMostRadius
    // Strength of each tool: m of depth per second for pour and dig, m of depth at once for blast;
    // kLeastStrength to kMostStrength.
    std::array<double, kTools> strength{2, 2, 1};
    bool standing = false;             // pour onto the standing layer, else into the rolling layer
    sim::Part of = sim::Part::kUpper;  // which material is poured, in a world with two

    static constexpr double kLeastRadius = 0.1, kMostRadius = 1000;
    static constexpr double kLeastStrength = 0.05, kMostStrength = 20;
    double& amount() { return strength[static_cast<std::size_t>(tool)]; }
    double amount() const { return strength[static_cast<std::size_t>(tool)]; }
    bool operator==(const Brush&) const = default;
};

// Useful radii on a grid, m: half a cell to half of the terrain, within the brush's own range.
struct RadiusRange {
    double least, most;
};
RadiusRange radius_range(const sim::Grid& grid);

// The command of a brush. Inverted (Ctrl), pour and dig are swapped and blast becomes settle.
sim::CommandKind deed_of(const Brush& brush, bool inverted);

// A stroke, from button press to release, converted to commands tick by tick in world units.
class Stroke {
  public:
    Stroke(sim::CommandKind deed, glm::dvec2 at) : deed_(deed), from_(at), to_(at) {}

    sim::CommandKind deed() const { return deed_; }

    // Sets the cursor position, m; nothing while the cursor is off the terrain.
    void move_to(std::optional<glm::dvec2> at) { to_ = at; }

    // Adds the commands of tick `tick` of `ticks`. The ticks share the path since the last arrive() evenly. A
    // path longer than half a radius per tick is filled with several discs that share the amount; a path
    // longer than eight radii is a jump. Blast and settle act at the press, and again after each radius of
    // movement.
    void commands_of(int tick, int ticks, const Brush& brush, double tick_s,
                     std::vector<sim::Command>& commands);
    // Ends the ticks of a frame, or the completed `share` of them; the next path begins there.
    void arrive(double share);

  private:
    void burst(glm::dvec2 at, const Brush& brush, std::vector<sim::Command>& commands);
    void spread(glm::dvec2 from, glm::dvec2 to, const Brush& brush, double tick_s,
                std::vector<sim::Command>& commands);

    sim::CommandKind deed_;
    std::optional<glm::dvec2> from_, to_;
    std::optional<glm::dvec2> last_burst_;  // position of the last blast or settle
};

}  // namespace game

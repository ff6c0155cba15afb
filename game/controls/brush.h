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
    // How much, by tool, so that each keeps its own: metres of depth per second for pour and dig, metres of
    // depth at once for blast; kLeastStrength to kMostStrength.
    std::array<double, kTools> strength{2, 2, 1};
    bool standing = false;             // pour onto the standing layer; else into the rolling one
    sim::Part of = sim::Part::kUpper;  // which material is poured, in a world of two

    static constexpr double kLeastRadius = 0.1, kMostRadius = 1000;
    static constexpr double kLeastStrength = 0.05, kMostStrength = 20;
    double& amount() { return strength[static_cast<std::size_t>(tool)]; }
    double amount() const { return strength[static_cast<std::size_t>(tool)]; }
    bool operator==(const Brush&) const = default;
};

// Radii that make sense on a grid, m: from half a cell to half of the terrain, within the brush's own.
struct RadiusRange {
    double least, most;
};
RadiusRange radius_range(const sim::Grid& grid);

// What a brush does to the world, inverted (Ctrl) or not: pour and dig change places, a blast becomes a
// settle.
sim::CommandKind deed_of(const Brush& brush, bool inverted);

// A stroke, from the press of the button to its release, told as commands tick by tick in world units.
class Stroke {
  public:
    Stroke(sim::CommandKind deed, glm::dvec2 at) : deed_(deed), from_(at), to_(at) {}

    sim::CommandKind deed() const { return deed_; }

    // Where the hand is now, m; nothing while it is off the ground.
    void move_to(std::optional<glm::dvec2> at) { to_ = at; }

    // Adds what the `tick`-th of `ticks` ticks owes, which share the way since the last arrive() evenly. A
    // way that is longer than half a radius in one tick is filled with several discs that share the amount;
    // one of more than eight radii is a jump. Blast and settle go off at the press, and again wherever the
    // hand has gone on by a radius.
    void commands_of(int tick, int ticks, const Brush& brush, double tick_s,
                     std::vector<sim::Command>& commands);
    // The ticks of a frame are done, or that share of them that the machine could do; the next way begins
    // there.
    void arrive(double share);

  private:
    void burst(glm::dvec2 at, const Brush& brush, std::vector<sim::Command>& commands);
    void spread(glm::dvec2 from, glm::dvec2 to, const Brush& brush, double tick_s,
                std::vector<sim::Command>& commands);

    sim::CommandKind deed_;
    std::optional<glm::dvec2> from_, to_;
    std::optional<glm::dvec2> last_burst_;  // where blast or settle went off last
};

}  // namespace game

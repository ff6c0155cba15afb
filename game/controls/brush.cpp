#include "game/controls/brush.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace game {
namespace {

// Per tick. A path that needs more is a jump of the cursor, for example from one ridge to the next, not a
// stroke.
constexpr double kMostDiscs = 16;

}  // namespace

RadiusRange radius_range(const sim::Grid& grid) {
    const auto dx = static_cast<double>(grid.dx);
    const double extent = dx * (std::max(grid.nx, grid.ny) - 1);
    const double least = std::clamp(dx / 2, Brush::kLeastRadius, Brush::kMostRadius);
    return {least, std::clamp(extent / 2, least, Brush::kMostRadius)};
}

sim::CommandKind deed_of(const Brush& brush, bool inverted) {
    switch (brush.tool) {
        case Tool::kPour:
            return inverted ? sim::CommandKind::kDig : sim::CommandKind::kPour;
        case Tool::kDig:
            return inverted ? sim::CommandKind::kPour : sim::CommandKind::kDig;
        case Tool::kBlast:
            break;
    }
    return inverted ? sim::CommandKind::kSettle : sim::CommandKind::kBlast;
}

void Stroke::arrive(double share) {
    from_ = from_ && to_ ? *from_ + share * (*to_ - *from_) : to_;
}

void Stroke::commands_of(int tick, int ticks, const Brush& brush, double tick_s,
                         std::vector<sim::Command>& commands) {
    if (!to_) return;
    const glm::dvec2 from = from_.value_or(*to_);
    const auto along = [&](double share) { return from + share * (*to_ - from); };
    const double first = static_cast<double>(tick) / ticks, last = static_cast<double>(tick + 1) / ticks;
    if (deed_ == sim::CommandKind::kBlast || deed_ == sim::CommandKind::kSettle)
        burst(along(last), brush, commands);
    else
        spread(along(first), along(last), brush, tick_s, commands);
}

// Blast and settle act at once, so they repeat by distance, not by time.
void Stroke::burst(glm::dvec2 at, const Brush& brush, std::vector<sim::Command>& commands) {
    if (last_burst_ && glm::distance(*last_burst_, at) < brush.radius) return;
    last_burst_ = at;
    sim::Command command;
    command.kind = deed_;
    command.x = at.x;
    command.y = at.y;
    command.radius = brush.radius;
    if (deed_ == sim::CommandKind::kBlast) command.depth = brush.amount();
    commands.push_back(command);
}

void Stroke::spread(glm::dvec2 from, glm::dvec2 to, const Brush& brush, double tick_s,
                    std::vector<sim::Command>& commands) {
    const double wanted = std::max(1.0, std::ceil(2 * glm::distance(from, to) / brush.radius));
    const int discs = wanted > kMostDiscs ? 1 : static_cast<int>(wanted);
    sim::Command command;
    command.kind = deed_;
    command.radius = brush.radius;
    command.duration = tick_s;
    command.rate = brush.amount() / discs;  // m/s of depth
    if (deed_ == sim::CommandKind::kPour) {
        command.rate *= 3.14159265358979323846 * brush.radius * brush.radius;  // m³/s
        command.layer = brush.standing ? sim::Layer::kStanding : sim::Layer::kRolling;
        command.of = brush.of;
    }
    for (int i = 1; i <= discs; ++i) {
        const glm::dvec2 at = from + (static_cast<double>(i) / discs) * (to - from);
        command.x = at.x;
        command.y = at.y;
        commands.push_back(command);
    }
}

}  // namespace game

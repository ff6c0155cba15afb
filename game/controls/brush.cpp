#include "game/controls/brush.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace game {
namespace {

using sim::Command;

// Per tick. A path that needs more is a jump of the cursor, for example from one ridge to the next, not a
// stroke.
constexpr double kMostDiscs = 16;
constexpr double kPiecesOfLine = 4;   // cells, the length of a piece of a line
constexpr double kShortestPiece = 1;  // m
constexpr double kTurnsFrom = 0.5;    // cells; nearer to the middle of a house the hand does not turn it
constexpr double kTurnStep = 2;       // degrees

}  // namespace

std::array<Brush::Numbers, kTools> Brush::usual_ones() {
    std::array<Numbers, kTools> usual{};
    for (std::size_t tool = 0; tool < kTools; ++tool) {
        const auto numbers = tool_infos()[tool].numbers;
        for (std::size_t i = 0; i < numbers.size(); ++i) usual[tool][i] = numbers[i].usual;
    }
    return usual;
}

RadiusRange radius_range(const sim::Grid& grid) {
    const auto dx = static_cast<double>(grid.dx);
    const double extent = dx * (std::max(grid.nx, grid.ny) - 1);
    const double least = std::clamp(dx / 2, Brush::kLeastRadius, Brush::kMostRadius);
    return {least, std::clamp(extent / 2, least, Brush::kMostRadius)};
}

double ring_radius(const Brush& brush, const Deed& deed, const sim::Grid& grid) {
    if (takes(deed.kind, &Command::radius)) return brush.radius;
    double length = 0, width = 0;
    const auto numbers = info_of(brush.tool).numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i].member == &Command::length) length = brush.own()[i];
        if (numbers[i].member == &Command::width) width = brush.own()[i];
    }
    return std::max(std::hypot(length, width) / 2, static_cast<double>(grid.dx) / 2);
}

void Stroke::arrive(double share) {
    from_ = from_ && to_ ? *from_ + share * (*to_ - *from_) : to_;
}

std::optional<glm::dvec2> Stroke::line_from() const {
    const bool draws = deed_->acts == Acts::kByPieces || deed_->acts == Acts::kAtRelease;
    return draws ? std::optional(first_) : std::nullopt;
}

void Stroke::commands_of(int tick, int ticks, const Brush& brush, double tick_s,
                         std::vector<Command>& commands) {
    if (!to_) return;
    const glm::dvec2 from = from_.value_or(*to_);
    const auto along = [&](double share) { return from + share * (*to_ - from); };
    const double first = static_cast<double>(tick) / ticks, last = static_cast<double>(tick + 1) / ticks;
    switch (deed_->acts) {
        case Acts::kAllTheTime:
            return spread(along(first), along(last), brush, tick_s, commands);
        case Acts::kByDistance:
            return burst(along(last), brush, commands);
        case Acts::kAtPress:
        case Acts::kAndTurns:
            return place(*to_, brush, commands);
        case Acts::kByPieces:
        case Acts::kAtRelease:
            return line(*to_, brush, commands);
    }
}

// With the members that its kind takes.
Command Stroke::command(const Brush& brush, glm::dvec2 at) const {
    Command command;
    const sim::CommandInfo& info = sim::info_of(deed_->kind);
    command.kind = deed_->kind;
    command.x = at.x, command.y = at.y;
    const auto set = [&](double Command::*member, double value) {
        if (takes(deed_->kind, member)) command.*member = value;
    };
    const auto numbers = info_of(tool_).numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) set(numbers[i].member, brush.of_tool(tool_)[i]);
    set(&Command::radius, brush.radius);
    set(&Command::level, level_);
    set(&Command::turn, brush.turn);
    if (info.has_layer) command.layer = brush.standing ? sim::Layer::kStanding : sim::Layer::kRolling;
    if (info.has_part) command.of = brush.of;
    if (info.has_slope) command.least_slope = brush.least_slope, command.most_slope = brush.most_slope;
    return command;
}

void Stroke::spread(glm::dvec2 from, glm::dvec2 to, const Brush& brush, double tick_s,
                    std::vector<Command>& commands) {
    const double wanted = std::max(1.0, std::ceil(2 * glm::distance(from, to) / brush.radius));
    const int discs = wanted > kMostDiscs ? 1 : static_cast<int>(wanted);
    Command each = command(brush, from);
    double amount = brush.of_tool(tool_)[0] / discs;  // m/s of depth
    if (deed_->amount == Amount::kVolumePerSecond)
        amount *= 3.14159265358979323846 * brush.radius * brush.radius;
    if (deed_->amount == Amount::kPerTick) amount *= tick_s;
    if (deed_->amount == Amount::kTakenPerTick) amount *= -tick_s;
    if (takes(deed_->kind, &Command::rate)) each.rate = amount;
    if (takes(deed_->kind, &Command::rise)) each.rise = amount;
    if (takes(deed_->kind, &Command::duration)) each.duration = tick_s;
    for (int i = 1; i <= discs; ++i) {
        const glm::dvec2 at = from + (static_cast<double>(i) / discs) * (to - from);
        each.x = at.x, each.y = at.y;
        commands.push_back(each);
    }
}

// What acts at once repeats by distance, not by time.
void Stroke::burst(glm::dvec2 at, const Brush& brush, std::vector<Command>& commands) {
    if (last_ && glm::distance(*last_, at) < brush.radius) return;
    last_ = at;
    commands.push_back(command(brush, at));
}

void Stroke::place(glm::dvec2 at, const Brush& brush, std::vector<Command>& commands) {
    const glm::dvec2 way = at - first_;
    std::optional<double> turn;
    if (deed_->acts == Acts::kAndTurns && glm::length(way) >= kTurnsFrom * cell_)
        turn = std::round(glm::degrees(std::atan2(way.x, way.y)) / kTurnStep) * kTurnStep;
    if (!last_) {
        Command placed = command(brush, first_);
        if (turn) placed.turn = *turn;
        commands.push_back(placed);
    } else if (turn && turn != turned_) {
        Command turned;
        turned.kind = sim::CommandKind::kTurn;
        turned.x = first_.x, turned.y = first_.y;
        turned.turn = *turn;
        commands.push_back(turned);
    }
    last_ = first_;
    if (turn) turned_ = turn;
}

void Stroke::line(glm::dvec2 to, const Brush& brush, std::vector<Command>& commands) {
    const double length = glm::distance(first_, to);
    const bool whole = deed_->acts == Acts::kByPieces && length >= kPiecesOfLine * cell_;
    const bool rest = released_ && length >= kShortestPiece;
    if (!whole && !rest) return;
    Command piece = command(brush, first_);
    piece.to_x = to.x, piece.to_y = to.y;
    commands.push_back(piece);
    first_ = to;
}

}  // namespace game

#include "game/app/goal_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <glm/common.hpp>

namespace game {
namespace {

constexpr int kPoints = 128, kPointsOfEvent = 24;  // around an area
constexpr std::size_t kMostEvents = 8;             // that are shown, the next first

// Areas may reach beyond the grid, and their outlines end at its border.
std::vector<glm::dvec2> outline_of(const Area& area, int count, glm::dvec2 most) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= count; ++i) {
        glm::dvec2 at;
        if (area.shape == Area::Shape::kEllipse) {
            const double angle = 2 * std::numbers::pi * i / count;
            at = area.from + area.to * glm::dvec2(std::cos(angle), std::sin(angle));
        } else {
            const glm::dvec2 low = glm::clamp(glm::min(area.from, area.to), glm::dvec2(0), most),
                             high = glm::clamp(glm::max(area.from, area.to), glm::dvec2(0), most);
            const double along = 4.0 * i / count, share = along - std::floor(along);
            const glm::dvec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}, low, low};
            const auto side = static_cast<std::size_t>(along);
            at = glm::mix(corners[side], corners[side + 1], share);
        }
        points.push_back(glm::clamp(at, glm::dvec2(0), most));
    }
    return points;
}

std::vector<Quantity> counted_in_areas(const Goal& goal) {
    std::vector<Quantity> counted;
    const auto add = [&](const Quantity& quantity) {
        if (quantity.area && std::ranges::find(counted, quantity) == counted.end())
            counted.push_back(quantity);
    };
    for (const Goal::Need& need : goal.needs) add(need.quantity);
    for (const Goal::Term& term : goal.score) add(term.quantity);
    return counted;
}

// Where its count is told: inside, near its northern end, on the map.
glm::dvec2 place_for_count(const Area& area, glm::dvec2 most) {
    constexpr double kUp = 0.9;  // of the way from south to north
    const bool ellipse = area.shape == Area::Shape::kEllipse;
    const glm::dvec2 low = ellipse ? area.from - area.to : glm::min(area.from, area.to),
                     high = ellipse ? area.from + area.to : glm::max(area.from, area.to);
    return glm::mix(glm::clamp(low, glm::dvec2(0), most), glm::clamp(high, glm::dvec2(0), most),
                    glm::dvec2(0.5, kUp));
}

}  // namespace

void GoalLines::trace(const Goal& goal, const sim::Grid& grid, const View& view, const Time& time,
                      const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
                      const std::function<double(const Quantity&)>& amount) {
    if (view_ == view) return;
    const bool counts_anew = !view_ || view_->ground != view.ground;
    view_ = view;
    lines_.clear();
    const glm::dvec2 most = static_cast<double>(grid.dx) * glm::dvec2(grid.nx - 1, grid.ny - 1);
    events_.clear();
    using Around = ui::GoalLine::Around;
    const auto add = [&](const Area& area, Around around) {
        std::optional<glm::dvec2> before;
        bool dash = false;
        for (const glm::dvec2 place :
             outline_of(area, around == Around::kEvent ? kPointsOfEvent : kPoints, most)) {
            const auto at = seen(place);
            dash = !dash;
            if (at && before && dash) lines_.push_back({*before, *at, around});
            before = at;
        }
    };
    const std::vector<Quantity> counted = counted_in_areas(goal);
    if (counts_anew) {
        amounts_.clear();
        std::ranges::transform(counted, std::back_inserter(amounts_), amount);
    }
    counts_.clear();
    for (std::size_t i = 0; i < counted.size(); ++i) {
        add(*counted[i].area, Around::kCounted);
        if (const auto at = seen(place_for_count(*counted[i].area, most)))
            counts_.push_back({*at, amounts_[i], counted[i].measure == Measure::kRemoved});
    }
    if (goal.zone && std::ranges::find(counted, goal.zone, &Quantity::area) == counted.end())
        add(*goal.zone, Around::kZone);
    for (const TimedCommand& event : goal.events) {
        if (events_.size() == kMostEvents) break;
        const sim::Command& command = event.command;
        if (event.tick <= time.tick || !(command.radius > 0)) continue;
        const glm::dvec2 place(command.x, command.y);
        add({Area::Shape::kEllipse, place, glm::dvec2(command.radius)}, Around::kEvent);
        if (const auto at = seen(place))
            events_.push_back({*at, static_cast<double>(event.tick - time.tick) * time.tick_s});
    }
}

}  // namespace game

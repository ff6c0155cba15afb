#include "game/scene/goal_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "sim/initial_state.h"
#include "sim/world/quanta.h"

namespace game {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr double kPerHectare = 1e4;   // m²
constexpr double kThousandth = 1e-3;  // of a measure, in its unit

// What a measure can be, in its unit; `why` ends the sentence that tells its most.
struct Bounds {
    double least = 0, most = kNoEnd;
    std::string why;
};

class Reachable {
  public:
    explicit Reachable(const Scenario& scenario)
        : scenario_(scenario),
          goal_(*scenario.goal),
          state_(sim::make_state(initial_state_of(scenario), scenario.params)) {}

    std::optional<ReachFault> fault() const {
        if (goal_.zone && !touches_grid(*goal_.zone))
            return ReachFault{"", 0, "zone", "lies beside the grid"};
        for (std::size_t i = 0; i < goal_.needs.size(); ++i)
            if (auto wrong = fault_of_need(i)) return wrong;
        for (std::size_t i = 0; i < goal_.score.size(); ++i)
            if (lacks_vertex(goal_.score[i].quantity))
                return ReachFault{"score", i, "area", "has no vertex of the grid inside"};
        const double greatest = greatest_score();
        if (static_cast<double>(goal_.medals.back()) <= greatest + 0.5) return std::nullopt;
        return ReachFault{
            "", 0, "medals",
            fmt::format("go up to {}, and no try can score more than {:.0f}", goal_.medals.back(), greatest)};
    }

  private:
    std::optional<ReachFault> fault_of_need(std::size_t i) const {
        const Goal::Need& need = goal_.needs[i];
        if (lacks_vertex(need.quantity))
            return ReachFault{"need", i, "area", "has no vertex of the grid inside"};
        const Bounds bounds = bounds_of(need.quantity);
        if (need.least && *need.least > bounds.most + kThousandth)
            return ReachFault{"need", i, "least", fmt::format("is {:g}, and {}", *need.least, bounds.why)};
        if (need.most && *need.most < bounds.least - kThousandth)
            return ReachFault{"need", i, "most",
                              fmt::format("is {:g}, and {} is never below {:g}", *need.most,
                                          info_of(need.quantity.measure).name, bounds.least)};
        return std::nullopt;
    }

    // The greatest that each term can be, put together.
    double greatest_score() const {
        double sum = 0, smallest = kNoEnd;
        for (const Goal::Term& term : goal_.score) {
            const Bounds bounds = bounds_of(term.quantity);
            const double greatest =
                term.times == 0 ? 0 : term.times * (term.times > 0 ? bounds.most : bounds.least);
            sum += greatest, smallest = std::min(smallest, greatest);
        }
        return goal_.base + (goal_.combine == Goal::Combine::kSmallest ? smallest : sum);
    }

    Bounds bounds_of(const Quantity& quantity) const {
        const auto up_to = [](double most, std::string why) { return Bounds{0, most, std::move(why)}; };
        switch (quantity.measure) {
            case Measure::kRunOut: {
                const double across = glm::length(glm::dvec2(size().x, size().y));
                return up_to(across, fmt::format("the terrain is {:.0f} m across", across));
            }
            case Measure::kDrop: {
                const double relief = relief_of_ground();
                return {-relief, relief, fmt::format("the terrain has {:.0f} m of relief", relief)};
            }
            case Measure::kEroded: {
                const double all = state_.ledger.standing * cubic_metres();
                return up_to(all, fmt::format("{:.0f} m3 lie there", all));
            }
            case Measure::kRemoved:
                return up_to(100, "100 % is all of it");
            case Measure::kLoad:
                if (most_houses() > 0) return {};
                return up_to(0, "no house can stand there");
            case Measure::kDestroyed:
                return up_to(most_houses(),
                             fmt::format("at most {:g} houses can stand there", most_houses()));
            case Measure::kBlocked:
                return up_to(most_road(), fmt::format("at most {:.0f} m of road can be there", most_road()));
            case Measure::kBroken:
                return up_to(most_forest(),
                             fmt::format("at most {:.2f} ha of forest can stand there", most_forest()));
            case Measure::kUnused: {
                const Goal::Tool& tool = *tool_of(goal_, quantity.tool);
                const double all = tool.total ? *tool.total : static_cast<double>(*tool.count);
                return up_to(all, fmt::format("there are {:g} in all", all));
            }
            case Measure::kEarth:
                if (scenario_.standing.earth_budget < 0) return {};
                return up_to(scenario_.standing.earth_budget,
                             fmt::format("the budget of earth is {:g} m3", scenario_.standing.earth_budget));
            case Measure::kTopSpeed:
            case Measure::kDeposit:
            case Measure::kTime:
                break;
        }
        return {};
    }

    // How many times a command may be given, or how much of it, by the person and by the scene.
    double most_of(sim::CommandKind kind, double of_each_event) const {
        const auto events = static_cast<double>(std::ranges::count_if(
            goal_.events, [&](const TimedCommand& event) { return event.command.kind == kind; }));
        const double given = events > 0 ? events * of_each_event : 0;
        const Goal::Tool* const tool = tool_of(goal_, kind);
        if (!tool) return given;
        if (tool->total) return given + *tool->total;
        return tool->count ? given + static_cast<double>(*tool->count) * of_each_event : kNoEnd;
    }
    double most_houses() const {
        double houses = most_of(sim::CommandKind::kHouse, 1);
        for (const sim::Thing& thing : objects()) houses += thing.kind == sim::ThingKind::kHouse;
        return houses;
    }
    double most_road() const {
        double road = most_of(sim::CommandKind::kRoad, sim::kLongestLine);
        for (const sim::Thing& thing : objects())
            if (thing.kind == sim::ThingKind::kRoad)
                road += glm::distance(glm::dvec2(thing.x, thing.y), glm::dvec2(thing.to_x, thing.to_y));
        return road;
    }
    double most_forest() const {
        const sim::Grid& grid = scenario_.grid;
        const double all = static_cast<double>(grid.size()) * grid.cell_area() / kPerHectare;
        if (most_of(sim::CommandKind::kPlant, all) > 0) return all;
        double forest = 0;
        if (state_.things)
            for (int y = 0; y < grid.ny; ++y)
                for (int x = 0; x < grid.nx; ++x)
                    if (state_.things->forest(x, y) != sim::Stems{}) forest += grid.cell_area() / kPerHectare;
        return forest;
    }

    std::span<const sim::Thing> objects() const {
        return state_.things ? std::span<const sim::Thing>(state_.things->list)
                             : std::span<const sim::Thing>();
    }
    double cubic_metres() const { return static_cast<double>(sim::kQuantum) * scenario_.grid.cell_area(); }
    glm::dvec2 size() const {
        return glm::dvec2(scenario_.grid.nx - 1, scenario_.grid.ny - 1) *
               static_cast<double>(scenario_.grid.dx);
    }
    double relief_of_ground() const {
        double lowest = kNoEnd, highest = -kNoEnd;
        for (std::size_t i = 0; i < scenario_.bedrock.size(); ++i) {
            const double height =
                static_cast<double>(scenario_.bedrock[i]) + static_cast<double>(scenario_.depth[i]);
            lowest = std::min(lowest, height), highest = std::max(highest, height);
        }
        return highest - lowest;
    }
    // Of a box and of an ellipse alike: its place that is nearest to the grid is where its middle is brought to the grid.
    bool touches_grid(const Area& area) const {
        const glm::dvec2 middle = area.shape == Area::Shape::kBox ? 0.5 * (area.from + area.to) : area.from;
        const glm::dvec2 nearest = glm::clamp(middle, glm::dvec2(0), size());
        return area.has(nearest.x, nearest.y);
    }
    bool lacks_vertex(const Quantity& quantity) const {
        if (!quantity.area) return false;
        const auto cell = static_cast<double>(scenario_.grid.dx);
        for (int y = 0; y < scenario_.grid.ny; ++y)
            for (int x = 0; x < scenario_.grid.nx; ++x)
                if (quantity.area->has(x * cell, y * cell)) return false;
        return true;
    }

    const Scenario& scenario_;
    const Goal& goal_;
    sim::State state_;
};

}  // namespace

std::optional<ReachFault> fault_of_reach(const Scenario& scenario) {
    return Reachable(scenario).fault();
}

std::string to_text(const ReachFault& fault) {
    const std::string place =
        fault.table.empty() ? std::string() : fmt::format("{} {}: ", fault.table, fault.index + 1);
    return fmt::format("{}{} {}", place, fault.key, fault.fact);
}

}  // namespace game

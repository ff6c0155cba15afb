#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "game/scene/timed_command.h"
#include "sim/world/command.h"

namespace game {

// A part of the map, in metres from vertex (0, 0).
struct Area {
    enum class Shape : std::uint8_t { kBox, kEllipse };
    Shape shape = Shape::kBox;
    glm::dvec2 from{0}, to{0};  // of a box: its corners; of an ellipse: its middle and its half axes

    bool has(double x, double y) const;
    bool operator==(const Area&) const = default;
};

// What a challenge counts. Each is known from the states of a world and the commands that led there.
enum class Measure : std::uint8_t {
    kRunOut,     // m, in plan, from the highest place of release to the farthest place that the flow reached
    kDrop,       // m, between the same places
    kTopSpeed,   // m/s, along the slope
    kEroded,     // m³ by which the standing layer was lowered
    kDeposit,    // m³ that lie above the first surface, in the area
    kRemoved,    // % of the first standing layer in the area that is gone
    kLoad,       // kPa, the greatest on a house
    kDestroyed,  // houses
    kBlocked,    // m of road
    kBroken,     // ha of forest
    kUnused,     // of a tool: how much of its budget is left
    kTime,       // s
    kEarth,      // m³ of earth in use (sim/world/things.h)
};

struct Quantity {
    Measure measure = Measure::kRunOut;
    std::optional<Area> area = {};                     // of kDeposit and kRemoved; else the whole map
    sim::CommandKind tool = sim::CommandKind::kBlast;  // of kUnused
    bool operator==(const Quantity&) const = default;
};

// What a challenge asks of a person: which tools there are, what must be so in the end, and what is counted.
struct Goal {
    static constexpr std::size_t kMostTools = 16, kMostNeeds = 8, kMostTerms = 8, kMostText = 300;
    static constexpr std::int64_t kMostCount = 1'000'000;  // of a tool
    static constexpr double kGreatest = 1e9;               // magnitude of any other number
    static constexpr double kLongest = 1e6;                // s, of a try

    // A command that the person may give. Each number is as it is given, or in a range.
    struct Limit {
        std::string number;  // of the command's manifest
        double least = 0, most = 0;
        bool operator==(const Limit&) const = default;
    };
    struct Tool {
        sim::CommandKind kind = sim::CommandKind::kBlast;
        std::optional<std::int64_t> count;  // at most so many
        std::optional<double> total;        // at most so much of what unit_of() names
        std::vector<Limit> limits;
        std::optional<sim::Layer> layer;  // of a pour
        bool operator==(const Tool&) const = default;
    };
    struct Need {
        Quantity quantity;
        std::optional<double> least, most;  // one of them
        bool operator==(const Need&) const = default;
    };
    struct Term {
        Quantity quantity;
        double times = 1;
        bool operator==(const Term&) const = default;
    };

    std::string say, learn;  // the task, and what it teaches, told after a win
    std::vector<Tool> tools;
    std::optional<Area> zone;  // where they may be used
    std::vector<Need> needs;   // empty: every score wins that has a medal
    // score = base + Σ times · quantity, rounded; or, of kSmallest, base + the least of its terms
    enum class Combine : std::uint8_t { kSum, kSmallest };
    double base = 0;
    Combine combine = Combine::kSum;
    std::vector<Term> score;
    std::array<std::int64_t, 3> medals{};  // least scores for bronze, silver, gold; rising
    double earliest_s = 0;                 // the try ends at rest, but not before this
    std::optional<double> latest_s;        // or at this time
    std::vector<TimedCommand> events;      // of the scene, sorted by tick

    bool operator==(const Goal&) const = default;
};

struct MeasureInfo {
    Measure measure;
    std::string_view name, unit;  // "run_out", "m"
    std::string_view words;       // "The slide ran"
    bool has_area, has_tool;
};
std::span<const MeasureInfo> measure_infos();
const MeasureInfo& info_of(Measure measure);
std::optional<Measure> measure_from(std::string_view name);
std::string_view to_string(Goal::Combine combine);  // "smallest"
std::optional<Goal::Combine> combine_from(std::string_view name);

// What `total` of a tool counts, such as "m3"; empty if nothing but `count` does.
std::string_view unit_of(sim::CommandKind kind);
// What a command takes of that; 0 if nothing but `count` limits it.
double cost_of(const sim::Command& command, float tick_s);

// What is wrong with a goal; nothing if it can be played.
std::optional<std::string> fault_of(const Goal& goal);

// What limits a number of a tool's commands; null if nothing does.
const Goal::Limit* limit_of(const Goal::Tool& tool, double sim::Command::*number);
// A person may give commands of this kind; null if there is no such tool.
const Goal::Tool* tool_of(const Goal& goal, sim::CommandKind kind);

// A command with every number that a tool of the goal limits brought into its range, and its layer as there.
sim::Command fitted_to(const Goal& goal, sim::Command command);

// What a person has used of a goal's tools. Feed it every command of a world in the order of ticks.
class GoalUse {
  public:
    explicit GoalUse(const Goal& goal) : goal_(&goal) {}

    // Takes a command that is a person's or an event of the scene. Returns what forbids it, such as "no
    // blast is left: this challenge has 3"; it is not taken then.
    std::optional<std::string> take(const TimedCommand& timed, float tick_s);
    // The first event before `tick` that was not taken.
    const TimedCommand* missing(std::int64_t tick) const;
    // What is left of a tool of the goal: of its total, or of its count; nothing if it has neither.
    std::optional<double> left(const Goal::Tool& tool) const;

  private:
    std::optional<std::string> refusal(const sim::Command& command, float tick_s) const;
    std::size_t index_of(const Goal::Tool& tool) const;  // `tool`: one of the goal's

    const Goal* goal_;
    std::size_t events_ = 0;  // taken
    std::array<std::int64_t, Goal::kMostTools> counts_{};
    std::array<double, Goal::kMostTools> totals_{};
};

}  // namespace game

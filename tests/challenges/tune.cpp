// Plays a challenge at random, to find numbers at which it can be won but not by chance: docs/challenges.md has the
// procedure. Not a test: a thousand tries take a quarter of an hour.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/score.h"
#include "game/base/number.h"
#include "game/recording/recorder.h"
#include "game/scene/scene.h"
#include "game/session/session.h"

namespace {

using game::Goal;
using game::Scenario;
using game::Score;
using game::TimedCommand;

struct Try {
    std::vector<TimedCommand> by_hand;
    std::optional<Score> score;  // none: it did not end
};

// All commands of a try, those of the scene first in each tick.
std::vector<TimedCommand> all_of(const game::Scene& scene, const Try& attempt) {
    std::vector<TimedCommand> all = scene.commands;
    all.insert(all.end(), attempt.by_hand.begin(), attempt.by_hand.end());
    std::ranges::stable_sort(all, {}, &TimedCommand::tick);
    return all;
}

// A person sits before this program: what fails ends it.
template <class Result>
Result must(game::Outcome<Result> outcome) {
    if (!outcome) {
        fmt::print(stderr, "{}\n", outcome.error().sentence);
        std::exit(outcome.error().status);
    }
    if constexpr (!std::is_void_v<Result>) return std::move(*outcome);
}

// Plays until the try ends, at most ten minutes; into a recording, if there is a path.
void play(const game::Scene& scene, Try& attempt, const std::optional<std::string>& path = std::nullopt) {
    const std::vector<TimedCommand> commands = all_of(scene, attempt);
    std::optional<game::Recorder> recorder;
    if (path) recorder = must(game::Recorder::create(*path, scene.scenario));
    auto session = must(game::Session::begin(scene.scenario, {}, std::move(recorder)));
    game::Referee referee(scene.scenario, commands);
    for (std::int64_t tick = 0; tick < 60 * 600 && !session.try_ended_at(); ++tick) {
        std::vector<sim::Command> now;
        for (const TimedCommand& each : game::commands_at(commands, tick)) now.push_back(each.command);
        must(session.advance(now));
        referee.see(session);
    }
    if (const auto score = referee.decide()) attempt.score = *score;
    if (path && attempt.score) must(session.claim(attempt.score->claim()));
    if (path) must(session.finish());
}

// A person who tries anything: as many of each tool as there are at most, anywhere in the zone, at any time.
class Chance {
  public:
    Chance(const game::Scene& scene, unsigned seed)
        : scenario_(scene.scenario), goal_(*scenario_.goal), random_(seed) {}

    Try attempt() {
        Try made;
        game::GoalUse use(goal_);
        for (const Goal::Tool& tool : goal_.tools) {
            const auto most = static_cast<double>(tool.count.value_or(3));
            const int count = static_cast<int>(std::floor(between(1, most + 0.999)));
            for (int i = 0; i < count; ++i) {
                const TimedCommand command{std::llrint(between(0, latest_s()) * 60), command_of(tool)};
                if (!use.take(command, scenario_.params.tick_s)) made.by_hand.push_back(command);
            }
        }
        std::ranges::stable_sort(made.by_hand, {}, &TimedCommand::tick);
        return made;
    }

    // The same try with each place moved by up to `far` metres.
    Try near(const Try& other, double far) {
        Try made{other.by_hand, std::nullopt};
        for (TimedCommand& each : made.by_hand) {
            const double east = each.command.x + between(-far, far),
                         north = each.command.y + between(-far, far);
            if (!goal_.zone || goal_.zone->has(east, north)) each.command.x = east, each.command.y = north;
        }
        return made;
    }

  private:
    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    double latest_s() const {
        const double event = goal_.events.empty() ? 1 : static_cast<double>(goal_.events.back().tick) / 60;
        return std::max({goal_.earliest_s, event, 1.0});
    }
    sim::Command command_of(const Goal::Tool& tool) {
        sim::Command command;
        command.kind = tool.kind;
        for (const sim::CommandNumber& number : sim::info_of(tool.kind).numbers) {
            const auto limit = std::ranges::find(tool.limits, number.name, &Goal::Limit::number);
            if (limit != tool.limits.end()) command.*number.value = between(limit->least, limit->most);
        }
        if (tool.layer) command.layer = *tool.layer;
        const auto dx = static_cast<double>(scenario_.grid.dx);
        do {
            command.x = std::round(between(0, dx * (scenario_.grid.nx - 1)));
            command.y = std::round(between(0, dx * (scenario_.grid.ny - 1)));
        } while (goal_.zone && !goal_.zone->has(command.x, command.y));
        return command;
    }

    const Scenario& scenario_;
    const Goal& goal_;
    std::mt19937 random_;
};

std::string text_of(const Try& attempt) {
    std::string text;
    for (const TimedCommand& each : attempt.by_hand)
        text += fmt::format(" {}({:.0f}, {:.0f}) at {:.1f} s", sim::info_of(each.command.kind).name,
                            each.command.x, each.command.y, static_cast<double>(each.tick) / 60);
    return text;
}

bool is_better(const Try& one, const Try& other) {
    if (!one.score || !other.score) return one.score.has_value();
    return std::pair(one.score->medal, one.score->points) >
           std::pair(other.score->medal, other.score->points);
}

void tell(const char* what, const Goal& goal, const Try& attempt) {
    if (!attempt.score) return fmt::print("{}: does not end;{}\n", what, text_of(attempt));
    fmt::print("{}: score {}, {} {};{}\n", what, attempt.score->points, game::verdict_of(*attempt.score),
               game::reason_of(goal, *attempt.score), text_of(attempt));
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        fmt::print("Usage: {} SCENE TRIES [SEED [CLIMBS [RECORDING]]]\n", words[0]);
        return 2;
    }
    const auto scene = game::load_scene(words[1], {});
    if (!scene || !scene->scenario.goal) {
        fmt::print("{}\n", scene ? "the scene has no goal" : scene.error().sentence);
        return 2;
    }
    const Goal& goal = *scene->scenario.goal;
    const int tries = std::stoi(words[2]), climbs = count > 4 ? std::stoi(words[4]) : 0;
    Chance chance(*scene, count > 3 ? static_cast<unsigned>(std::stoi(words[3])) : 1);
    Try nothing;
    play(*scene, nothing);
    tell("nothing done", goal, nothing);
    Try best;
    std::array<int, 4> medals{};
    std::vector<std::int64_t> points;
    for (int i = 0; i < tries; ++i) {
        Try attempt = chance.attempt();
        play(*scene, attempt);
        if (attempt.score) ++medals.at(static_cast<std::size_t>(attempt.score->medal));
        if (attempt.score && attempt.score->meets_needs()) points.push_back(attempt.score->points);
        if (!is_better(attempt, best)) continue;
        best = attempt;
        tell("best so far", goal, best);
    }
    std::ranges::sort(points);
    fmt::print("{} tries: {} bronze, {} silver, {} gold; needs met {} times", tries, medals[1], medals[2],
               medals[3], points.size());
    for (const double share : {0.5, 0.9, 0.95, 0.98})
        if (!points.empty())
            fmt::print(", {:.0f} %: {}", 100 * share,
                       points[static_cast<std::size_t>(share * static_cast<double>(points.size() - 1))]);
    fmt::print("\n");
    const auto dx = static_cast<double>(scene->scenario.grid.dx);
    for (int i = 0; i < climbs; ++i) {
        Try attempt = chance.near(best, 20 * dx * std::pow(0.1, static_cast<double>(i) / climbs));
        play(*scene, attempt);
        if (is_better(attempt, best)) best = attempt;
    }
    if (climbs > 0) tell("climbed to", goal, best);
    int won = 0;
    for (const auto& [east, north] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        Try attempt{best.by_hand, std::nullopt};
        for (TimedCommand& each : attempt.by_hand) each.command.x += east * dx, each.command.y += north * dx;
        play(*scene, attempt);
        won += attempt.score && attempt.score->won;
    }
    fmt::print("the best one moved by a cell wins {} times of 4\n", won);
    if (count > 5) play(*scene, best, words[5]);
    return 0;
}

// Plays a challenge at random, to find numbers at which it can be won but not by chance, and records a try that wins
// and one that loses: docs/challenges.md has the procedure. Not a test: a thousand tries take a quarter of an hour.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/analysis/score.h"
#include "game/recording/recording_file.h"
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

// Writes a try with one state line per second: a session's own has ten, and is three times as long.
class Writer {
  public:
    Writer(const std::string& path, const Scenario& scenario)
        : recorder_(must(game::record_into(path, header_of(scenario)))) {}

    void command(const TimedCommand& command) { must(recorder_.command(command)); }
    void state(game::StateLine line) {
        line.before.clear();
        must(recorder_.state(line));
    }
    void end(const Score& score) {
        must(recorder_.claim(score.claim()));
        must(recorder_.end(score.tick));
    }
    static constexpr std::int64_t kTicks = 60;  // from a state line to the next

  private:
    static game::Header header_of(const Scenario& scenario) {
        game::Header header;
        header.scenario = scenario;
        header.ticks_per_state = kTicks;
        return header;
    }
    game::Recorder recorder_;
};

// Whether a house was hit harder than a need allows: such a try is lost, however it goes on.
bool is_lost(const Goal& goal, const game::Session& session) {
    if (!session.state().things) return false;
    double load = 0;
    for (const sim::Thing& thing : session.state().things->list)
        if (thing.kind == sim::ThingKind::kHouse)
            load = std::max(load, static_cast<double>(thing.load) / 1000);
    return std::ranges::any_of(goal.needs, [&](const Goal::Need& need) {
        return need.quantity.measure == game::Measure::kLoad && need.most && load > *need.most;
    });
}

// Plays until the try ends, at most ten minutes, or until it is lost, unless it is written.
void play(const game::Scene& scene, Try& attempt, Writer* writer = nullptr) {
    const std::vector<TimedCommand> commands = all_of(scene, attempt);
    auto session = must(game::Session::begin(scene.scenario, {}, std::nullopt));
    if (writer) writer->state(session.state_line());
    game::Referee referee(scene.scenario, commands);
    for (std::int64_t tick = 0; tick < 60 * 600 && !session.try_ended_at(); ++tick) {
        std::vector<sim::Command> now;
        for (const TimedCommand& each : game::commands_at(commands, tick)) {
            now.push_back(each.command);
            if (writer) writer->command(each);
        }
        must(session.advance(now));
        referee.see(session);
        if (!writer && tick % Writer::kTicks == 0 && is_lost(*scene.scenario.goal, session)) {
            attempt.score = score_now(scene.scenario, session, commands_before(commands, tick));
            return;
        }
        if (writer && (session.state().tick % Writer::kTicks == 0 || session.try_ended_at()))
            writer->state(session.state_line());
    }
    if (const auto score = referee.decide()) attempt.score = *score;
    if (writer && attempt.score) writer->end(*attempt.score);
}

// A person who tries anything, anywhere in the zone, at any time: of a tool with a count some, each at a place of its
// own; of one without a single stroke.
class Chance {
  public:
    Chance(const game::Scene& scene, unsigned seed)
        : scenario_(scene.scenario), goal_(*scenario_.goal), random_(seed) {}

    Try attempt() {
        Try made;
        game::GoalUse use(goal_);
        for (const Goal::Tool& tool : goal_.tools) {
            const int strokes = tool.count ? whole_to(static_cast<int>(*tool.count)) : 1;
            for (int i = 0; i < strokes; ++i) {
                const std::int64_t tick = std::llrint(between(0, latest_s()) * 60);
                for (const sim::Command& each : stroke_of(tool))
                    if (!use.take({tick, each}, scenario_.params.tick_s))
                        made.by_hand.push_back({tick, each});
            }
        }
        std::ranges::stable_sort(made.by_hand, {}, &TimedCommand::tick);
        return made;
    }

    // The same try with each place moved by up to `far` metres; a stroke, which is one tick, as a whole.
    Try near(const Try& other, double far) {
        Try made{other.by_hand, std::nullopt};
        std::int64_t tick = -1;
        double east = 0, north = 0;
        for (TimedCommand& each : made.by_hand) {
            if (each.tick != tick) east = between(-far, far), north = between(-far, far);
            tick = each.tick;
            const double x = each.command.x + east, y = each.command.y + north;
            if (!goal_.zone || goal_.zone->has(x, y)) each.command.x = x, each.command.y = y;
        }
        return made;
    }

  private:
    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    int whole_to(int most) { return static_cast<int>(std::floor(between(1, most + 0.999))); }
    // One command of a tool with a count. Else up to eight in a row, a radius apart; with durations that use some of
    // its total.
    std::vector<sim::Command> stroke_of(const Goal::Tool& tool) {
        std::vector<sim::Command> stroke{command_of(tool)};
        if (tool.count) return stroke;
        sim::Command next = stroke.front();
        const int many = whole_to(8);
        if (tool.kind == sim::CommandKind::kSculpt) next.rise = between(1, 8);
        const double heading = between(0, 2 * std::numbers::pi), share = between(0.3, 1);
        const bool takes_volume = tool.kind == sim::CommandKind::kDig ||
                                  tool.kind == sim::CommandKind::kWet ||
                                  tool.kind == sim::CommandKind::kDrain;
        if (tool.total && takes_volume)
            next.duration =
                share * *tool.total / (many * next.rate * std::numbers::pi * next.radius * next.radius);
        stroke.assign(static_cast<std::size_t>(many), next);
        for (int i = 0; i < many; ++i) {
            sim::Command& each = stroke[static_cast<std::size_t>(i)];
            each.x += i * next.radius * std::sin(heading), each.y += i * next.radius * std::cos(heading);
        }
        return stroke;
    }
    double latest_s() const {
        const double event = goal_.events.empty() ? 1 : static_cast<double>(goal_.events.back().tick) / 60;
        return std::max({goal_.earliest_s, event, 1.0});
    }
    sim::Command command_of(const Goal::Tool& tool) {
        sim::Command command;
        command.kind = tool.kind;
        for (const sim::CommandNumber& number : sim::info_of(tool.kind).numbers)
            if (const Goal::Limit* const limit = limit_of(tool, number.value))
                command.*number.value = between(limit->least, limit->most);
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

// What a person did in a recording, all that is not the scene's own; of an easier challenge as far as tools allow.
Try known_from(const char* path, const game::Scene& scene) {
    Try known;
    for (const TimedCommand& each : must(game::read_recording(path)).commands)
        if (std::ranges::find(scene.commands, each) == scene.commands.end())
            known.by_hand.push_back({each.tick, game::fitted_to(*scene.scenario.goal, each.command)});
    return known;
}

void tell(const char* what, const Goal& goal, const Try& attempt) {
    if (!attempt.score) return fmt::print("{}: does not end;{}\n", what, text_of(attempt));
    fmt::print("{}: score {}, {} {};{}\n", what, attempt.score->points, game::verdict_of(*attempt.score),
               game::reason_of(goal, *attempt.score), text_of(attempt));
    std::fflush(stdout);
}

// The first of them that still wins with all its places moved by a cell, whichever way. Looks at the sixty best.
std::optional<Try> best_sound(const game::Scene& scene, const std::vector<Try>& winners) {
    const auto dx = static_cast<double>(scene.scenario.grid.dx);
    const auto wins = [&](const Try& winner, double east, double north) {
        Try moved{winner.by_hand, std::nullopt};
        for (TimedCommand& each : moved.by_hand) each.command.x += east * dx, each.command.y += north * dx;
        play(scene, moved);
        return moved.score && moved.score->won();
    };
    for (const Try& winner : std::span(winners).first(std::min<std::size_t>(60, winners.size())))
        if (wins(winner, -1, 0) && wins(winner, 1, 0) && wins(winner, 0, -1) && wins(winner, 0, 1))
            return winner;
    return std::nullopt;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        fmt::print("Usage: {} SCENE TRIES [SEED [CLIMBS [RECORDINGS [KNOWN]]]]\n", words[0]);
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
    if (!goal.events.empty()) {  // else the try would not end
        Try nothing;
        play(*scene, nothing);
        tell("nothing done", goal, nothing);
    }
    std::vector<Try> winners;  // the best one first
    std::optional<Try> loser;
    const auto keep = [&](const Try& attempt) {
        if (attempt.score && attempt.score->won())
            winners.insert(std::ranges::upper_bound(winners, attempt, is_better), attempt);
    };
    std::array<int, 4> medals{};
    std::vector<std::int64_t> points;
    Try best;
    if (count > 6) {
        best = known_from(words[6], *scene);
        play(*scene, best);
        keep(best);
        tell("known", goal, best);
    }
    for (int i = 0; i < tries; ++i) {
        Try attempt = chance.attempt();
        play(*scene, attempt);
        keep(attempt);
        if (attempt.score) ++medals.at(static_cast<std::size_t>(attempt.score->medal));
        if (attempt.score && attempt.score->meets_needs()) points.push_back(attempt.score->points);
        if (attempt.score && !attempt.score->won() && !attempt.by_hand.empty() && !loser) loser = attempt;
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
        keep(attempt);
        if (!is_better(best, attempt)) best = attempt;  // also sideways: some scores are coarse
    }
    if (climbs == 0 && count <= 5) return 0;
    tell("climbed to", goal, best);
    const std::optional<Try> sound = best_sound(*scene, winners);
    if (sound) tell("the best that wins with its places moved by a cell", goal, *sound);
    if (count <= 5) return 0;
    if (!sound || !loser) {
        fmt::print("nothing recorded: there is no {} try\n", sound ? "losing" : "sound winning");
        return 1;
    }
    const auto record = [&](Try attempt, const char* end) {
        Writer writer(std::string(words[5]) + end, scene->scenario);
        play(*scene, attempt, &writer);
    };
    record(*sound, "_won.couloir");
    record(*loser, "_lost.couloir");
    tell("recorded as lost", goal, *loser);
    return 0;
}

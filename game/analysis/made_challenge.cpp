#include "game/analysis/made_challenge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "game/recording/command_source.h"
#include "game/recording/recording_file.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr double kLongestPlay = 3600;      // s after the last command; what creeps on longer is given up
constexpr std::int64_t kLeastRunOut = 10;  // m

bool by_time(const TimedCommand& one, const TimedCommand& other) {
    return one.tick < other.tick;
}

// Up to three digits; what the length of a tick in float adds does not count.
double rounded_up(double value) {
    if (value <= 0) return 0;
    constexpr double kOfFloat = 5e-7;
    const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
    return std::ceil(value / unit * (1 - kOfFloat)) * unit;
}

// Down to tens, or to units below a hundred.
std::int64_t rounded_down(double value) {
    const double step = value >= 100 ? 10 : 1;
    return std::llrint(step * std::floor(value / step));
}

// Where and which way something was done is free.
bool is_left_free(const sim::CommandNumber& number) {
    for (const auto place : {&sim::Command::x, &sim::Command::y, &sim::Command::to_x, &sim::Command::to_y,
                             &sim::Command::turn, &sim::Command::level, &sim::Command::duration})
        if (number.value == place) return true;
    return false;
}

Goal::Tool tool_for(sim::CommandKind kind, const std::vector<TimedCommand>& by_hand, float tick_s) {
    Goal::Tool tool;
    tool.kind = kind;
    std::int64_t count = 0;
    double total = 0;
    std::vector<double> greatest(sim::info_of(kind).numbers.size());
    std::optional<sim::Layer> layer;
    bool is_one_layer = sim::info_of(kind).has_layer;
    for (const TimedCommand& each : by_hand) {
        const sim::Command& command = each.command;
        if (command.kind != kind) continue;
        ++count;
        total += cost_of(command, tick_s);
        for (std::size_t i = 0; i < greatest.size(); ++i)
            greatest[i] = std::max(greatest[i], std::abs(command.*sim::info_of(kind).numbers[i].value));
        is_one_layer &= !layer || *layer == command.layer;
        layer = command.layer;
    }
    if (unit_of(kind).empty())
        tool.count = count;
    else
        tool.total = rounded_up(total);
    for (std::size_t i = 0; i < greatest.size(); ++i) {
        const sim::CommandNumber& number = sim::info_of(kind).numbers[i];
        if (!is_left_free(number))
            tool.limits.push_back(
                {std::string(number.name), std::max(number.least, -greatest[i]), greatest[i]});
    }
    if (is_one_layer) tool.layer = layer;
    return tool;
}

std::string count_text(std::int64_t count, const char* one, const char* many) {
    return count == 1 ? fmt::format("one {}", one) : fmt::format("{} {}", count, many);
}

// "3 blasts"
std::string phrase_of(const Goal::Tool& tool) {
    const std::int64_t count = tool.count.value_or(0);
    const std::string total = fmt::format("{:g}", tool.total.value_or(0));
    switch (tool.kind) {
        case sim::CommandKind::kPour:
            return total + " m³ to pour";
        case sim::CommandKind::kDig:
            return total + " m³ to dig";
        case sim::CommandKind::kWet:
            return total + " m³ of water";
        case sim::CommandKind::kDrain:
            return total + " m³ of water to drain";
        case sim::CommandKind::kBlast:
            return count_text(count, "blast", "blasts");
        case sim::CommandKind::kSculpt:
        case sim::CommandKind::kSmooth:
        case sim::CommandKind::kLevel:
            return "earth to shape";
        case sim::CommandKind::kPlant:
            return total + " ha of forest";
        case sim::CommandKind::kHouse:
            return count_text(count, "house", "houses");
        case sim::CommandKind::kLift:
            return count_text(count, "chairlift", "chairlifts");
        case sim::CommandKind::kNet:
            return total + " m of nets";
        case sim::CommandKind::kRoad:
            return total + " m of road";
        case sim::CommandKind::kSettle:
        case sim::CommandKind::kSet:
        case sim::CommandKind::kFell:
        case sim::CommandKind::kTurn:
        case sim::CommandKind::kRemove:
        case sim::CommandKind::kStorm:
        case sim::CommandKind::kWind:
        case sim::CommandKind::kTemperature:
        case sim::CommandKind::kCancel:
            break;
    }
    return fmt::format("{} to {}", count == 1 ? "one place" : fmt::format("{} places", count),
                       sim::info_of(tool.kind).name);
}

// "a, b and c"
std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + parts[i];
    return text;
}

// "One blast and 500 m³ to pour"
std::string phrase_of(const std::vector<Goal::Tool>& tools) {
    std::vector<std::string> phrases;
    for (const Goal::Tool& tool : tools)
        if (std::string each = phrase_of(tool); std::ranges::find(phrases, each) == phrases.end())
            phrases.push_back(std::move(each));
    constexpr std::size_t kMostPhrases = 4;
    if (phrases.size() > kMostPhrases) return "All these tools";
    std::string text = joined(phrases);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

// Of a try that has ended: what it did to houses and roads, in thousandths of their units.
struct Harm {
    std::optional<std::int64_t> destroyed, blocked;  // none: there is none
};

// Sets the needs and medals of a goal by what the try reached, and says what it asks.
void ask(const Score& score, const Harm& harm, Goal& goal) {
    goal.medals = {rounded_down(0.6 * static_cast<double>(score.points)),
                   rounded_down(0.8 * static_cast<double>(score.points)),
                   rounded_down(static_cast<double>(score.points))};
    std::vector<std::string> wishes{fmt::format("run {} m", goal.medals[2])};
    goal.needs.clear();
    if (harm.destroyed) {
        const std::int64_t most = *harm.destroyed / Score::kParts;
        goal.needs.push_back({{.measure = Measure::kDestroyed}, std::nullopt, static_cast<double>(most)});
        wishes.push_back(most == 0 ? "spare all houses"
                                   : fmt::format("destroy at most {}", count_text(most, "house", "houses")));
    }
    if (harm.blocked) {
        constexpr double kStep = 10;  // m
        const double most = kStep * std::ceil(static_cast<double>(*harm.blocked) /
                                              static_cast<double>(Score::kParts) / kStep);
        goal.needs.push_back({{.measure = Measure::kBlocked}, std::nullopt, most});
        wishes.push_back(most == 0 ? "leave the road clear"
                                   : fmt::format("block at most {:g} m of road", most));
    }
    goal.say = fmt::format("{}. Make it {}.", phrase_of(goal.tools), joined(wishes));
}

bool any_stands(const sim::State& state, sim::ThingKind kind) {
    return state.things &&
           std::ranges::find(state.things->list, kind, &sim::Thing::kind) != state.things->list.end();
}

// A try that is played until it ends.
struct EndedTry {
    Session session;
    Score score;
};

Outcome<EndedTry> play_try(const Scenario& scenario, const std::vector<TimedCommand>& commands,
                           const sim::StepOptions& options, std::optional<Recorder> recorder,
                           const std::atomic<bool>& stop) {
    auto session = Session::begin(scenario, options, std::move(recorder));
    if (!session) return tl::unexpected(session.error());
    const std::int64_t latest =
        commands.back().tick + std::llrint(kLongestPlay / static_cast<double>(scenario.params.tick_s));
    Referee referee(scenario, commands);
    CommandSource source;
    while (!session->try_ended_at()) {
        if (stop) return machine_fails("it was stopped");
        if (session->state().tick >= latest)
            return unusable(fmt::format("it does not come to rest within {:g} s", kLongestPlay));
        if (auto advanced = session->advance(source.due(session->state(), commands)); !advanced)
            return tl::unexpected(advanced.error());
        referee.see(*session);
    }
    auto score = referee.decide();
    if (!score) return tl::unexpected(score.error());
    return EndedTry{std::move(*session), std::move(*score)};
}

// What all that counts here is measured as, whatever it comes to.
Harm harm_of(const Score& score, const sim::State& state) {
    Harm harm;
    if (any_stands(state, sim::ThingKind::kHouse)) harm.destroyed = score.needs.at(0).value;
    if (any_stands(state, sim::ThingKind::kRoad)) harm.blocked = score.needs.at(1).value;
    return harm;
}

std::vector<TimedCommand> all_of(const Goal& goal, const History& history) {
    std::vector<TimedCommand> all = goal.events;
    std::ranges::copy_if(history.by_hand, std::back_inserter(all), [](const TimedCommand& each) {
        return each.command.kind != sim::CommandKind::kSet;
    });
    std::ranges::stable_sort(all, by_time);
    return all;
}

// Records the try that wins.
Outcome<void> record_try(const Scenario& scenario, const std::vector<TimedCommand>& commands,
                         const sim::StepOptions& options, const fs::path& file,
                         const std::atomic<bool>& stop) {
    auto recorder = record_into(file, scenario);
    if (!recorder) return tl::unexpected(recorder.error());
    auto played = play_try(scenario, commands, options, std::move(*recorder), stop);
    if (!played) return tl::unexpected(played.error());
    if (played->score.medal != kGold)
        return tl::unexpected(
            Failure{Failure::kBadAnswer, fmt::format("played again it scores {}, and gold begins at {}",
                                                     played->score.points, scenario.goal->medals.back())});
    return played->session.claim(played->score.claim()).and_then([&] { return played->session.finish(); });
}

}  // namespace

Outcome<Goal> goal_of(const Scenario& scenario, const History& history) {
    const float tick_s = scenario.params.tick_s;
    Goal goal;
    goal.score = {{{.measure = Measure::kRunOut}}};
    goal.events = history.scene;
    for (const TimedCommand& each : history.by_hand) {
        const sim::CommandKind kind = each.command.kind;
        if (kind == sim::CommandKind::kSet)
            goal.events.push_back(each);
        else if (!tool_of(goal, kind))
            goal.tools.push_back(tool_for(kind, history.by_hand, tick_s));
    }
    std::ranges::stable_sort(goal.events, by_time);
    if (goal.tools.empty()) return unusable("nothing was done in this world yet");
    goal.say = phrase_of(goal.tools) + ".";
    // A try ends by calm; it must not before the next thing was done.
    const std::vector<TimedCommand> all = all_of(goal, history);
    std::int64_t longest = 0;
    for (std::size_t i = 1; i < all.size(); ++i) longest = std::max(longest, all[i].tick - all[i - 1].tick);
    const double wait = static_cast<double>(longest) * static_cast<double>(tick_s);
    if (wait > AttemptWatch::kCalm) goal.earliest_s = std::floor(wait) + 1;
    return goal;
}

Outcome<Scenario> make_challenge(const Scenario& scenario, const History& history,
                                 const sim::StepOptions& options, const fs::path& file,
                                 const std::atomic<bool>& stop) {
    auto goal = goal_of(scenario, history);
    if (!goal) return tl::unexpected(goal.error());
    Scenario made = scenario;
    made.goal = std::move(*goal);
    const std::vector<TimedCommand> commands = all_of(*made.goal, history);
    constexpr double kAnything = std::numeric_limits<std::int32_t>::max();
    made.goal->needs = {{{.measure = Measure::kDestroyed}, std::nullopt, kAnything},
                        {{.measure = Measure::kBlocked}, std::nullopt, kAnything}};
    const auto reached = play_try(made, commands, options, std::nullopt, stop);
    if (!reached) return tl::unexpected(reached.error());
    if (reached->score.points < kLeastRunOut)
        return unusable(
            fmt::format("it ran {} m, and {} m are the least", reached->score.points, kLeastRunOut));
    ask(reached->score, harm_of(reached->score, reached->session.state()), *made.goal);

    fs::path part = file;
    part += ".part";
    std::error_code error, ignored;
    auto recorded = record_try(made, commands, options, part, stop);
    if (recorded) {
        fs::rename(part, file, error);
        if (error)
            recorded =
                machine_fails(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
    }
    if (!recorded) {
        fs::remove(part, ignored);
        return tl::unexpected(recorded.error());
    }
    return made;
}

}  // namespace game

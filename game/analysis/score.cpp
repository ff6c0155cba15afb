#include "game/analysis/score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <xxhash.h>

#include "game/analysis/measures.h"
#include "game/analysis/thing_results.h"
#include "game/words/words.h"
#include "sim/world/ledger.h"

namespace game {
namespace {

// The sum over the vertices of an area, in quanta of depth: exact, in any order. `of(i, x, y)`: m at a vertex, by its
// index in the scenario and its place.
template <class Of>
std::int64_t sum(const sim::Grid& grid, const std::optional<Area>& area, Of&& of) {
    const auto cell = static_cast<double>(grid.dx);
    std::int64_t quanta = 0;
    std::size_t i = 0;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, ++i)
            if (!area || area->has(x * cell, y * cell))
                quanta += std::llrint(of(i, x, y) / static_cast<double>(sim::kQuantum));
    return quanta;
}

// m³ above the surface of tick 0.
double deposit_in(const Scenario& scenario, const Session& session, const std::optional<Area>& area) {
    const sim::State& s = session.state();
    return session.cubic_metres(sum(scenario.grid, area, [&](std::size_t i, int x, int y) {
        const double first =
            static_cast<double>(scenario.depth[i]) + static_cast<double>(scenario.rolling[i]);
        const double now = static_cast<double>(s.depth(x, y)) + static_cast<double>(s.rolling(x, y));
        return std::max(now - first, 0.0);
    }));
}

// % of the standing layer of tick 0.
double removed_from(const Scenario& scenario, const Session& session, const std::optional<Area>& area) {
    const sim::State& s = session.state();
    const auto first = [&](std::size_t i) { return static_cast<double>(scenario.depth[i]); };
    const std::int64_t all = sum(scenario.grid, area, [&](std::size_t i, int, int) { return first(i); });
    const std::int64_t gone = sum(scenario.grid, area, [&](std::size_t i, int x, int y) {
        return std::max(first(i) - static_cast<double>(s.depth(x, y)), 0.0);
    });
    return all > 0 ? 100 * static_cast<double>(gone) / static_cast<double>(all) : 0;
}

// Everything that quantities are read from, found once.
class Findings {
  public:
    Findings(const Scenario& scenario, const Session& session, std::span<const TimedCommand> commands)
        : scenario_(scenario),
          session_(session),
          measures_(measure(scenario, session, release_area(scenario, commands), {})),
          use_(*scenario.goal) {
        if (session.state().things) things_ = thing_results(session);
        // Only the hand of a person can break a rule, and what it may not do was left out or is told by Referee.
        for (const TimedCommand& command : commands) use_.take(command, scenario.params.tick_s);
    }

    const Measures& measures() const { return measures_; }
    // In thousandths of the measure's unit.
    std::int64_t value(const Quantity& quantity) const {
        return std::llrint(static_cast<double>(Score::kParts) * amount(quantity));
    }

  private:
    double amount(const Quantity& quantity) const {
        switch (quantity.measure) {
            case Measure::kRunOut:
                return measures_.run_out;
            case Measure::kDrop:
                return measures_.fall;
            case Measure::kTopSpeed:
                return measures_.peak_speed_slope;
            case Measure::kEroded:
                return measures_.eroded;
            case Measure::kDeposit:
            case Measure::kRemoved:
                return amount_in_area(scenario_, session_, quantity);
            case Measure::kLoad: {
                std::int64_t load = 0;
                each_house([&](const sim::Thing& house) { load = std::max(load, house.load); });
                return static_cast<double>(load) / 1000;
            }
            case Measure::kDestroyed: {
                int destroyed = 0;
                each_house([&](const sim::Thing& house) { destroyed += house.destroyed(); });
                return destroyed;
            }
            case Measure::kBlocked:
                return things_ ? things_->road_blocked : 0;
            case Measure::kBroken:
                return things_ ? things_->forest_broken_ha : 0;
            case Measure::kUnused: {
                const Goal::Tool* const tool = tool_of(*scenario_.goal, quantity.tool);
                return tool ? use_.left(*tool).value_or(0) : 0;
            }
            case Measure::kEarth:
                return things_ ? things_->earth_used : 0;
            case Measure::kTime:
                return session_.seconds();
        }
        return 0;
    }

    template <class Visit>
    void each_house(Visit&& visit) const {
        if (!session_.state().things) return;
        for (const sim::Thing& thing : session_.state().things->list)
            if (thing.kind == sim::ThingKind::kHouse) visit(thing);
    }

    const Scenario& scenario_;
    const Session& session_;
    Measures measures_;
    std::optional<ThingResults> things_;
    GoalUse use_;
};

// `value`: in thousandths of the measure's unit.
bool meets(const Goal::Need& need, std::int64_t value) {
    const auto parts = [](double of) { return std::llrint(of * static_cast<double>(Score::kParts)); };
    return need.most ? value <= parts(*need.most) : value >= parts(*need.least);
}

std::string_view unit_text(const Quantity& quantity) {
    const MeasureInfo& info = info_of(quantity.measure);
    return tr(info.has_tool ? unit_of(quantity.tool) : info.unit);
}

// Thousandths, rounded to so many digits after the point.
std::int64_t rounded(std::int64_t value, int digits) {
    constexpr std::array<std::int64_t, 4> kSteps{1000, 100, 10, 1};
    const auto step = static_cast<double>(kSteps.at(static_cast<std::size_t>(digits)));
    return std::llrint(static_cast<double>(value) / step) * static_cast<std::int64_t>(step);
}

std::string amount_text(double number, int digits, std::string_view unit) {
    return fmt::format("{:.{}f}{}{}", number, digits, unit.empty() ? "" : " ", unit);
}

// A value with as many digits as it takes to see on which side of its bound it is. If that is more than usual, the bound
// has as many, so that both can be compared digit by digit.
std::pair<std::string, std::string> value_and_bound(const Goal::Need& need, const Score::Judged& judged) {
    constexpr int kMostDigits = 3;
    const std::string_view unit = unit_text(need.quantity);
    const bool is_small = std::abs(judged.value) < 100 * Score::kParts;
    const int usual = is_small && judged.value % Score::kParts != 0 ? 1 : 0;
    int digits = usual;
    while (digits < kMostDigits && meets(need, rounded(judged.value, digits)) != judged.met) ++digits;
    const double value =
        static_cast<double>(rounded(judged.value, digits)) / static_cast<double>(Score::kParts);
    const double bound = need.most ? *need.most : *need.least;
    const std::string bound_text = digits > usual
                                       ? amount_text(bound, digits, unit)
                                       : fmt::format("{}{}{}", bound, unit.empty() ? "" : " ", unit);
    return {amount_text(value, digits, unit),
            fmt::format("{} {}", tr(need.most ? "at most" : "at least"), bound_text)};
}

std::string name_of(const Quantity& quantity) {
    const MeasureInfo& info = info_of(quantity.measure);
    return info.has_tool ? fmt::format("{} {}", tr(sim::info_of(quantity.tool).name), tr(info.words))
                         : std::string(tr(info.words));
}

// The terms of the score, without its base.
double combined(const Goal& goal, const Findings& found) {
    std::vector<double> terms;
    for (const Goal::Term& term : goal.score)
        terms.push_back(term.times * static_cast<double>(found.value(term.quantity)) /
                        static_cast<double>(Score::kParts));
    return goal.combine == Goal::Combine::kSmallest ? *std::ranges::min_element(terms)
                                                    : std::accumulate(terms.begin(), terms.end(), 0.0);
}

// All of a challenge but how it is drawn and called.
Json rules_of(const Scenario& scenario) {
    Header header;
    header.scenario = scenario;
    Json json = to_json(header);
    for (const char* seen : {"view", "title", "program"}) json.erase(seen);
    json["terrain"].erase("name"), json["terrain"].erase("licence");
    return json;
}

}  // namespace

bool Score::meets_needs() const {
    return std::ranges::all_of(needs, &Judged::met);
}

Score score_now(const Scenario& scenario, const Session& session, std::span<const TimedCommand> commands) {
    const Goal& goal = *scenario.goal;
    const Findings found(scenario, session, commands);
    Score score;
    score.tick = session.state().tick;
    score.measures = found.measures();
    for (const Goal::Need& need : goal.needs) {
        const std::int64_t value = found.value(need.quantity);
        score.needs.push_back({value, meets(need, value)});
    }
    score.points = std::llrint(goal.base + combined(goal, found));
    if (score.meets_needs())
        score.medal = static_cast<int>(
            std::ranges::count_if(goal.medals, [&](std::int64_t least) { return score.points >= least; }));
    return score;
}

double amount_in_area(const Scenario& scenario, const Session& session, const Quantity& quantity) {
    return quantity.measure == Measure::kRemoved ? removed_from(scenario, session, quantity.area)
                                                 : deposit_in(scenario, session, quantity.area);
}

const char* medal_name(int medal) {
    constexpr const char* kNames[] = {"no medal", "bronze", "silver", "gold"};
    return kNames[std::clamp(medal, 0, 3)];
}

NeedText text_of(const Goal::Need& need, const Score::Judged& judged) {
    auto [value, bound] = value_and_bound(need, judged);
    return {name_of(need.quantity), std::move(value), std::move(bound)};
}

std::string verdict_of(const Score& score) {
    if (score.won()) return said("Won: {}", tr(medal_name(score.medal)));
    return tr(score.meets_needs() ? "No medal" : "Lost");
}

std::string reason_of(const Goal& goal, const Score& score) {
    for (std::size_t i = 0; i < goal.needs.size(); ++i)
        if (!score.needs[i].met) {
            const NeedText text = text_of(goal.needs[i], score.needs[i]);
            return said("The {} is {}, and must be {}.", text.what, text.value, text.bound);
        }
    if (score.won()) return "";
    return said("The score is {}, and bronze begins at {}.", score.points, goal.medals[0]);
}

std::string to_text(const Goal& goal, const Score& score) {
    const std::string reason = reason_of(goal, score);
    std::string text = fmt::format(
        "challenge: {}{}{}\nscore {}; bronze from {}, silver from {}, gold from {}\n", verdict_of(score),
        reason.empty() ? "" : ". ", reason, score.points, goal.medals[0], goal.medals[1], goal.medals[2]);
    for (std::size_t i = 0; i < goal.needs.size(); ++i) {
        const NeedText need = text_of(goal.needs[i], score.needs[i]);
        text += fmt::format("{}: {} {}, {}\n", score.needs[i].met ? "met" : "not met", need.what, need.value,
                            need.bound);
    }
    return text;
}

Json to_json(const Goal& goal, const Score& score) {
    Json json{{"tick", score.tick},    {"won", score.won()},
              {"score", score.points}, {"medal", medal_name(score.medal)},
              {"medals", goal.medals}, {"needs", Json::array()}};
    for (std::size_t i = 0; i < goal.needs.size(); ++i)
        json["needs"].push_back(
            {{"measure", info_of(goal.needs[i].quantity.measure).name},
             {"value", static_cast<double>(score.needs[i].value) / static_cast<double>(Score::kParts)},
             {"met", score.needs[i].met}});
    return json;
}

void Referee::see(const Session& session) {
    const std::int64_t tick = session.state().tick;
    if (session.try_ended_at() != tick) return;
    score_ = score_now(scenario_, session, commands_before(commands_, tick));
}

std::optional<std::string> broken_rule(const Scenario& scenario, std::span<const TimedCommand> commands,
                                       std::int64_t until) {
    GoalUse use(*scenario.goal);
    for (const TimedCommand& command : commands_before(commands, until))
        if (const auto forbidden = use.take(command, scenario.params.tick_s))
            return fmt::format("tick {}: {}", command.tick, *forbidden);
    if (const TimedCommand* event = use.missing(until))
        return fmt::format("tick {}: the scene's own {} is missing", event->tick,
                           sim::info_of(event->command.kind).name);
    return std::nullopt;
}

Outcome<Score> Referee::decide() const {
    const std::int64_t until = score_ ? score_->tick : commands_.empty() ? 0 : commands_.back().tick + 1;
    if (const auto broken = broken_rule(scenario_, commands_, until)) return unusable(*broken);
    if (!score_)
        return tl::unexpected(Failure{Failure::kBadAnswer, "the try at the challenge has not ended"});
    return *score_;
}

bool is_same_challenge(const Scenario& one, const Scenario& other) {
    return rules_of(one) == rules_of(other);
}

std::string challenge_id(const Scenario& scenario) {
    Json rules = rules_of(scenario);
    rules.erase("version");
    rules["terrain"].erase("data");  // its hash stays
    const std::string text = rules.dump(-1, ' ', false, Json::error_handler_t::replace);
    return hex(XXH3_64bits(text.data(), text.size()));
}

}  // namespace game

#include "game/app/results.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "game/analysis/advice.h"
#include "game/app/result_card.h"
#include "game/app/slide_map.h"

namespace game {
namespace {

constexpr double kSlide = 5;         // s; what moves for a shorter time is not called a slide
constexpr double kLeastSlide = 100;  // m³; less is no reason for a card
constexpr double kBeforeSlide = 2;   // s, of the world as it was, when a slide is seen again

// How long it went on until `now`, in seconds of the world, if it has just ended and was a slide.
std::optional<double> just_ended(std::optional<double>& since, bool goes_on, double now) {
    if (goes_on && !since) since = now;
    if (goes_on) return std::nullopt;
    const auto began = std::exchange(since, std::nullopt);
    if (!began || now - *began < kSlide) return std::nullopt;
    return now - *began;
}

}  // namespace

const Score* Results::judge_attempt(const Sandbox& sandbox, std::span<const BestRun> earlier) {
    const Session& session = sandbox.session();
    if (ended_ && sandbox.known_until() < *ended_) score_.reset(), ended_.reset();
    if (session.try_ended_at() != session.state().tick || score_) return nullptr;
    const std::vector<TimedCommand> commands = sandbox.commands_so_far();
    score_ = score_now(sandbox.scenario(), session, commands);
    const std::string advice =
        advice_after(*sandbox.scenario().goal, *score_, session.view(), session.peaks(), session.slab());
    show(card_of(sandbox.scenario(), *score_, earlier, advice), sandbox,
         commands.empty() ? 0 : commands.front().tick);
    return &*score_;
}

std::optional<double> Results::judge_slide(const Sandbox& sandbox, bool creeps) {
    const Session& session = sandbox.session();
    const Scenario& scenario = sandbox.scenario();
    if (scenario.goal || scenario.flow || sandbox.watches() || sandbox.looks_back()) {
        running_since_.reset();
        return std::nullopt;
    }
    const bool runs = sim::flows(session.state()) && !creeps;
    if (runs) shows_card_ = false;
    const auto lasted = just_ended(running_since_, runs, session.seconds());
    if (!lasted || !sandbox.was_touched()) return std::nullopt;
    const Measures measures =
        measure(scenario, session, release_area(scenario, sandbox.commands_so_far()), {});
    if (measures.eroded < kLeastSlide) return measures.eroded;
    const double ticks = std::ceil((*lasted + kBeforeSlide) / static_cast<double>(scenario.params.tick_s));
    show(card_of_slide(scenario, measures, session.seconds()), sandbox,
         session.state().tick - static_cast<std::int64_t>(ticks));
    return std::nullopt;
}

std::optional<double> Results::came_to_rest(const Sandbox& sandbox) {
    if (sandbox.looks_back() || sandbox.watches() || sandbox.scenario().flow) {
        sliding_since_.reset();
        return std::nullopt;
    }
    const bool moves = sim::flows(sandbox.session().state());
    if (moves) may_share_ = false;
    const auto lasted = just_ended(sliding_since_, moves, sandbox.session().seconds());
    if (lasted) may_share_ = true;
    return lasted;
}

const ui::ResultCard* Results::card(const Sandbox& sandbox) const {
    return shows_card_ && ended_ && sandbox.session().state().tick >= *ended_ ? &card_ : nullptr;
}

void Results::show(ui::ResultCard card, const Sandbox& sandbox, std::int64_t began) {
    card_ = std::move(card);
    card_.map = map_of_slide(sandbox.scenario(), sandbox.session(), sandbox.history().by_hand);
    ended_ = sandbox.session().state().tick;
    began_ = std::max<std::int64_t>(began, 0);
    shows_card_ = true;
}

}  // namespace game

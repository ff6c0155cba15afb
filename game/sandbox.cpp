#include "game/sandbox.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace game {
namespace {

constexpr std::size_t kMomentBytes = std::size_t{256} << 20;  // for all that can be undone
constexpr std::size_t kMostActions = 1000;

}  // namespace

Outcome<Sandbox> Sandbox::begin(Opening opening, const sim::How& how, std::optional<Recorder> recorder) {
    auto session = Session::begin(opening.scene.start, how, std::move(recorder));
    if (!session) return tl::unexpected(session.error());
    session->follow_fronts(opening.scene.start);
    const std::size_t per_vertex =
        6 * sizeof(float) + (session->fronts() ? sim::front::TextureLayers::Memory::kBytesPerVertex : 0);
    const std::size_t per_moment = per_vertex * opening.scene.start.grid.size();
    Sandbox sandbox(std::move(opening), std::move(*session));
    sandbox.most_actions_ = std::clamp<std::size_t>(kMomentBytes / per_moment, 1, kMostActions);
    if (sandbox.opening_.watched) {
        sandbox.verifier_.emplace(*sandbox.opening_.watched);
        sandbox.verifier_->look_at(sandbox.session_);
    }
    return sandbox;
}

std::optional<std::int64_t> Sandbox::watched_until() const {
    if (!opening_.watched) return std::nullopt;
    const std::int64_t last = opening_.watched->last_tick();
    return session_.state().tick < last ? std::optional(last) : std::nullopt;
}

std::optional<Verdict> Sandbox::verdict() const {
    return verifier_ ? std::optional(verifier_->verdict()) : std::nullopt;
}

void Sandbox::begin_action(std::string name) {
    new_action_ = std::move(name);
}

Outcome<void> Sandbox::tick(std::span<const sim::Command> hand) {
    // What is in store comes first: it was there before the hand.
    const auto& stored = opening_.scene.commands;
    const std::int64_t tick = session_.state().tick;
    const auto by_tick = [](const TimedCommand& command, std::int64_t than) { return command.tick < than; };
    given_.clear();
    for (auto next = std::lower_bound(stored.begin(), stored.end(), tick, by_tick);
         next != stored.end() && next->tick == tick; ++next)
        given_.push_back(next->command);
    auto refused = leave_out_clashing(0);
    const std::size_t in_store = given_.size();
    given_.insert(given_.end(), hand.begin(), hand.end());
    if (refused) refused = leave_out_clashing(in_store);
    if (given_.size() > in_store && new_action_) remember();

    auto advanced = advance();
    if (verifier_ && session_.state().tick > tick) verifier_->look_at(session_);
    return advanced ? refused : advanced;
}

// Numbers from `first` on that do not go with the others are left out, so that time goes on.
Outcome<void> Sandbox::leave_out_clashing(std::size_t first) {
    const auto fault = sim::fault_after(session_.state().params, given_);
    if (!fault) return {};
    const auto is_set = [](const sim::Command& command) { return command.kind == sim::CommandKind::kSet; };
    given_.erase(std::remove_if(given_.begin() + static_cast<std::ptrdiff_t>(first), given_.end(), is_set),
                 given_.end());
    return unusable(fmt::format("Not set: {}", *fault));
}

// A recording that can no longer be written is left, and the tick is done all the same.
Outcome<void> Sandbox::advance() {
    const std::int64_t tick = session_.state().tick;
    auto advanced = session_.advance(given_);
    if (advanced || advanced.error().status != Failure::kMachine) return advanced;
    session_.stop_recording();
    if (session_.state().tick == tick)
        if (auto again = session_.advance(given_); !again) return again;
    return advanced;
}

void Sandbox::remember() {
    if (past_.size() == most_actions_) past_.pop_front();
    past_.push_back({std::move(*new_action_), session_.moment()});
    new_action_.reset();
}

Outcome<std::string> Sandbox::undo() {
    new_action_.reset();
    if (past_.empty()) return unusable("Nothing to undo");
    const Action action = std::move(past_.back());
    past_.pop_back();
    if (auto rewound = session_.rewind(action.before); !rewound) {
        session_.stop_recording();
        return tl::unexpected(rewound.error());
    }
    return action.name;
}

}  // namespace game

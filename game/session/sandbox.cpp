#include "game/session/sandbox.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "game/files/text_file.h"

namespace game {
namespace {

constexpr std::size_t kMostActions = 1000;
constexpr std::size_t kHandMemory = 4096;  // commands reserved, so that a stroke does not allocate

// Size of a Session::Checkpoint.
std::size_t bytes_per_moment(const Scenario& scenario, bool has_textures) {
    constexpr std::size_t kPowder = sim::powder::Cloud::kMost * sizeof(sim::powder::Puff);
    std::size_t per_vertex = 7 * sizeof(float);
    if (scenario.lower) per_vertex += 3 * sizeof(float);
    if (has_textures) per_vertex += sim::front::TextureLayers::Memory::kBytesPerVertex;
    const bool has_powder = scenario.look.powder.strength > 0 || scenario.look.lower_powder.strength > 0;
    return per_vertex * scenario.grid.size() + (has_powder ? kPowder : 0);
}

void forget_from(std::vector<TimedCommand>& commands, std::int64_t tick) {
    commands.resize(commands.size() - commands_from(commands, tick).size());
}

}  // namespace

Sandbox::Sandbox(LoadedWorld loaded, Session session, std::size_t bytes_per_moment)
    : opening_(std::move(loaded)),
      session_(std::move(session)),
      keyframes_(opening_.memory.for_keyframes(), bytes_per_moment),
      most_actions_(std::clamp<std::size_t>(opening_.memory.for_undo() / bytes_per_moment, 1, kMostActions)) {
    by_hand_.reserve(kHandMemory);
    if (can_go_back()) keyframes_.pass(session_);
    if (!opening_.watched) return;
    known_until_ = opening_.watched->last_tick();
    verifier_.emplace(*opening_.watched);
    verifier_->look_at(session_);
}

Outcome<Sandbox> Sandbox::begin(LoadedWorld loaded, const sim::StepOptions& options,
                                std::optional<Recorder> recorder) {
    const Scenario& scenario = loaded.scene.scenario;
    auto session = Session::begin(scenario, options, std::move(recorder));
    if (!session) return tl::unexpected(session.error());
    session->follow_fronts(scenario);
    session->follow_powder(scenario);
    const std::size_t bytes = bytes_per_moment(scenario, session->fronts() != nullptr);
    return Sandbox(std::move(loaded), std::move(*session), bytes);
}

std::optional<Verdict> Sandbox::verdict() const {
    return verifier_ ? std::optional(verifier_->verdict()) : std::nullopt;
}

Outcome<bool> Sandbox::go_toward(std::int64_t tick, const std::function<bool()>& may_go_on) {
    if (!can_go_back()) return false;
    tick = std::clamp<std::int64_t>(tick, 0, known_until_);
    const std::int64_t now = session_.state().tick;
    const Session::Checkpoint& nearest = keyframes_.before(tick);
    if (tick < now || now < nearest.world.tick)
        if (auto gone = session_.go_to(nearest); !gone) return tl::unexpected(gone.error());
    while (session_.state().tick < tick) {
        if (!may_go_on()) return false;
        if (auto done = this->tick({}); !done) return tl::unexpected(done.error());
    }
    return true;
}

Outcome<Recorder> Sandbox::fork_in(const std::filesystem::path& path) const {
    const std::int64_t tick = session_.state().tick;
    if (const auto& watched = opening_.watched) return Recorder::fork(path, *watched, opening_.name, tick);
    const std::filesystem::path own = session_.recorder()->path();
    const auto recorded = read_recording(own, opening_.memory);
    if (!recorded) return tl::unexpected(recorded.error());
    return Recorder::fork(path, *recorded, own.stem().string(), tick);
}

Outcome<void> Sandbox::take_over(const std::optional<std::filesystem::path>& path) {
    Outcome<void> told;
    if (opening_.watched || session_.recorder()) {
        told = session_.finish();
        auto fork = !told  ? Outcome<Recorder>(tl::unexpected(told.error()))
                    : path ? fork_in(*path)
                           : unusable("no file to record to");
        if (fork) {
            session_.record_in(std::move(*fork));
        } else {
            session_.stop_recording();
            told = tl::unexpected(fork.error());
        }
    }
    if (opening_.watched) forget_from(opening_.scene.commands, session_.state().tick);
    opening_.watched.reset();
    past_.clear();  // earlier actions belong to the other recording
    forget_after(session_.state().tick);
    return told;
}

// Drops the user's commands and their results.
void Sandbox::forget_after(std::int64_t tick) {
    forget_from(by_hand_, tick);
    keyframes_.forget_after(tick);
    known_until_ = tick;
    new_action_.reset();
}

Outcome<std::string> Sandbox::recorded_so_far() const {
    if (opening_.watched && !opening_.scene.files.empty()) return read_text(opening_.scene.files.front());
    if (!session_.recorder()) return unusable("this session is not recorded");
    return session_.recorded_so_far();
}

void Sandbox::begin_action(std::string name) {
    new_action_ = std::move(name);
}

void Sandbox::give_due(const std::vector<TimedCommand>& commands) {
    for (const TimedCommand& due : commands_at(commands, session_.state().tick))
        given_.push_back(due.command);
}

Outcome<void> Sandbox::tick(std::span<const sim::Command> hand) {
    const std::int64_t tick = session_.state().tick;
    const bool knows = looks_back();
    // Commands of the scene or recording come before the user's.
    given_.clear();
    give_due(opening_.scene.commands);
    auto refused = leave_out_clashing(0);
    const std::size_t in_store = given_.size();
    if (knows) give_due(by_hand_);
    if (!knows) {
        const std::size_t running = session_.state().running_commands.size() + in_store;
        const std::size_t room =
            std::min(sim::kMostCommandsPerTick - std::min(in_store, sim::kMostCommandsPerTick),
                     sim::kMostRunningCommands - std::min(running, sim::kMostRunningCommands));
        hand = hand.first(std::min(hand.size(), room));  // drops what exceeds the limits of a tick
        given_.insert(given_.end(), hand.begin(), hand.end());
    }
    if (refused) refused = leave_out_clashing(in_store);
    if (!knows && given_.size() > in_store) {
        if (new_action_) remember();
        for (std::size_t i = in_store; i < given_.size(); ++i) by_hand_.push_back({tick, given_[i]});
    }

    auto advanced = advance();
    if (session_.state().tick > tick) {
        known_until_ = std::max(known_until_, session_.state().tick);
        if (can_go_back()) keyframes_.pass(session_);
        if (verifier_) verifier_->look_at(session_);
    }
    return advanced ? refused : advanced;
}

// Drops parameter changes from `first` on if they clash with the others, so that time continues.
Outcome<void> Sandbox::leave_out_clashing(std::size_t first) {
    const auto fault = sim::fault_after(session_.state().params, given_);
    if (!fault) return {};
    const auto is_set = [](const sim::Command& command) { return command.kind == sim::CommandKind::kSet; };
    given_.erase(std::remove_if(given_.begin() + static_cast<std::ptrdiff_t>(first), given_.end(), is_set),
                 given_.end());
    return unusable(fmt::format("Parameter not set: {}", *fault));
}

// If the recording can no longer be written, stops recording and still runs the tick.
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
    if (looks_back())
        return unusable("Cannot undo in the past: go to the present, or continue from here first");
    const Action action = std::move(past_.back());
    past_.pop_back();
    auto rewound = session_.rewind(action.before);
    forget_after(session_.state().tick);
    if (!rewound) {
        session_.stop_recording();
        return tl::unexpected(rewound.error());
    }
    return action.name;
}

}  // namespace game

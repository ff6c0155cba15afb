#include "game/session/sandbox.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace game {
namespace {

constexpr std::size_t kMostActions = 1000;
constexpr std::size_t kHandMemory = 4096;  // commands reserved, so that a stroke does not allocate

void forget_from(std::vector<TimedCommand>& commands, std::int64_t tick) {
    commands.resize(commands_before(commands, tick).size());
}

// What was recorded so far, as a reader has it.
Outcome<Recording> read_again(const Recorder& recorder, const Memory& memory) {
    auto text = recorder.text();
    if (!text) return tl::unexpected(text.error());
    std::istringstream stream(std::move(*text));
    return read_recording(stream, recorder.name(), memory);
}

// "mine" of "recordings/mine.couloir".
std::string stem_of(const std::string& name) {
    return std::filesystem::path(name).stem().string();
}

}  // namespace

Sandbox::Sandbox(LoadedWorld loaded, Session session)
    : opening_(std::move(loaded)), session_(std::move(session)), keyframes_(opening_.memory.for_keyframes()) {
    by_hand_.reserve(kHandMemory);
    source_.reserve(sim::kMostCommandsPerTick);
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
    session->follow_carried(scenario);
    return Sandbox(std::move(loaded), std::move(*session));
}

void Sandbox::follow_fronts(const render::FlowLook& look) {
    opening_.scene.scenario.look.flow = look;
    session_.follow_fronts(scenario());
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

Outcome<Recorder> Sandbox::fork(const RecordingStore::Open& open) const {
    const std::int64_t tick = session_.state().tick;
    if (const auto& watched = opening_.watched) return Recorder::fork(open, *watched, opening_.name, tick);
    const auto recorded = read_again(*session_.recorder(), opening_.memory);
    if (!recorded) return tl::unexpected(recorded.error());
    return Recorder::fork(open, *recorded, stem_of(session_.recorder()->name()), tick);
}

Outcome<void> Sandbox::take_over(const RecordingStore::Open& open) {
    Outcome<void> told;
    if (opening_.watched || session_.recorder()) {
        told = session_.finish();
        auto forked = told.and_then([&] { return fork(open); });
        if (forked) {
            session_.record_in(std::move(*forked));
        } else {
            session_.stop_recording();
            told = tl::unexpected(forked.error());
        }
    }
    if (opening_.watched) forget_from(opening_.scene.commands, session_.state().tick);
    if (opening_.watched && scenario().goal) {  // what the scene does goes on
        const auto events = commands_from(scenario().goal->events, session_.state().tick);
        opening_.scene.commands.insert(opening_.scene.commands.end(), events.begin(), events.end());
    }
    opening_.watched.reset();
    ++stores_;
    forget_actions_after(session_.state().tick);
    forget_after(session_.state().tick);
    return told;
}

// Of a branch that begins at this tick. What was undone can be redone if no command of the user is discarded.
void Sandbox::forget_actions_after(std::int64_t tick) {
    while (!past_.empty() && past_.back().before.world.tick >= tick) past_.pop_back();
    if (!commands_from(by_hand_, tick).empty()) undone_.clear();
}

// Drops the user's commands and their results.
void Sandbox::forget_after(std::int64_t tick) {
    forget_from(by_hand_, tick);
    keyframes_.forget_after(tick);
    known_until_ = tick;
    returns_ &= looks_back();
    new_action_.reset();
}

Outcome<std::string> Sandbox::recorded_so_far() const {
    if (!session_.recorder()) return unusable("this session is not recorded");
    return session_.recorded_so_far();
}

void Sandbox::begin_action(std::string name) {
    new_action_ = std::move(name);
}

GoalUse Sandbox::goal_use() const {
    GoalUse use(*scenario().goal);
    for (const auto* commands : {&opening_.scene.commands, &by_hand_})
        for (const TimedCommand& each : commands_before(*commands, session_.state().tick))
            use.take(each, session_.state().params.tick_s);
    return use;
}

History Sandbox::history() const {
    if (!opening_.name.empty()) return {{}, commands_so_far()};
    const auto done = commands_before(by_hand_, session_.state().tick);
    return {opening_.scene.commands, {done.begin(), done.end()}};
}

std::vector<TimedCommand> Sandbox::commands_so_far() const {
    std::vector<TimedCommand> all;
    for (const auto* commands : {&opening_.scene.commands, &by_hand_})
        std::ranges::copy(commands_before(*commands, session_.state().tick), std::back_inserter(all));
    std::ranges::stable_sort(all, {}, &TimedCommand::tick);
    return all;
}

// Adds what the rules of the challenge allow. Errors: what they do not, and why; the rest is added.
Outcome<void> Sandbox::add_allowed(std::span<const sim::Command> hand) {
    if (!scenario().goal || hand.empty()) {
        source_.add_new(hand);
        return {};
    }
    Outcome<void> told;
    GoalUse use = goal_use();
    for (const sim::Command& command : hand) {
        const sim::Command fitted = fitted_to(*scenario().goal, command);
        const auto forbidden = use.take({session_.state().tick, fitted}, session_.state().params.tick_s);
        if (!forbidden)
            source_.add_new({&fitted, 1});
        else if (new_action_)  // a stroke that has acted just ends where the rules end it
            told = unusable(fmt::format("Not done: {}", *forbidden));
    }
    return told;
}

// The commands of this tick: those of the scene or the recording, then the user's.
Outcome<void> Sandbox::gather(std::span<const sim::Command> hand) {
    source_.begin(session_.state());
    source_.add_known(opening_.scene.commands);
    auto refused = source_.leave_out_clashing();
    const std::size_t in_store = source_.commands().size();
    const bool knows = looks_back();
    if (knows)
        source_.add_known(by_hand_);
    else if (auto forbidden = add_allowed(hand); refused)
        refused = std::move(forbidden);
    if (auto also_refused = source_.leave_out_clashing(); refused) refused = std::move(also_refused);
    const auto new_ones = source_.commands().subspan(in_store);
    if (knows || new_ones.empty()) return refused;
    undone_.clear();
    if (new_action_) remember();
    for (const sim::Command& command : new_ones) by_hand_.push_back({session_.state().tick, command});
    return refused;
}

Outcome<void> Sandbox::tick(std::span<const sim::Command> hand) {
    const std::int64_t tick = session_.state().tick;
    auto refused = gather(hand);
    auto advanced = advance();
    if (session_.state().tick > tick) {
        known_until_ = std::max(known_until_, session_.state().tick);
        returns_ &= looks_back();
        if (can_go_back()) keyframes_.pass(session_);
        if (verifier_) verifier_->look_at(session_);
    }
    return advanced ? refused : advanced;
}

// If the recording can no longer be written, stops recording and still runs the tick.
Outcome<void> Sandbox::advance() {
    const std::int64_t tick = session_.state().tick;
    auto advanced = session_.advance(source_.commands());
    if (advanced || advanced.error().status != Failure::kMachine) return advanced;
    session_.stop_recording();
    if (session_.state().tick == tick)
        if (auto again = session_.advance(source_.commands()); !again) return again;
    return advanced;
}

// Forgets the oldest actions if memory for undo would not suffice; the newest one stays.
void Sandbox::remember() {
    past_.push_back({std::move(*new_action_), session_.moment(), stores_});
    std::size_t bytes = 0;
    for (const Action& action : past_) bytes += bytes_of(action.before);
    while (past_.size() > 1 && (past_.size() > kMostActions || bytes > opening_.memory.for_undo())) {
        bytes -= bytes_of(past_.front().before);
        past_.pop_front();
    }
    new_action_.reset();
}

// The world may be before that still, on its way after redo().
Outcome<void> Sandbox::go_to_just_before(const Action& action) {
    Outcome<void> rewound;
    const std::int64_t tick = action.before.world.tick;
    if (session_.state().tick >= tick)
        rewound = session_.recorder() && action.store != stores_ ? fork_again_at(action.before)
                                                                 : session_.rewind(action.before);
    if (!rewound) session_.stop_recording();
    forget_after(tick);
    return rewound;
}

// Goes back in a branch to before its beginning: it is written anew, as a branch of the same recording that begins
// there.
Outcome<void> Sandbox::fork_again_at(const Session::Checkpoint& moment) {
    const std::string name = session_.recorder()->name();
    const RecordingStore::Open again = session_.recorder()->again();
    auto recorded =
        session_.finish().and_then([&] { return read_again(*session_.recorder(), opening_.memory); });
    session_.stop_recording();
    ++stores_;
    auto rewound = session_.rewind(moment);
    if (!recorded) return tl::unexpected(recorded.error());
    const std::string parent = recorded->header.parent ? recorded->header.parent->name : stem_of(name);
    auto forked = Recorder::fork(again, *recorded, parent, moment.world.tick);
    if (!forked) return tl::unexpected(forked.error());
    session_.record_in(std::move(*forked));
    return rewound;
}

Outcome<std::string> Sandbox::undo() {
    new_action_.reset();
    if (past_.empty()) return unusable("Nothing to undo");
    if (!may_change_history())
        return unusable("Cannot undo in the past: go to the present, or continue from here first");
    Undone undone{std::move(past_.back()), {}, known_until_};
    past_.pop_back();
    const auto later = commands_from(by_hand_, undone.action.before.world.tick);
    undone.by_hand.assign(later.begin(), later.end());
    auto rewound = go_to_just_before(undone.action);
    std::string name = undone.action.name;
    if (can_go_back()) undone_.push_back(std::move(undone));
    if (!rewound) return tl::unexpected(rewound.error());
    return name;
}

Outcome<std::string> Sandbox::redo() {
    new_action_.reset();
    if (undone_.empty()) return unusable("Nothing to redo");
    if (!may_change_history())
        return unusable("Cannot redo in the past: go to the present, or continue from here first");
    Undone undone = std::move(undone_.back());
    undone_.pop_back();
    auto rewound = go_to_just_before(undone.action);
    by_hand_.insert(by_hand_.end(), undone.by_hand.begin(), undone.by_hand.end());
    known_until_ = undone.known_until;
    returns_ = true;
    std::string name = undone.action.name;
    past_.push_back(std::move(undone.action));
    if (!rewound) return tl::unexpected(rewound.error());
    return name;
}

}  // namespace game

#include "game/app/time_marks.h"

#include <algorithm>

#include "game/controls/tools.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr std::int64_t kSameAction = 30;  // ticks: a stroke that pauses for less is one

// The word for a command, as its tool has it; null for what no tool does.
const char* word_for(sim::CommandKind kind) {
    for (const ToolInfo& info : tool_infos())
        for (const Deed* deed : {info.plain, info.control, info.shift})
            if (deed->kind == kind) return deed->label;
    return nullptr;
}

// How much of what stands is damaged or destroyed.
int damage_in(const Session& session) {
    int sum = 0;
    for (const render::Structure& each : session.structures().all)
        sum += each.state == render::StructureState::kDamaged     ? 1
               : each.state == render::StructureState::kDestroyed ? 2
                                                                  : 0;
    return sum;
}

}  // namespace

void TimeMarks::begin(std::span<const TimedCommand> known, std::span<const std::int64_t> stops) {
    *this = TimeMarks();
    for (const std::int64_t tick : stops) add({tick, ui::TimeMark::Kind::kStop, message("stop")});
    for (const TimedCommand& each : known) add_command(each.tick, each.command.kind);
    if (!known.empty()) known_until_ = known.back().tick + 1;
}

void TimeMarks::see(const Session& session, std::span<const sim::Command> commands) {
    const std::int64_t began = session.state().tick - 1;
    if (began >= known_until_)
        for (const sim::Command& each : commands) add_command(began, each.kind);
    known_until_ = std::max(known_until_, session.state().tick);
    const int damage = damage_in(session);
    if (session.state().tick > seen_until_ && damage > damage_)
        add({session.state().tick, ui::TimeMark::Kind::kHit, message("hit")});
    damage_ = damage;
    seen_until_ = std::max(seen_until_, session.state().tick);
}

void TimeMarks::forget_after(std::int64_t tick) {
    if (tick >= std::max(known_until_, seen_until_)) return;
    std::erase_if(marks_, [&](const ui::TimeMark& mark) { return mark.tick > tick; });
    known_until_ = std::min(known_until_, tick);
    seen_until_ = std::min(seen_until_, tick);
    kind_.reset();
}

void TimeMarks::add_command(std::int64_t tick, sim::CommandKind kind) {
    const char* const word = word_for(kind);
    const bool goes_on = kind_ == kind && tick - tick_ < kSameAction;
    kind_ = kind;
    tick_ = tick;
    if (word && !goes_on) add({tick, ui::TimeMark::Kind::kAction, word});
}

void TimeMarks::add(ui::TimeMark mark) {
    if (marks_.size() == kMost) return;
    const auto place = std::ranges::upper_bound(marks_, mark.tick, {}, &ui::TimeMark::tick);
    marks_.insert(place, mark);
}

std::optional<std::int64_t> TimeMarks::before(std::int64_t tick) const {
    const auto first = std::ranges::lower_bound(marks_, tick, {}, &ui::TimeMark::tick);
    if (first == marks_.begin()) return std::nullopt;
    return std::prev(first)->tick;
}

std::optional<std::int64_t> TimeMarks::after(std::int64_t tick) const {
    const auto next = std::ranges::upper_bound(marks_, tick, {}, &ui::TimeMark::tick);
    if (next == marks_.end()) return std::nullopt;
    return next->tick;
}

}  // namespace game

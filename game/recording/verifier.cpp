#include "game/recording/verifier.h"

#include <utility>

#include <fmt/format.h>

namespace game {
namespace {

// What is wrong with the recorded ledger, if anything.
std::optional<std::string> fault_of(const StateLine& recorded, sim::Ledger replayed) {
    const std::int64_t initial = std::exchange(replayed.initial, 0);  // is not written
    if (replayed != recorded.ledger)
        return fmt::format("at tick {} the mass ledger is not the recorded one", recorded.tick);
    if (const auto error = recorded.ledger.mass_error() - initial; error != 0)
        return fmt::format("at tick {} the recorded mass is off by {} quanta", recorded.tick, error);
    return std::nullopt;
}

}  // namespace

Verifier::Verifier(const Recording& recording) : states_(recording.states) {
    verdict_.comparable = recording.header.physics_version == kPhysicsVersion;
}

// The hash of the tick, if the next line knows it: its own, or one of those before it.
std::optional<std::uint64_t> Verifier::recorded_at(std::int64_t tick) const {
    if (next_ == states_.size()) return std::nullopt;
    const StateLine& line = states_[next_];
    const auto back = static_cast<std::size_t>(line.tick - tick);
    if (back == 0) return line.hash;
    if (back > line.before.size()) return std::nullopt;
    return line.before[line.before.size() - back];
}

void Verifier::look_at(const Session& session) {
    const std::int64_t tick = session.state().tick;
    while (next_ < states_.size() && states_[next_].tick < tick) ++next_;
    const auto recorded = recorded_at(tick);
    if (!recorded || !verdict_.comparable || verdict_.parted || tick <= verdict_.proven_tick) return;

    ++verdict_.compared;
    const StateLine& replayed = session.state_line();
    if (replayed.hash != *recorded)
        verdict_.parted = fmt::format("at tick {} the state's hash is {}, and {} was recorded", tick,
                                      hex(replayed.hash), hex(*recorded));
    else if (const StateLine& line = states_[next_]; line.tick == tick)
        verdict_.parted = fault_of(line, replayed.ledger);
    if (!verdict_.parted) verdict_.proven_tick = tick;
}

}  // namespace game

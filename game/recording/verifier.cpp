#include "game/recording/verifier.h"

#include <utility>

#include <fmt/format.h>

namespace game {

Verifier::Verifier(const Recording& recording) : states_(recording.states) {
    verdict_.comparable = recording.header.physics_version == kPhysicsVersion;
}

void Verifier::look_at(const Session& session) {
    if (next_ == states_.size() || states_[next_].tick != session.state().tick) return;
    const StateLine& recorded = states_[next_++];
    if (!verdict_.comparable || verdict_.parted) return;
    ++verdict_.compared;
    StateLine replayed = session.state_line();
    const std::int64_t initial = std::exchange(replayed.ledger.initial, 0);  // is not written
    if (replayed.hash != recorded.hash)
        verdict_.parted = fmt::format("at tick {} the state's hash is {}, and {} was recorded", recorded.tick,
                                      hex(replayed.hash), hex(recorded.hash));
    else if (replayed.ledger != recorded.ledger)
        verdict_.parted = fmt::format("at tick {} the mass ledger is not the recorded one", recorded.tick);
    else if (const auto error = recorded.ledger.mass_error() - initial; error != 0)
        verdict_.parted =
            fmt::format("at tick {} the recorded mass is off by {} quanta", recorded.tick, error);
    else
        verdict_.proven_tick = recorded.tick;
}

}  // namespace game

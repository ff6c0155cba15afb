#include "game/session/verifier.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace game {
namespace {

// What is wrong with the recorded ledger, if anything.
std::optional<std::string> fault_of(std::int64_t tick, const sim::Ledger& recorded, sim::Ledger replayed) {
    const std::int64_t initial = std::exchange(replayed.initial, 0);  // is not written
    if (replayed != recorded) return fmt::format("at tick {} the mass ledger is not the recorded one", tick);
    if (const auto error = recorded.mass_error() - initial; error != 0)
        return fmt::format("at tick {} the recorded mass is off by {} quanta", tick, error);
    return std::nullopt;
}

}  // namespace

Verdict::Kind Verdict::kind() const {
    if (!comparable) return Kind::kNotComparable;
    if (parted) return Kind::kDiffers;
    return compared > 0 ? Kind::kExact : Kind::kNothingProven;
}

std::string_view to_string(Verdict::Kind kind) {
    switch (kind) {
        case Verdict::Kind::kExact:
            return "exact";
        case Verdict::Kind::kDiffers:
            return "differs";
        case Verdict::Kind::kNothingProven:
            return "nothing proven";
        case Verdict::Kind::kNotComparable:
            break;
    }
    return "not comparable";
}

Verifier::Verifier(const Recording& recording) : is_newer_(recording.header.minor > kFormatMinor) {
    verdict_.comparable = is_comparable(recording.header);
    for (const StateLine& line : recording.states) {
        std::int64_t tick = line.tick - static_cast<std::int64_t>(line.before.size());
        for (const std::uint64_t hash : line.before) hashes_.push_back({tick++, hash});
        hashes_.push_back({line.tick, line.hash});
        masses_.push_back({line.tick, line.ledger});
    }
    // Lines overlap if the user went back and continued.
    std::ranges::stable_sort(hashes_, {}, &Hash::tick);
}

void Verifier::look_at(const Session& session) {
    const std::int64_t tick = session.state().tick;
    while (next_hash_ < hashes_.size() && hashes_[next_hash_].tick < tick) ++next_hash_;
    while (next_mass_ < masses_.size() && masses_[next_mass_].tick < tick) ++next_mass_;
    if (!verdict_.comparable || verdict_.parted || tick <= verdict_.proven_tick) return;
    if (next_hash_ == hashes_.size() || hashes_[next_hash_].tick != tick) return;

    ++verdict_.compared;
    const StateLine& replayed = session.state_line();
    for (std::size_t i = next_hash_; i < hashes_.size() && hashes_[i].tick == tick && !verdict_.parted; ++i)
        if (hashes_[i].value != replayed.hash)
            verdict_.parted = fmt::format("at tick {} the state's hash is {}, and {} was recorded", tick,
                                          hex(replayed.hash), hex(hashes_[i].value));
    if (!verdict_.parted && next_mass_ < masses_.size() && masses_[next_mass_].tick == tick)
        verdict_.parted = fault_of(tick, masses_[next_mass_].ledger, replayed.ledger);
    if (!verdict_.parted) verdict_.proven_tick = tick;
    if (verdict_.parted && is_newer_) verdict_.comparable = false;
}

}  // namespace game

#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "game/ensemble/spec.h"
#include "game/session/peak_watch.h"

namespace game {

// In how many members each vertex passed each threshold. Whole numbers, so that any order of members, and any sum of
// parts, gives the same.
class Exceedances {
  public:
    // `scenario`: the world of all members, for its ground.
    Exceedances(const Scenario& scenario, std::vector<Threshold> thresholds);

    // Which thresholds each vertex passed: bit i is threshold i.
    using Passed = std::vector<std::uint16_t>;
    Passed passed(const Peaks& peaks) const;

    // Counts a member; each once.
    void add(std::int64_t member, const Passed& passed);
    bool has(std::int64_t member) const { return member < std::ssize(done_) && done_[index(member)] != 0; }
    std::int64_t members() const { return members_; }
    const std::vector<Threshold>& thresholds() const { return thresholds_; }
    // Share of the members that passed a threshold, 0 to 1, at each vertex; NaN where there is no ground.
    std::vector<float> probability(std::size_t threshold) const;

    // All of it, and back. Errors: a fact, of bytes that are not those of the counts of this world and these thresholds.
    std::string bytes(const std::string& identity) const;
    std::uintmax_t most_bytes() const;
    tl::expected<void, std::string> take(std::string_view bytes, const std::string& identity);

  private:
    static std::size_t index(std::int64_t member) { return static_cast<std::size_t>(member); }

    const Scenario& scenario_;
    std::vector<Threshold> thresholds_;
    std::vector<std::uint32_t> counts_;  // of each threshold, grid.size() each
    std::vector<std::uint8_t> done_;     // by number of member: 1 if counted
    std::int64_t members_ = 0;
};

}  // namespace game

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

// What a member did to the vertices that it reached: what is counted of it.
struct Marks {
    std::vector<std::uint32_t> vertices;  // ascending
    std::vector<std::uint16_t> passed;    // of each vertex: bit i is threshold i
    std::vector<std::uint16_t> bins;      // of each vertex, of each quantity of Maps::spread() in turn
    std::vector<float> hardness;          // of each vertex, if Maps::hardest
    bool operator==(const Marks&) const = default;
};

// In how many members each vertex passed each threshold, and how often each quantity had which value there. Whole
// numbers, so that any order of members gives the same.
class VertexCounts {
  public:
    // `scenario`: the world of all members, for its ground.
    VertexCounts(const Scenario& scenario, Maps maps);

    Marks marks(const Peaks& peaks) const;
    // Is this what a member of this world could do? For marks that another process sent.
    bool can_count(const Marks& marks) const;

    // Counts a member; each once.
    void add(std::int64_t member, const Marks& marks);
    bool has(std::int64_t member) const { return member < std::ssize(done_) && done_[index(member)] != 0; }
    std::int64_t members() const { return members_; }
    const Maps& maps() const { return maps_; }

    // Share of the members that passed a threshold, 0 to 1, at each vertex; NaN where there is no ground.
    std::vector<float> probability(std::size_t threshold) const;
    // What a share of all members does not exceed, at each vertex; NaN where there is no ground. A member that did not reach a
    // vertex counts as 0 there; of arrival, as never, which is NaN. From a histogram of bins a sixteenth of an octave
    // wide, in which values are taken as even: within 3 % of the exact one.
    std::vector<float> percentile(const Percentile& percentile) const;

    // The member that was hardest to each vertex, the first of equals, or 0. If Maps::hardest.
    std::vector<std::int64_t> hardest() const;

    // All of it, and back. Errors: a fact, of bytes that are not those of the counts of this world and these maps.
    std::string bytes(const std::string& identity) const;
    std::uintmax_t most_bytes() const;
    tl::expected<void, std::string> take(std::string_view bytes, const std::string& identity);

  private:
    struct Bin {
        std::uint16_t bin;
        std::uint32_t members;
    };
    using Histogram = std::vector<Bin>;  // ascending, none empty

    struct Hardest {
        float value = 0;
        std::uint32_t member = 0;
    };

    static std::size_t index(std::int64_t member) { return static_cast<std::size_t>(member); }
    bool has_ground(std::size_t vertex) const;
    const Scenario& scenario_;
    Maps maps_;
    std::vector<Mapped> spread_;         // of maps_
    std::vector<std::uint32_t> counts_;  // of each threshold, grid.size() each
    std::vector<Histogram> histograms_;  // of each quantity of spread_, grid.size() each
    std::vector<Hardest> hardest_;       // grid.size(), or none
    std::vector<std::uint8_t> done_;     // by number of member: 1 if counted
    std::int64_t members_ = 0;
};

}  // namespace game

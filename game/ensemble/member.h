#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/ensemble/spec.h"
#include "game/ensemble/vertex_counts.h"
#include "game/recording/json_values.h"

namespace game {

// What a finished run of an ensemble came to.
struct Member {
    std::int64_t number = 0;     // from 1
    std::vector<double> sample;  // of each variable
    std::string fault;           // why it could not run; all below is 0 then
    std::string ended;           // "energy", "rest", "limit"
    double seconds = 0;
    double released = 0;           // m³ that rolled at tick 0
    double run_out = 0, fall = 0;  // m
    double toe_x = 0,
           toe_y = 0;      // m east and north of the south-west vertex: the farthest place that it reached
    double extent = 0;     // m²
    double eroded = 0;     // m³
    double top_speed = 0;  // m/s, along the slope
    double thickness = 0;  // m, normal to the slope: the greatest
    std::string hash;      // of its last state
    bool operator==(const Member&) const = default;
};

// A line of the journal, without its end, and back. Errors: a fact.
std::string line_of(const Member& member);
tl::expected<Member, std::string> member_of(const std::string& line);

// Plays a member, alone or beside others on threads of their own. Draws nothing and follows no front; ends when the
// kinetic energy has fallen to 1 % of its greatest, as `run --until-rest` does. With `record` it is a recording too.
// Errors: mass was not conserved, a recording cannot be written, or `stop` became true, which leaves nothing.
struct PlayedMember {
    Member member;
    Marks marks;  // empty if it could not run
};
Outcome<PlayedMember> play_member(const EnsembleSpec& spec, std::int64_t number, const VertexCounts& counts,
                                  const std::function<bool()>& stop,
                                  const std::optional<std::filesystem::path>& record = std::nullopt);

}  // namespace game

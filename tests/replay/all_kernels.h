#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace game::test {

struct Replays {
    std::int64_t count = 0;
    std::int64_t states = 0;  // compared
};

// Replays a recording by every kernel of this processor and on 1, 2, 3 and 8 threads. Returns the first fault, as a
// sentence: damage, a state that differs, mass that was not conserved, or a claim that its commands do not prove.
std::optional<std::string> fault_of_recording(const std::filesystem::path& file, Replays& tally);

}  // namespace game::test

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "game/base/volumes.h"

namespace game::sound {

inline constexpr int kRate = 44100;  // samples per second

// What can be heard. A loop is heard while something goes on; a shot once.
enum class Wave : std::uint8_t {
    kRumble,
    kRoar,
    kHiss,
    kStones,
    kWind,
    kScrape,
    kBlast,
    kEcho,
    kCrack,
    kTree,
    kWood,
    kWall,
    kMetal,
    kHint,
    kMedal,
    kRefusal,
};
inline constexpr std::size_t kWaves = 16;

struct WaveInfo {
    Wave wave;
    std::string_view name;
    Group group;
    bool loops;
    double seconds;
    double least_hz, most_hz;  // nine tenths of its power are between them
    std::string_view meaning;
};
std::span<const WaveInfo, kWaves> wave_infos();
inline const WaveInfo& info_of(Wave wave) {
    return wave_infos()[static_cast<std::size_t>(wave)];
}

// What a person reads of a group.
struct GroupInfo {
    const char *name, *meaning;
};
const GroupInfo& info_of(Group group);

inline constexpr float kPeak = 0.9f;        // of a shot, and the most of a loop
inline constexpr double kLoopLevel = 0.18;  // root mean square of a loop

// Its samples, −kPeak to kPeak: made of noise and sine waves, the same in every call. The end of a loop goes on as it
// begins; a shot begins and ends in silence.
std::vector<float> samples_of(Wave wave);
using SamplesOfWaves = std::vector<std::vector<float>>;
SamplesOfWaves samples_of_waves();

}  // namespace game::sound

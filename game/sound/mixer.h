#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "game/base/volumes.h"
#include "game/sound/hearing.h"
#include "game/sound/waves.h"
#include "render/view/camera.h"
#include "sim/world/state.h"

namespace game::sound {

// Who listens, and what they do.
struct Ear {
    glm::dvec3 at{0};                        // m
    glm::dvec3 ahead{0, 1, 0}, up{0, 0, 1};  // unit vectors
    double above_m = 100;                    // above the ground
    bool passes = true;                      // time; else nothing is heard but notes
    bool looks = true;                       // the window has the focus
    std::optional<glm::dvec3> scrapes;       // where a tool acts
};

// Who sees through this camera hears from there.
Ear ear_of(const render::Camera& camera, const sim::View& world);

// A loop as it is to be heard now.
struct Voice {
    Wave wave = Wave::kRumble;
    glm::dvec3 from{0};  // m from the ear; {0, 0, 0}: from everywhere
    float gain = 0;      // 0 to 1
    float pitch = 1;
    float spread = 0;  // m
};
// A shot that begins now. Notes are heard from everywhere.
using Shot = Voice;

// Turns what happens in a world into voices. It alone knows how loud something is, at which distance.
class Mixer {
  public:
    static constexpr std::size_t kLoops = 4 * kFlowEmitters + 3;
    static constexpr std::size_t kMostShots = 16;  // at the same time

    // Levels in decibels of sound pressure at the ear: what is so loud is as loud as can be played, and so far below
    // something is heard no more. Between them a difference is made smaller, as an ear does.
    static constexpr double kLoudest = 95, kQuietest = 25, kSlope = 0.5;

    // A moment `elapsed_s` after the last. `happened`: since then.
    void mix(const Heard& heard, std::span<const Happened> happened, const sim::View& world, const Ear& ear,
             const Volumes& volumes, double elapsed_s);
    // A note for the listener.
    void note(Wave wave);

    std::span<const Voice> loops() const { return loops_; }
    // What begins with this moment; the caller has played it before the next.
    std::span<const Shot> shots() const { return shots_; }

  private:
    struct Later {
        Happened what;
        double due_s = 0;
    };
    void add_echoes(const Happened& blast, const sim::View& world, const Ear& ear);
    void set(std::size_t loop, Wave wave, const glm::dvec3& from, double gain, double spread,
             double elapsed_s);

    double now_s_ = 0;
    std::array<Voice, kLoops> loops_{};
    std::vector<Later> later_;
    std::vector<Wave> notes_;
    std::vector<Shot> shots_;
};

// Pressure level of a source of so many watts at this distance, dB: power level less the sphere, less what air takes at these
// frequencies.
double level_at(double watts, double distance_m, double absorbed_db_per_km);
// As Mixer says of kLoudest.
double gain_of(double level_db);

}  // namespace game::sound

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "game/session/session.h"
#include "game/sound/waves.h"

namespace game::sound {

// Something that sounds without end. Places as a camera has them, m.
struct Emitter {
    glm::dvec3 at{0};
    double watts = 0;   // acoustic power
    double spread = 0;  // mean distance of the sound from `at`, m
    double speed = 0;   // mean of what flows there, m/s
    double stony = 0;   // share of the power that is of earth, 0 to 1
};
inline constexpr std::size_t kFlowEmitters = 3;  // as many arms of a flow are told apart

// What goes on in a world now.
struct Heard {
    std::array<Emitter, kFlowEmitters> flow;
    Emitter powder;
};

// What has happened once. `after_s`: so much later than it is told.
struct Happened {
    Wave wave;
    glm::dvec3 at{0};
    double watts = 0;  // acoustic power
    double after_s = 0;
};

// Listens to a world, wherever the listener is. A view: it never affects the world, and hears the same in each replay.
// docs/sound.md has the numbers and their sources.
class Hearing {
  public:
    static constexpr double kEfficiency = 1e-6;    // of the work of friction, that becomes sound
    static constexpr double kFriction = 0.35;      // of a flow, roughly, whatever its material
    static constexpr double kUsualDensity = 500;   // kg/m³, where a world has none
    static constexpr double kStonyDensity = 1000;  // kg/m³; what is denser knocks
    static constexpr double kBlastWatts = 300;     // of a blast with a radius of 10 m

    explicit Hearing(const Session& session) { begin(session); }

    // Call after a tick, with the commands at its start. What has happened in it is added to happened(). After going back it
    // starts again: nothing has happened.
    void see(const Session& session, std::span<const sim::Command> commands);
    const std::vector<Happened>& happened() const { return happened_; }
    void forget() { happened_.clear(); }

    // What goes on now. Costs what moves; cells that are near an emitter stay with it from one call to the next.
    const Heard& look(const Session& session);

  private:
    void begin(const Session& session);
    void see_blasts(const Session& session, std::span<const sim::Command> commands);
    void see_things(const Session& session);
    void see_trees(const Session& session);
    void look_at_flow(const Session& session);
    void look_at_powder(const Session& session);

    std::int64_t tick_ = 0;
    std::int64_t rolling_ = 0;          // quanta, before the tick
    std::int64_t things_ = 0;           // sim::Things::changed
    std::vector<std::int8_t> broken_;   // of each thing: 0 whole, 1 damaged, 2 destroyed
    std::vector<std::uint16_t> lying_;  // of each wooded vertex
    Heard heard_;
    std::vector<Happened> happened_;
};

}  // namespace game::sound

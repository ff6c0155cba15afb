#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "game/python/convert.h"
#include "game/recording/command_source.h"
#include "game/session/session.h"

namespace game::python {

// A world for Python: a session, the commands that it was loaded with, and those that were given since. All functions throw
// Error.
class World {
  public:
    // `threads`: of a step; they never change results.
    World(Scene scene, int threads);

    // Acts at the start of the next tick, after those that it was loaded with.
    void give(const sim::Command& command);
    // Runs so many ticks, and calls `after_tick`, if it is set, after each, with the hash of its state. If what was given
    // clashes with the world, nothing has changed, and it is forgotten.
    void step(std::int64_t ticks, const std::function<void(const Session&)>& after_tick = {});
    // Runs as `couloir run --until-rest` does: until the kinetic energy has fallen to 1 % of its greatest, or nothing moves,
    // or so many seconds of the world have passed. Returns what ended it.
    std::string run_until_rest(double most_seconds);
    // Records from here on, if no tick has passed; finish() ends the file, and the world goes on unrecorded.
    void record(const std::filesystem::path& file);
    void finish();

    const Scenario& scenario() const { return scene_.scenario; }
    const std::vector<std::string>& warnings() const { return scene_.warnings; }
    // Throws Error while another thread steps it.
    const Session& session() const;
    std::string hash();

  private:
    void advance();

    Scene scene_;
    Session session_;
    CommandSource source_;
    std::vector<sim::Command> given_;
    bool is_stepped_ = false;
};

void add_worlds(py::module_& module);

}  // namespace game::python

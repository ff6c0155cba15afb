#pragma once

#include <optional>
#include <span>
#include <string>

#include "game/analysis/headless.h"
#include "game/commands/commands.h"
#include "game/session/perf_log.h"

namespace game {

// Frames, web page and log of times of one session that `run` or `replay` plays.
class Outputs {
  public:
    // What these outputs need in memory, beside the session, and which files they read and write.
    static void add_to(WorldUse& use, const OutputOptions& options);
    static void add_to(FileUse& use, const OutputOptions& options);

    // Begins with the state of `session`, and touches no file. `proof`: what the page says of where its slide is from
    // (proof_of()). `options` outlives the outputs. Errors: as SlidePage::begin().
    static Outcome<Outputs> begin(const OutputOptions& options, const Scenario& scenario, Session& session,
                                  std::string proof);
    // Opens the files, before the work starts. Errors: one cannot be written, or there is no OpenGL (3).
    Outcome<void> open(const Scenario& scenario);
    // Prints what cannot be drawn, begins the log, and returns the observers of the session; they refer to these outputs.
    Watchers watch(const Scenario& scenario, Session& session, PerfSurroundings surroundings);
    // Draws the maps of the results, if there are frames to lay them beside.
    void draw_results(const Session& session);
    // Ends the frames and writes the page. Errors: status 3.
    Outcome<void> close(const Session& session, std::span<const TimedCommand> commands);

    const PerfLog& perf() const { return *perf_; }
    // Which draws the film; there is one if there are frames or a film.
    Gallery& gallery() { return *gallery_; }

  private:
    explicit Outputs(const OutputOptions& options) : options_(&options) {}

    const OutputOptions* options_;
    std::optional<SlidePage> page_;
    std::optional<Gallery> gallery_;
    std::optional<PerfLog> perf_;
};

}  // namespace game

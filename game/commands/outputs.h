#pragma once

#include <optional>
#include <span>
#include <string>

#include "game/analysis/headless.h"
#include "game/commands/commands.h"
#include "game/session/perf_log.h"

namespace game {

// Frames, film, web page and log of times of one session that `run` or `replay` plays.
class Outputs {
  public:
    // What these outputs need in memory, beside the session, and which files they read and write.
    static void add_to(WorldUse& use, const OutputOptions& options);
    static void add_to(FileUse& use, const OutputOptions& options);

    // Begins with the state of `session`, and touches no file. `proof`: what the page says of where its slide is from
    // (proof_of()). `options` outlives the outputs. Errors: as SlidePage::begin().
    static Outcome<Outputs> begin(const OutputOptions& options, const Scenario& scenario, Session& session,
                                  std::string proof);
    // Whether a film can be written as it is wanted, if it is. Call it first. Errors: as Film::check().
    static Outcome<void> check(const OutputOptions& options);
    // Opens the files, before the work starts. Errors: one cannot be written, or there is no OpenGL (3).
    Outcome<void> open(const Scenario& scenario);
    // Opens the film, if one is wanted, of a run from now until then. `commands` and `session` outlive the outputs, which stay
    // where they are. From then on Ctrl+C makes the run fail, and nothing of the film remains. Errors: nothing can be filmed so
    // (2), or it cannot be written (3).
    Outcome<void> open_film(const Scenario& scenario, const Session& session,
                            std::span<const TimedCommand> commands, const Until& until,
                            const sim::StepOptions& step);
    // Prints what cannot be drawn, begins the log, and returns the observers of the session; they refer to these outputs.
    Watchers watch(const Scenario& scenario, Session& session, PerfSurroundings surroundings);
    // "filming", if that takes most of the time; else as it is.
    const char* doing(const char* otherwise) const { return film_ ? "filming" : otherwise; }
    // Draws the maps of the results, if there are frames to lay them beside.
    void draw_results(const Session& session);
    // Ends film and frames, and writes the page. Errors: status 3.
    Outcome<void> close(const Session& session, std::span<const TimedCommand> commands);

    const PerfLog& perf() const { return *perf_; }

  private:
    explicit Outputs(const OutputOptions& options) : options_(&options) {}

    const OutputOptions* options_;
    std::optional<SlidePage> page_;
    std::optional<Gallery> gallery_;
    std::optional<FilmedSession> film_;
    std::span<const TimedCommand> filmed_;  // its commands
    std::optional<PerfLog> perf_;
};

}  // namespace game

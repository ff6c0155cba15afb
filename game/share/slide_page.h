#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/analysis/played_run.h"
#include "game/base/outcome.h"
#include "game/scene/lesson.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "render/view/camera.h"

namespace game {

struct PageOptions {
    static constexpr std::int64_t kEvery = 6;  // ticks; between rarer states a front would jump by cells
    std::int64_t every = kEvery;               // ticks between two states that are kept
    std::uint64_t most_bytes = 32'000'000;     // of the page
    std::optional<render::Camera> camera = std::nullopt;  // none: the scenario's, or else a landscape view
    bool plays = true;  // the page has the world itself, so that whoever opens it can take over
    std::shared_ptr<const PlayedRun> to_beat = nullptr;  // of a challenge: the run that the page asks to beat
    std::optional<std::string> site_name =
        std::nullopt;  // of a page in a site: its name there; it leads back to the index
    std::shared_ptr<const Lesson> lesson = nullptr;  // of a recording: given in the page
};

struct PageReport {
    std::uint64_t bytes = 0;
    std::int64_t frames = 0;
    std::vector<std::string> notices = {};  // what is not in the page, a sentence each
    std::string about = {};                 // "loose dry snow, 146 s, run-out 1 283 m, up to 46.2 m/s"
};

// A page, and what is told of it.
struct MadePage {
    std::string text;
    PageReport report;
};

// Writes a slide as one web page that plays it in a browser, with its numbers and its state hash, and lets a person take it
// over there: it has the recording and the module that computes it (game/live). The page has
// everything: the program and shaders of assets/web and assets/shaders, and the states as whole quanta. Equal slides
// give equal pages. A view: it never affects the world. docs/web.md has the format.
class SlidePage {
  public:
    // `session` at tick 0, following powder if the page is to have it. `proof`: the command that repeats the slide.
    // Errors: a flow scene has no slide, (status 2); the page's
    // files are missing, or its module is of another version of the physics (status 3).
    static Outcome<SlidePage> begin(const Scenario& scenario, const Session& session, std::string proof,
                                    const PageOptions& options);
    ~SlidePage();
    SlidePage(SlidePage&&) noexcept;
    SlidePage& operator=(SlidePage&&) noexcept;

    // Call after each tick. Keeps what is due. Errors (status 2): the page has become too large; a depth or a speed is
    // beyond what it keeps; ground is sculpted or a forest planted after tick 0.
    Outcome<void> see(const Session& session);
    // The page gives this lesson, as PageLesson has it. Call before write().
    void set_lesson(Json lesson);
    // Ends the page; the last state is in it. `commands`: all of the slide. Errors: as see().
    Outcome<MadePage> make(const Session& session, std::span<const TimedCommand> commands);
    // The same into a file. Errors: it cannot be written (status 3).
    Outcome<PageReport> write(const std::filesystem::path& file, const Session& session,
                              std::span<const TimedCommand> commands);

  private:
    struct Parts;
    explicit SlidePage(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace game

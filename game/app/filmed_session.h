#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/analysis/gallery.h"
#include "game/analysis/headless.h"
#include "game/base/outcome.h"
#include "game/controls/film_camera.h"
#include "game/files/film.h"
#include "game/files/part_file.h"
#include "game/scene/scenario.h"
#include "game/session/session.h"
#include "game/sound/sound_file.h"
#include "render/view/camera.h"
#include "sim/engine.h"

namespace game {

struct FilmOptions {
    std::optional<std::filesystem::path> file;
    int fps = 60;  // images per second of the world and of the film, 1 to 120
    FilmView view = FilmView::kScene;
    bool silent = false;
    std::optional<std::filesystem::path> path_file = {};  // of kPath; none: the path of the scene
    std::vector<CameraKey> path = {};                     // of kPath
};

// The camera path of a film: from its file, or else that of the scene. Errors (2): it cannot be read, or there is none.
Outcome<std::vector<CameraKey>> path_of_film(const FilmOptions& options, const Scenario& scenario);

// Where view_from_front() of the whole run stands. Plays it until then. Errors: it cannot be played; nothing flows (2).
Outcome<render::Camera> front_camera(const Scenario& scenario, std::span<const TimedCommand> commands,
                                     const Until& until, const sim::StepOptions& options);

// Films a session while it is played, with what is heard at the camera. A second of the film is one of the world: each image
// shows the last tick before its end, so that ticks are left out or shown twice where there are fewer images or more.
class FilmedSession {
  public:
    // Of `ticks` ticks from now on; nothing: until close(). `home`: where the camera begins, unless it is kTop. The gallery
    // draws in the film's size, and outlives it.
    // Errors: as Film::open(); no time passes (2).
    static Outcome<FilmedSession> open(const FilmOptions& options, const Session& session,
                                       std::optional<std::int64_t> ticks, const render::Camera& home,
                                       Gallery& gallery);

    // Why it has no sound, though it should; else empty.
    const std::string& notice() const { return notice_; }
    // Call after each tick, with the commands at its start. Errors: the film cannot be written (3).
    Outcome<void> see(const Session& session, std::span<const sim::Command> commands);
    // After the last. Errors: as Film::close().
    Outcome<void> close();

  private:
    FilmedSession(const FilmOptions& options, Film film, const Session& session,
                  std::optional<std::int64_t> ticks, const render::Camera& home, Gallery& gallery);
    Outcome<void> open_sound(const std::filesystem::path& path, const Session& session);

    Gallery* gallery_;
    Film film_;
    FilmCamera camera_;
    int fps_;
    double begins_s_;                    // of the world
    std::int64_t first_;                 // tick it begins at
    std::optional<std::int64_t> ticks_;  // how many
    std::string notice_;
    std::optional<PartFile> wav_;
    std::optional<sound::SoundFile> sound_;
};

}  // namespace game

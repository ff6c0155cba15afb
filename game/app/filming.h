#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/base/job.h"
#include "game/base/outcome.h"
#include "game/controls/film_wish.h"
#include "render/view/camera.h"
#include "render/view/look.h"

namespace game {

// Films a slide while the window goes on: plays its recording once more and draws it, on a thread of low priority with an
// OpenGL context of its own. One film at a time. Use it from one thread.
class Filming {
  public:
    struct Subject {
        std::string recording;  // the text of the whole file
        std::string name;       // of the new file in couloir/films of the XDG data folder
        std::int64_t last = 0;  // tick; it begins shortly before the first command
        render::Camera camera;  // as the window sees it, the light, and the date of its look
        render::Light light;
        std::optional<render::Date> date = {};
        std::vector<CameraKey> path = {};  // of FilmView::kPath
    };
    // Starts; nothing must be under way. Errors: the system cannot start a thread.
    Outcome<void> begin(Subject subject, const FilmWish& wish);
    // 0 to 1; nothing unless a film is under way.
    std::optional<double> progress() const;
    // Ends it early; nothing remains, and result() has nothing.
    void stop() { job_.stop(); }

    struct Made {
        std::filesystem::path file;
        double seconds = 0;
        std::string notice;  // why it has no sound; else empty
    };
    // How it ended, once; nothing while it is under way. Errors: the recording cannot be played, there is no ffmpeg or no
    // second OpenGL context, or the file cannot be written; then nothing remains.
    std::optional<Outcome<Made>> result() { return job_.result(); }

  private:
    Outcome<Made> film(const Subject& subject, const FilmWish& wish, const std::atomic<bool>& stopped);

    std::atomic<float> progress_ = 0;
    Job<Made> job_;
};

}  // namespace game

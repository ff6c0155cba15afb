#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "game/base/outcome.h"
#include "game/controls/photo.h"
#include "game/scene/scenario.h"
#include "render/pictures/picture.h"
#include "render/view/camera.h"

namespace game {

// Where and when a screenshot was taken.
struct Shot {
    const Scenario& scenario;
    std::filesystem::path recording;  // the session's, or the watched one; empty if there is none
    std::int64_t tick = 0;
    render::Camera camera;
    double focus_m = 0;                       // of such a photo
    std::optional<PhotoSettings> photo = {};  // how it was taken in the photo mode
};

// The texts in the PNG of a screenshot: title, scene, recording, tick, time, program, camera as in a scene, and the
// places of the camera and of what it looks at, if the world has a place on Earth. Of a photo also focal length and
// exposure.
render::PngTexts texts_of(const Shot& shot);

// Writes screenshots on threads of its own, so that the window need not wait. Use it from one thread.
class Screenshots {
  public:
    static constexpr std::size_t kMostAtOnce = 4;

    // The user wants one; asked() says so once.
    void ask() { asked_ = true; }
    bool asked() { return std::exchange(asked_, false); }
    // Starts writing to a new file NAME.png in screenshots_folder(). Waits while kMostAtOnce are being written.
    // Errors: the system cannot start a thread.
    Outcome<void> write(render::Picture picture, std::string name, render::PngTexts texts);

    // The file of the next screenshot that is written; nothing if there is none yet. Errors: no folder, or it
    // cannot be written, and then no file remains.
    std::optional<Outcome<std::filesystem::path>> result();

  private:
    bool asked_ = false;
    std::vector<std::future<Outcome<std::filesystem::path>>>
        jobs_;  // in order; each is waited for at the end
};

}  // namespace game

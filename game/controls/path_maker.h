#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "game/controls/camera_spline.h"
#include "game/scene/camera_key.h"

namespace game {

// The camera path that a person makes in the window, and its preview. It is a view: nothing of the world depends on it.
class PathMaker {
  public:
    static constexpr double kSameTime = 0.05;  // s; keys that are closer are one

    // Begins with these keys, and ends the preview.
    void begin(std::vector<CameraKey> keys);
    const std::vector<CameraKey>& keys() const { return keys_; }  // by time
    bool is_path() const;                                         // has keys enough for a film
    // A key of this camera, rounded to what a person can read; it replaces a key of the same time. False: there are
    // kMostCameraKeys already, or the time is beyond CameraKey::kLatest.
    bool add(double time_s, const render::Camera& camera);
    void remove(std::size_t key);

    // The preview, of a path.
    void play() { plays_ = is_path(); }
    void stop() { plays_ = false; }
    bool plays() const { return plays_; }
    const CameraSpline& spline() const { return *spline_; }  // while there is a key

  private:
    void fit();

    std::vector<CameraKey> keys_;
    std::optional<CameraSpline> spline_;
    bool plays_ = false;
};

}  // namespace game

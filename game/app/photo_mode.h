#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "game/controls/camera_control.h"
#include "game/controls/photo.h"
#include "render/view/lens.h"

namespace game {

// The photo mode: how the photo is taken, and what is given back to the camera when it ends. The light of the window
// never changes: the photo has its own.
class PhotoMode {
  public:
    bool is_on() const { return settings_.has_value(); }
    // Begins with the lens of the camera and the light as it is, on that date of the scene's plants. `aspect`: of the
    // image, width / height. `focus`: a place, m, that is sharp if not all is.
    void begin(const Scenario& scenario, const CameraControl& camera, const render::Light& light,
               std::optional<render::Date> date, double aspect, const glm::dvec3& focus);
    // Gives the camera its field of view back.
    void end(CameraControl& camera);

    // While it is on:
    const PhotoSettings& settings() const { return *settings_; }
    void set(const PhotoSettings& settings) { settings_ = settings; }
    // Puts the lens onto the camera.
    void fit(CameraControl& camera, double aspect);
    double hour() const { return settings_->hour.value_or(hour_); }  // of the sun, or of one like it
    render::Light light() const { return settings_->hour ? light_at(*settings_->hour, day_) : light_; }
    void focus_on(const glm::dvec3& place) { focus_ = place; }
    double focus_m(const render::Camera& camera) const;  // distance along the view
    render::Lens lens(const render::Camera& camera, double aspect) const;

  private:
    std::optional<PhotoSettings> settings_;
    CameraControl::FieldsOfView before_;
    PhotoDay day_;
    double hour_ = 12;
    double first_mm_ = 0;  // the focal length of the camera before
    render::Light light_;
    glm::dvec3 focus_{0};
};

}  // namespace game

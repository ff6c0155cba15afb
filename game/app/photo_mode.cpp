#include "game/app/photo_mode.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace game {

void PhotoMode::begin(const Scenario& scenario, const CameraControl& camera, const render::Light& light,
                      std::optional<render::Date> date, double aspect, const glm::dvec3& focus) {
    before_ = camera.fields_of_view();
    first_mm_ = focal_length_of(before_.now, aspect);
    settings_ = PhotoSettings{.focal_mm = first_mm_};
    day_ = photo_day(scenario, date);
    hour_ = hour_like(light, day_);
    light_ = light;
    focus_ = focus;
}

void PhotoMode::end(CameraControl& camera) {
    settings_.reset();
    camera.set_fields_of_view(before_);
}

// Untouched it is the lens of the camera, bit by bit.
void PhotoMode::fit(CameraControl& camera, double aspect) {
    const double view =
        settings_->focal_mm == first_mm_ ? before_.now : field_of_view_of(settings_->focal_mm, aspect);
    camera.set_fields_of_view({view, view, view});
}

double PhotoMode::focus_m(const render::Camera& camera) const {
    constexpr double kNearest = 1;
    const glm::dvec3 eye = render::eye(camera), along = (camera.target - eye) / camera.distance_m;
    return std::max(glm::dot(focus_ - eye, along), kNearest);
}

render::Lens PhotoMode::lens(const render::Camera& camera, double aspect) const {
    const double focus = focus_m(camera);
    return {.exposure = std::exp2(settings_->exposure),
            .blur = blur_of(*settings_, focus, aspect),
            .focus_m = focus};
}

}  // namespace game

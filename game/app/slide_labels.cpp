#include "game/app/slide_labels.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace game {

void SlideLabels::trace(const Sandbox& sandbox, const View& view,
                        const std::function<std::optional<glm::dvec2>(glm::dvec2)>& seen,
                        const std::function<std::optional<glm::dvec3>(glm::dvec2)>& under) {
    const Session& session = sandbox.session();
    const bool rests = session.state().tick > session.changed_at();
    const std::int64_t changed_at = rests ? session.changed_at() : session.changed_at() / kStep * kStep;
    if (view_ == view && changed_at_ == changed_at) return;
    const bool elsewhere = !view_ || view_->epoch != view.epoch || changed_at_ != changed_at;
    view_ = view, changed_at_ = changed_at;
    if (elsewhere) {
        const std::array commands{std::span<const TimedCommand>(sandbox.opening().scene.commands),
                                  sandbox.by_hand()};
        parts_.find(sandbox.scenario(), session.view(), session.peaks(), commands);
    }
    count_ = 0;
    for (std::size_t i = 0; i < SlideParts::kParts; ++i) {
        const auto part = static_cast<SlideParts::Part>(i);
        const auto place = parts_.at(part) ? seen(*parts_.at(part)) : std::nullopt;
        if (place) labels_[count_++] = {part, *place};
    }
    find_compass(under);
}

// The scale is that of the land in the middle of the image, or of the nearest land below it.
void SlideLabels::find_compass(const std::function<std::optional<glm::dvec3>(glm::dvec2)>& under) {
    constexpr double kDown = 0.1;     // of half the height
    constexpr double kFlattest = 35;  // degrees: from lower down an arrow on the ground could not be read
    const render::Camera& camera = view_->camera;
    const double azimuth = glm::radians(camera.azimuth_deg),
                 down = std::sin(glm::radians(std::max(std::abs(camera.elevation_deg), kFlattest)));
    compass_ = ui::Compass{{std::sin(azimuth), down * std::cos(azimuth)},
                           {-std::cos(azimuth), down * std::sin(azimuth)},
                           std::nullopt};
    std::optional<glm::dvec3> ground;
    for (double y = 0; !ground && y > -1; y -= kDown) ground = under({0, y});
    if (!ground) return;
    const double away = -(render::view_matrix(camera) * glm::dvec4(*ground, 1)).z;  // m, along the view
    if (away <= 0) return;
    compass_->metre_px = view_->height / (2 * std::tan(glm::radians(camera.field_of_view_deg) / 2) * away);
}

}  // namespace game

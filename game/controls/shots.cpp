#include "game/controls/shots.h"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "game/controls/camera_path.h"
#include "game/controls/camera_room.h"
#include "game/scene/surface.h"
#include "render/mountain/pick.h"

namespace game {
namespace {

constexpr std::size_t kCloseShots = 3;               // between the two of the whole
constexpr double kWholeLasts = 4, kCloseLasts = 6;   // s, the first shot and those that follow
constexpr double kLeastShot = 1.5;                   // s, of a shot
constexpr double kLostFor = 0.5;                     // s, that the front is out of view until a shot ends
constexpr double kMiddle = 0.85;                     // of the half image, in which the front must be
constexpr double kLooksAhead = 110;                  // m before the front, where a camera looks
constexpr double kEyeAway = 330, kEyeElevation = 9;  // m, degrees: of the eye from there
constexpr double kShotFieldOfView = 48;              // degrees
constexpr std::array<double, 4> kEyeAside{40, 65, 20, 90};    // degrees from the heading, in order of liking
constexpr std::array<double, 4> kPathAhead{0, 80, 160, 240};  // m before the front, which a camera should see

glm::dvec3 place_on_ground(glm::dvec2 at, const sim::View& world) {
    return {at, surface_height(world, at)};
}

// Whether the place is in the middle of the image, and no ground before it.
bool sees(const render::Camera& camera, glm::dvec3 place, const Shots::Seen& seen) {
    const Sight sight = sight_of(place, camera);
    const double up = std::tan(glm::radians(camera.field_of_view_deg / 2));
    if (sight.depth <= 0 || std::abs(sight.at.x) > kMiddle * up * seen.aspect ||
        std::abs(sight.at.y) > kMiddle * up)
        return false;
    return !render::is_hidden(seen.world, place, render::eye(camera));
}

// Stands ahead of the front and beside its way, on the given side, where most of the way is seen.
render::Camera close_shot(const SlideFront::Front& front, double side, const Shots::Seen& seen) {
    const double ahead = glm::degrees(std::atan2(front.heading.x, front.heading.y));
    const glm::dvec2 from(front.at);
    const CameraRoom room(seen.world, seen.around);
    render::Camera best;
    int most = -1;
    for (const double aside : kEyeAside) {
        const render::Camera camera =
            room.inside({.target = place_on_ground(from + kLooksAhead * front.heading, seen.world),
                         .azimuth_deg = ahead + side * aside,
                         .elevation_deg = kEyeElevation,
                         .distance_m = kEyeAway,
                         .field_of_view_deg = kShotFieldOfView});
        int seen_of_path = 0;
        for (const double before : kPathAhead)
            seen_of_path +=
                sees(camera, place_on_ground(from + before * front.heading, seen.world), seen) ? 1 : 0;
        if (seen_of_path > most) most = seen_of_path, best = camera;
    }
    return best;
}

}  // namespace

std::optional<render::Camera> Shots::next(const Seen& seen) {
    if (!began_s_) {
        began_s_ = seen.now_s;
        return whole_;
    }
    const double lasts = seen.now_s - *began_s_;
    const bool is_close = shot_ > 0 && shot_ <= kCloseShots;
    if (!seen.front || shot_ > kCloseShots) return std::nullopt;
    if (!is_close || sees(seen.camera, seen.front->at, seen))
        left_s_.reset();
    else if (!left_s_)
        left_s_ = seen.now_s;
    const bool left = left_s_ && seen.now_s - *left_s_ >= kLostFor && lasts >= kLeastShot;
    if (!left && lasts < (is_close ? kCloseLasts : kWholeLasts)) return std::nullopt;

    ++shot_;
    began_s_ = seen.now_s;
    left_s_.reset();
    if (shot_ > kCloseShots) return whole_;
    return close_shot(*seen.front, shot_ % 2 == 1 ? 1 : -1, seen);
}

}  // namespace game

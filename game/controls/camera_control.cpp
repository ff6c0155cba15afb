#include "game/controls/camera_control.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace game {
namespace {

using Drag = CameraWish::Drag;

constexpr double kLowest = 3, kHighest = 89;  // degrees of elevation
constexpr double kDown = 89.9;                // degrees; north is still up
constexpr double kTurn = 90;                  // degrees per half image width
constexpr double kZoom = 0.85;                // factor of the distance, per step
constexpr double kPaces = 0.5;                // of the distance, per second
constexpr double kFast = 4;
constexpr double kLag = 0.08;      // s, in which the remaining path falls to 1/e
constexpr double kLongest = 0.25;  // s, limit for held keys in one frame
constexpr double kSteps = 240;     // per second; fixed steps make the path independent of the frame rate
constexpr double kCatchUp = 0.5;   // s, in which the way to what is followed falls to 1/e
constexpr double kAhead = 35;  // degrees between the heading of what is followed and the direction to the eye
constexpr double kChaseElevation = 12;                       // degrees
constexpr double kNearChase = 200, kFarChase = 420;          // m, but
constexpr double kNearChaseCells = 20, kFarChaseCells = 40;  // at most so many cells
constexpr double kGrazing = 0.15;  // sine below which a ray is too flat to drag the ground with

// Limits input, so that sums and powers stay finite.
CameraWish within_reason(CameraWish wish) {
    wish.from = glm::clamp(wish.from, -100.0, 100.0);
    wish.to = glm::clamp(wish.to, -100.0, 100.0);
    wish.zoom_steps = std::clamp(wish.zoom_steps, -500.0, 500.0);
    wish.walk = glm::clamp(wish.walk, -1.0, 1.0);
    return wish;
}

glm::dvec2 tangents(glm::dvec2 picture, const render::Camera& camera, double aspect) {
    return picture * glm::dvec2(aspect, 1) * std::tan(glm::radians(camera.field_of_view_deg) / 2);
}

// The same azimuth, reached from another by the shorter rotation.
double the_short_way(double azimuth, double from) {
    return from + std::remainder(azimuth - from, 360.0);
}

bool same(const render::Camera& a, const render::Camera& b) {
    return a.target == b.target && a.azimuth_deg == b.azimuth_deg && a.elevation_deg == b.elevation_deg &&
           a.distance_m == b.distance_m && a.field_of_view_deg == b.field_of_view_deg;
}

}  // namespace

CameraControl::CameraControl(const render::Camera& home, const sim::View& world,
                             const render::Surroundings& around)
    : home_(CameraRoom(world, around).inside(home)), now_(home_), goal_(home_), before_top_down_(home_) {}

bool CameraControl::still() const {
    return !look_down_ && same(now_, goal_);
}

void CameraControl::fly(bool on) {
    dragging_ = Drag::kNone;  // a drag in progress grabs a new point
    if (on) {
        top_down(false);
        mode_ = CameraMode::kFly;
    } else if (mode_ == CameraMode::kFly) {
        mode_ = CameraMode::kOrbit;
        if (goal_.elevation_deg >= kLowest) return;
        const glm::dvec3 eye = render::eye(goal_);
        goal_.elevation_deg = kLowest;
        goal_.target = eye + goal_.distance_m * axes(goal_).forward;
        hold_ = {Grip::About::kEye, {}};
    }
}

void CameraControl::chase(bool on) {
    if (on == (mode_ == CameraMode::kChase)) return;
    fly(false);
    top_down(false);
    dragging_ = Drag::kNone;
    mode_ = on ? CameraMode::kChase : CameraMode::kOrbit;
    chase_begins_ = on;
}

void CameraControl::top_down(bool on) {
    if (on == (mode_ == CameraMode::kTopDown)) return;
    dragging_ = Drag::kNone;
    if (on) {
        before_top_down_ = goal_;
        mode_before_top_down_ = mode_;
        mode_ = CameraMode::kTopDown;
        look_down_ = true;
    } else {
        goal_ = before_top_down_;
        goal_.azimuth_deg = the_short_way(goal_.azimuth_deg, now_.azimuth_deg);
        mode_ = mode_before_top_down_;
        look_down_ = false;
    }
}

void CameraControl::go_to(const render::Camera& pose) {
    goal_ = pose;
    goal_.azimuth_deg = the_short_way(pose.azimuth_deg, now_.azimuth_deg);
    hold_ = {};
    dragging_ = Drag::kNone;
    mode_ = CameraMode::kOrbit;
    look_down_ = false;
}

void CameraControl::cut_to(const render::Camera& pose) {
    go_to(pose);
    now_ = goal_;
}

void CameraControl::move(const CameraWish& asked, const sim::View& world, const render::Surroundings& around,
                         double asked_aspect, double elapsed_s) {
    const CameraRoom room(world, around);
    const CameraWish wish = within_reason(asked);
    const double aspect =
        asked_aspect > 0 ? std::min(asked_aspect, 100.0) : 1;  // a minimised window has none
    const double elapsed = elapsed_s > 0 ? std::min(elapsed_s, 3600.0) : 0,
                 acted = std::min(elapsed, kLongest);
    const int steps = std::max(1, static_cast<int>(std::ceil(acted * kSteps - 1e-6)));

    goal_ = room.inside(goal_);  // the ground may have risen
    look_down(room);
    begin_chase(wish, room);
    take_hold(wish, aspect, room);
    zoom(wish.zoom_steps, room);
    for (int i = 0; i < steps; ++i) {
        const glm::dvec2 to = glm::mix(wish.from, wish.to, (i + 1.0) / steps);
        if (!can_hold(hold_.point, goal_)) hold_.point = goal_.target;  // walked past it
        if (wish.drag == Drag::kTurn) turn((wish.to - wish.from) / static_cast<double>(steps), aspect, room);
        if (wish.drag == Drag::kPan) pan(wish, to, aspect, room);
        walk(wish, acted / steps, room);
        follow(wish, acted / steps, room);
        goal_ = room.inside(goal_);
        approach(acted / steps, room);
    }
    approach(elapsed - acted, room);

    if (look_alike(now_, goal_)) now_ = goal_;
    const double turns = 360 * std::floor(now_.azimuth_deg / 360);
    now_.azimuth_deg -= turns;
    goal_.azimuth_deg -= turns;
}

void CameraControl::look_down(const CameraRoom& room) {
    if (!look_down_) return;
    look_down_ = false;
    const glm::dvec3 middle = room.ground_in_the_middle(goal_);
    const double away = glm::distance(render::eye(goal_), middle);
    goal_.target = middle;
    goal_.azimuth_deg = the_short_way(180, now_.azimuth_deg);
    goal_.elevation_deg = kDown;
    goal_.distance_m = std::clamp(away, room.nearest(), room.farthest());
    goal_ = room.inside(goal_);
    hold_ = {Grip::About::kPoint, middle};
}

// The eye goes ahead of what is followed, on the side on which it is already.
void CameraControl::begin_chase(const CameraWish& wish, const CameraRoom& room) {
    if (wish.drag == Drag::kPan || wish.walk != glm::dvec3(0)) chase(false);
    if (mode_ != CameraMode::kChase || !chase_begins_ || !wish.followed) return;
    chase_begins_ = false;
    const double ahead = glm::degrees(std::atan2(wish.followed->heading.x, wish.followed->heading.y));
    const double side = std::remainder(goal_.azimuth_deg - ahead, 360) < 0 ? -1 : 1;
    goal_.azimuth_deg = the_short_way(ahead + side * kAhead, now_.azimuth_deg);
    goal_.elevation_deg = kChaseElevation;
    goal_.distance_m = std::clamp(goal_.distance_m, std::min(kNearChase, kNearChaseCells * room.cell()),
                                  std::min(kFarChase, kFarChaseCells * room.cell()));
    goal_.target = wish.followed->at;
    goal_ = room.inside(goal_);
    hold_ = {Grip::About::kTarget, goal_.target};
}

void CameraControl::follow(const CameraWish& wish, double seconds, const CameraRoom& room) {
    if (mode_ != CameraMode::kChase || !wish.followed) return;
    goal_.target += (wish.followed->at - goal_.target) * -std::expm1(-seconds / kCatchUp);
    goal_ = room.inside(goal_);
    hold_ = {Grip::About::kTarget, goal_.target};
}

// A drag grabs a point where it is visible now, although the camera may still be moving.
void CameraControl::take_hold(const CameraWish& wish, double aspect, const CameraRoom& room) {
    const bool begins = wish.drag != dragging_;
    dragging_ = wish.drag;
    const bool zooms = wish.zoom_steps != 0;
    if (!zooms && (!begins || wish.drag == Drag::kNone)) return;
    const bool chases = mode_ == CameraMode::kChase;
    if (!zooms && wish.drag == Drag::kTurn && mode_ != CameraMode::kOrbit && !chases) return;

    glm::dvec3 point = now_.target;
    if (!chases && wish.pivot && room.reaches(*wish.pivot) && can_hold(*wish.pivot, now_))
        point = *wish.pivot;
    else if (wish.drag == Drag::kPan)
        point = point_at({tangents(wish.from, now_, aspect), now_.distance_m}, now_);
    hold_ = {Grip::About::kPoint, point};
    if (can_hold(point, goal_))
        place(goal_, point, {sight_of(point, now_).at, sight_of(point, goal_).depth});
    else
        goal_ = now_;
}

void CameraControl::zoom(double steps, const CameraRoom& room) {
    if (steps == 0) return;
    const Sight sight = sight_of(hold_.point, goal_);
    const double slant = glm::length(glm::dvec3(sight.at, 1)), away = slant * sight.depth;
    const double wanted = std::clamp(away * std::pow(kZoom, steps), std::min(away, room.nearest()),
                                     std::max(away, room.farthest()));
    goal_ = room.first_clear([&](double share) {
        render::Camera there = goal_;
        double depth = wanted / slant;
        if (steps > 0)  // nearer, or not quite so near
            depth *= std::pow(away / wanted, share);
        else  // farther, and above terrain behind the eye
            there.elevation_deg =
                glm::mix(goal_.elevation_deg, std::max(goal_.elevation_deg, kHighest), share);
        there.distance_m = depth;  // the target moves along with the cursor
        place(there, hold_.point, {sight.at, depth});
        return there;
    });
}

void CameraControl::turn(glm::dvec2 by, double aspect, const CameraRoom& room) {
    if (mode_ == CameraMode::kTopDown) return;
    const glm::dvec2 degrees = kTurn * by * glm::dvec2(1, -1 / aspect);
    const bool flies = mode_ == CameraMode::kFly;
    const double lowest = std::min(flies ? -kHighest : kLowest, goal_.elevation_deg),
                 highest = std::max(kHighest, goal_.elevation_deg);
    const double azimuth = goal_.azimuth_deg + degrees.x,
                 elevation = std::clamp(goal_.elevation_deg + degrees.y, lowest, highest);
    if (flies) {
        const glm::dvec3 eye = render::eye(goal_);
        goal_.azimuth_deg = azimuth;
        goal_.elevation_deg = elevation;
        goal_.target = eye + goal_.distance_m * axes(goal_).forward;
        hold_ = {Grip::About::kEye, {}};
        return;
    }
    const Sight sight = sight_of(hold_.point, goal_);
    goal_ = room.first_clear([&](double share) {
        render::Camera there = goal_;
        there.azimuth_deg = azimuth;
        there.elevation_deg = glm::mix(elevation, highest, share);
        place(there, hold_.point, sight);
        return there;
    });
}

// Moves the eye at constant height. If the ray grazes the ground, this would move too far, so the eye moves
// parallel to the image instead.
void CameraControl::pan(const CameraWish& wish, glm::dvec2 to, double aspect, const CameraRoom& room) {
    constexpr double kFarOut = 2;  // image coordinates; the cursor may be outside the window
    Sight sight = sight_of(hold_.point, goal_);
    sight.at = tangents(glm::clamp(to, -kFarOut, kFarOut), goal_, aspect);
    const Axes a = axes(goal_);
    const glm::dvec3 ray = a.forward + sight.at.x * a.right + sight.at.y * a.up;
    const double rise = hold_.point.z - render::eye(goal_).z;
    if (wish.pivot && std::abs(ray.z) > kGrazing * glm::length(ray) && rise / ray.z > 0)
        sight.depth = std::min(rise / ray.z, room.farthest());
    goal_ = room.first_clear([&](double share) {
        render::Camera there = goal_;
        const double back = std::max(1.0, room.farthest() / sight.depth);
        place(there, hold_.point, {sight.at, sight.depth * std::pow(back, share)});
        return there;
    });
}

void CameraControl::walk(const CameraWish& wish, double seconds, const CameraRoom& room) {
    const double hurry = glm::length(wish.walk);
    if (hurry == 0) return;
    const bool flies = mode_ == CameraMode::kFly;
    const Axes a = axes(goal_);
    const glm::dvec3 ahead = flies ? a.forward : glm::cross(glm::dvec3(0, 0, 1), a.right);
    const double height = room.height_above_ground(goal_);
    // Looking down by 30°, as is usual, both are the same.
    const double scale = flies ? 2 * height : std::max(goal_.distance_m, height);
    const double pace =
        kPaces * std::clamp(scale, 4 * room.cell(), room.farthest()) * (wish.fast ? kFast : 1);
    const glm::dvec3 way = wish.walk.x * a.right + wish.walk.y * ahead + wish.walk.z * glm::dvec3(0, 0, 1);
    goal_.target += way / std::max(1.0, hurry) * pace * seconds;
    if (wish.drag == Drag::kNone && wish.zoom_steps == 0)
        hold_ = {flies ? Grip::About::kEye : Grip::About::kTarget, {}};
}

void CameraControl::approach(double seconds, const CameraRoom& room) {
    now_ = room.inside(along(now_, goal_, hold_, -std::expm1(-seconds / kLag)));
}

}  // namespace game

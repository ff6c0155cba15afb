#include "game/controls/path_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/base/limits.h"

namespace game {
namespace {

// To a thousandth of its unit.
double readable(double value) {
    constexpr double kParts = 1000;
    return std::round(value * kParts) / kParts + 0.0;  // 0, not −0
}

}  // namespace

void PathMaker::begin(std::vector<CameraKey> keys) {
    keys_ = std::move(keys);
    stop();
    fit();
}

bool PathMaker::is_path() const {
    return keys_.size() >= kFewestCameraKeys;
}

bool PathMaker::add(double time_s, const render::Camera& camera) {
    if (!(time_s >= 0 && time_s <= CameraKey::kLatest)) return false;
    CameraKey key{readable(time_s), camera};
    key.camera.target = {readable(camera.target.x), readable(camera.target.y), readable(camera.target.z)};
    key.camera.azimuth_deg =
        readable(std::remainder(camera.azimuth_deg, 360.0));  // it may have turned on and on
    for (double render::Camera::*value :
         {&render::Camera::elevation_deg, &render::Camera::distance_m, &render::Camera::field_of_view_deg})
        key.camera.*value = readable(camera.*value);
    const auto same = std::ranges::find_if(
        keys_, [&](const CameraKey& each) { return std::abs(each.time_s - time_s) < kSameTime; });
    if (same != keys_.end()) {
        same->camera = key.camera;
    } else if (keys_.size() == kMostCameraKeys) {
        return false;
    } else {
        keys_.insert(std::ranges::upper_bound(keys_, key.time_s, {}, &CameraKey::time_s), key);
    }
    fit();
    return true;
}

void PathMaker::remove(std::size_t key) {
    if (key >= keys_.size()) return;
    keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(key));
    if (!is_path()) stop();
    fit();
}

void PathMaker::fit() {
    if (keys_.empty())
        spline_.reset();
    else
        spline_.emplace(keys_);
}

}  // namespace game

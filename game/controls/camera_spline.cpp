#include "game/controls/camera_spline.h"

#include <algorithm>
#include <cmath>

#include "sim/core/check.h"

namespace game {
namespace {

constexpr std::size_t kAzimuth = 3;  // its place among the values

// The slope at a key, of the slopes of the straight lines before and after it, which last `before` and `after` seconds:
// their weighted harmonic mean, or 0 where the value turns.
double monotone_slope(double slope_before, double before, double slope_after, double after) {
    if (slope_before * slope_after <= 0) return 0;
    const double weight_before = 2 * after + before, weight_after = after + 2 * before;
    return (weight_before + weight_after) / (weight_before / slope_before + weight_after / slope_after);
}

}  // namespace

CameraSpline::Values CameraSpline::values_of(const render::Camera& camera) {
    return {camera.target.x,
            camera.target.y,
            camera.target.z,
            camera.azimuth_deg,
            camera.elevation_deg,
            std::log(camera.distance_m),
            std::log(camera.field_of_view_deg)};
}

render::Camera CameraSpline::camera_of(const Values& values) {
    return {.target = {values[0], values[1], values[2]},
            .azimuth_deg = values[kAzimuth],
            .elevation_deg = values[4],
            .distance_m = std::exp(values[5]),
            .field_of_view_deg = std::exp(values[6])};
}

CameraSpline::CameraSpline(std::span<const CameraKey> keys) {
    CHECK(!keys.empty());
    knots_.reserve(keys.size());
    for (const CameraKey& key : keys) {
        Values value = values_of(key.camera);
        if (!knots_.empty()) {
            const double before = knots_.back().value[kAzimuth];
            value[kAzimuth] = before + std::remainder(value[kAzimuth] - before, 360.0);
        }
        knots_.push_back({key.time_s, value, {}});
    }
    for (std::size_t k = 1; k + 1 < knots_.size(); ++k) {
        const Knot &last = knots_[k - 1], &next = knots_[k + 1];
        Knot& knot = knots_[k];
        const double before = knot.time_s - last.time_s, after = next.time_s - knot.time_s;
        for (std::size_t i = 0; i < knot.value.size(); ++i)
            knot.slope[i] = monotone_slope((knot.value[i] - last.value[i]) / before, before,
                                           (next.value[i] - knot.value[i]) / after, after);
    }
}

render::Camera CameraSpline::at(double time_s) const {
    const auto next = std::ranges::upper_bound(knots_, time_s, {}, &Knot::time_s);
    if (next == knots_.begin()) return camera_of(next->value);
    const Knot& from = *(next - 1);
    if (next == knots_.end()) return camera_of(from.value);
    const double lasts = next->time_s - from.time_s, s = (time_s - from.time_s) / lasts;
    // The cubic Hermite basis: 1 − b for the value before, b for the value after, and the two slopes.
    const double b = s * s * (3 - 2 * s), slope_before = s * (1 - s) * (1 - s) * lasts,
                 slope_after = s * s * (s - 1) * lasts;
    Values values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = (1 - b) * from.value[i] + b * next->value[i] + slope_before * from.slope[i] +
                    slope_after * next->slope[i];
    return camera_of(values);
}

}  // namespace game

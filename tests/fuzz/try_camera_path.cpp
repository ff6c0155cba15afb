#include "tests/fuzz/try_reader.h"

#include "game/base/limits.h"
#include "game/controls/camera_spline.h"
#include "game/scene/camera_keys.h"

namespace game::test {
namespace {

Outcome<void> try_camera_path(const std::filesystem::path& file) {
    const auto keys = load_camera_path(file);
    if (!keys) return tl::unexpected(keys.error());
    if (keys->size() < kFewestCameraKeys || keys->size() > kMostCameraKeys) return broken("too few or many");
    for (std::size_t k = 1; k < keys->size(); ++k)
        if (!((*keys)[k - 1].time_s < (*keys)[k].time_s)) return broken("times do not increase");
    const CameraSpline spline(*keys);
    for (const double share : {0.0, 0.3, 0.5, 0.99}) {
        const render::Camera at =
            spline.at(spline.begins_s() + share * (spline.ends_s() - spline.begins_s()));
        if (!(std::abs(at.elevation_deg) < 90 && at.distance_m > 0 && at.field_of_view_deg > 4 &&
              at.field_of_view_deg < 121 && std::abs(at.target.x) < 2 * kFarthestTarget))
            return broken("a camera is no number or out of range");
    }
    return {};
}

}  // namespace

const TriedReader kTriedCameraPath{"camera_path", "x.toml", try_camera_path};

}  // namespace game::test

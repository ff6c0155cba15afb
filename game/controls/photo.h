#pragma once

#include <array>
#include <optional>

#include "game/scene/scenario.h"
#include "render/view/look.h"

namespace game {

// How a photo is taken. Nothing of it outlives the photo mode.
struct PhotoSettings {
    static constexpr double kMostExposure = 3;  // EV, up and down

    double focal_mm = 35;             // focal length in front of a sensor 36 mm wide
    double exposure = 0;              // EV, −kMostExposure to kMostExposure
    std::optional<double> hour = {};  // of the day, 0 to 24, by the sun; nothing: in the light as it was
    double f_number = 0;              // focal length by diameter of the aperture, kFNumbers; 0: all is sharp
    int times = 1;                    // 1, 2 or 4: as wide and high as the window so many times
    bool operator==(const PhotoSettings&) const = default;
};

inline constexpr std::array kFNumbers{0.0, 22.0, 16.0, 11.0, 8.0, 5.6, 4.0, 2.8, 2.0, 1.4};

// The vertical field of view, degrees, behind a focal length, mm, and back. `aspect`: width / height of the image.
double field_of_view_of(double focal_mm, double aspect);
double focal_length_of(double field_of_view_deg, double aspect);
// The focal lengths that a camera may have, mm.
struct FocalLengths {
    double least, most;
};
FocalLengths focal_lengths(double aspect);

// How far the lens blurs what is infinitely far, in heights of the image, while it is sharp at a distance of `focus_m`. A
// mountain is far away for every lens: the photo is that of a model of it, kModelScale times smaller.
inline constexpr double kModelScale = 500;
double blur_of(const PhotoSettings& settings, double focus_m, double aspect);

// A day on which the sun is photographed: where, and at which declination, degrees. The sun culminates at 12 h.
struct PhotoDay {
    double latitude_deg = 47;
    double declination_deg = -13;
};
// At the place of a world, or else at 47° north: on the date, or without one in the middle of February where the layer is as
// bright as snow, else in the middle of July.
PhotoDay photo_day(const Scenario& scenario, std::optional<render::Date> date);
// The sun at an hour of it, 0 to 24, no lower than a scene may have it.
render::Light light_at(double hour, const PhotoDay& day);
// The hour of it at which the sun is nearest to that of `light`, in steps of a quarter.
double hour_like(const render::Light& light, const PhotoDay& day);

}  // namespace game

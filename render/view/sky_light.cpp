#include "render/view/sky_light.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>

#include "render/base/ramp.h"

namespace render {
namespace {

constexpr double kMoonTakesOver = -2;  // degrees of the sun; the sun has set, the moon does not shine yet
constexpr double kMoonElevation = 35;  // degrees
const glm::dvec3 kMoon(0.160, 0.198, 0.268);

// The share of light that passes the air above a place, by the height of its source, ≥ 0 degrees.
glm::dvec3 transmitted(double elevation_deg) {
    const double mass =
        1 / (std::sin(glm::radians(elevation_deg)) + 0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
    return glm::exp(-mass * glm::dvec3(0.052, 0.098, 0.190));
}

// A colour at noon, by day far above the horizon (`high`) and at it (`low`), at dusk and at night.
struct Hours {
    glm::dvec3 noon, high, low, dusk, night;
};

constexpr Hours kAbove{{0.064, 0.124, 0.262},
                       {0.120, 0.182, 0.285},
                       {0.205, 0.222, 0.310},
                       {0.106, 0.154, 0.286},
                       {0.010, 0.017, 0.038}};
constexpr Hours kBelow{{0.088, 0.086, 0.088},
                       {0.125, 0.125, 0.128},
                       {0.165, 0.142, 0.138},
                       {0.070, 0.074, 0.104},
                       {0.010, 0.014, 0.024}};
constexpr Hours kToward{
    {0.47, 0.62, 0.80}, {0.60, 0.74, 0.90}, {0.90, 0.64, 0.46}, {0.98, 0.46, 0.300}, {0.034, 0.052, 0.092}};
constexpr Hours kAway{
    {0.42, 0.58, 0.80}, {0.57, 0.72, 0.90}, {0.56, 0.51, 0.62}, {0.23, 0.185, 0.30}, {0.028, 0.044, 0.082}};
constexpr Hours kZenith{{0.036, 0.125, 0.36},
                        {0.080, 0.200, 0.46},
                        {0.095, 0.165, 0.350},
                        {0.034, 0.062, 0.170},
                        {0.0050, 0.0095, 0.026}};

}  // namespace

SkyLight sky_light(double sun_elevation_deg) {
    const double h = std::max(sun_elevation_deg, 0.0);
    const double low = std::exp(-h / 9);  // 1 with the sun at the horizon
    const double dusk = ramp(2, -6, sun_elevation_deg), night = ramp(-5, -15, sun_elevation_deg);
    const double noon = ramp(12, 58, sun_elevation_deg);
    const auto now = [=](const Hours& of) {
        const glm::dvec3 day = glm::mix(glm::mix(of.high, of.noon, noon), of.low, low);
        return glm::mix(glm::mix(day, of.dusk, dusk), of.night, night);
    };
    // The air dims a low sun to a hundredth. A camera would follow, and so does this exposure. It keeps slopes
    // of snow that face a high sun below white.
    const double exposure = 0.62 + 1.75 * std::exp(-h / 19);
    const glm::dvec3 through = transmitted(h);
    const double up = ramp(-1, 1.5, sun_elevation_deg);  // share of the sun above the horizon

    SkyLight light;
    light.moon = sun_elevation_deg < kMoonTakesOver;
    light.lamp_elevation_deg = light.moon ? kMoonElevation : sun_elevation_deg;
    light.lamp = light.moon ? night * kMoon : exposure * up * through;
    light.above = now(kAbove);
    light.below = now(kBelow);
    light.openness_contrast = 0.7 * (1 - std::exp(-h / 25)) + 0.3 * noon + 0.6 * dusk;
    light.sunward = glm::mix(glm::mix(0.5 * std::cos(glm::radians(h)), 0.7, dusk), -0.4, night);
    light.haze = 0.92 - 0.30 * low;
    light.toward = now(kToward);
    light.away = now(kAway);
    light.zenith = now(kZenith);
    light.glow = light.moon ? 0.35 * night * kMoon : (0.55 + 0.5 * low) * up * through;
    // Clouds are kilometres up, where the sun rises earlier and sets later.
    light.cloud = 0.60 * exposure * ramp(-7, 0, sun_elevation_deg) * transmitted(h + 3) + 0.9 * light.above +
                  0.35 * night * kMoon;
    light.stars = ramp(-6, -14, sun_elevation_deg);
    return light;
}

}  // namespace render

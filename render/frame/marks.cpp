#include "render/frame/marks.h"

#include <array>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "assets/shaders/slots.glsl"

namespace render {
namespace {

// Classes of the Swiss, Austrian and French slope maps. Each is darker than the previous one, so that their
// order shows without hue.
constexpr std::array<LegendStop, 4> kSlope{{
    {30, {0.98f, 0.87f, 0.30f}},
    {35, {0.95f, 0.57f, 0.16f}},
    {40, {0.80f, 0.22f, 0.20f}},
    {45, {0.40f, 0.19f, 0.52f}},
}};

// Viridis at six even steps (van der Walt and Smith 2015, public domain). Its steps of lightness are even,
// and so are its hues for people with colour-vision deficiency. Both layers share one scale so that they can
// be compared. The scale nearly doubles at each step, to show both thin flows and deposits of metres.
constexpr std::array<LegendStop, 6> kDepth{{
    {0.1f, {0.267f, 0.005f, 0.329f}},
    {0.2f, {0.254f, 0.265f, 0.530f}},
    {0.5f, {0.164f, 0.471f, 0.558f}},
    {1.0f, {0.135f, 0.659f, 0.518f}},
    {2.0f, {0.478f, 0.821f, 0.318f}},
    {5.0f, {0.993f, 0.906f, 0.144f}},
}};

// Plasma at six even steps, by the same authors and with the same method. Its hues differ, so that a speed is
// not mistaken for a depth. The range spans creeping soil to dry snow at full speed.
constexpr std::array<LegendStop, 6> kSpeed{{
    {0, {0.050f, 0.030f, 0.528f}},
    {2, {0.417f, 0.001f, 0.658f}},
    {5, {0.693f, 0.165f, 0.565f}},
    {10, {0.881f, 0.393f, 0.383f}},
    {20, {0.988f, 0.652f, 0.211f}},
    {40, {0.940f, 0.975f, 0.131f}},
}};

// A stretch near 1 shows faintly; a stretch of 2 shows clearly.
constexpr std::array<LegendStop, 5> kStretch{{
    {1, {0.93f, 0.93f, 0.93f}},
    {1.25f, {0.98f, 0.87f, 0.55f}},
    {1.5f, {0.96f, 0.60f, 0.30f}},
    {2, {0.78f, 0.16f, 0.24f}},
    {4, {0.25f, 0.04f, 0.28f}},
}};

// Classes of impact pressure, one hue from light to dark, so that it is mistaken for neither speed nor depth.
constexpr std::array<LegendStop, 5> kPressure{{
    {1, {0.98f, 0.75f, 0.80f}},
    {3, {0.96f, 0.52f, 0.68f}},
    {10, {0.86f, 0.25f, 0.56f}},
    {30, {0.62f, 0.04f, 0.48f}},
    {100, {0.29f, 0.00f, 0.37f}},
}};

// Classes of a probability, viridis again, but dark is likely: even one run of many shows.
constexpr std::array<LegendStop, 6> kProbability{{
    {0.5f, {0.993f, 0.906f, 0.144f}},
    {5, {0.478f, 0.821f, 0.318f}},
    {25, {0.135f, 0.659f, 0.518f}},
    {50, {0.164f, 0.471f, 0.558f}},
    {75, {0.254f, 0.265f, 0.530f}},
    {95, {0.267f, 0.005f, 0.329f}},
}};

// Shares of saturation, one blue hue from light to dark: dark is wet.
constexpr std::array<LegendStop, 5> kWater{{
    {10, {0.84f, 0.92f, 0.97f}},
    {25, {0.60f, 0.78f, 0.88f}},
    {50, {0.30f, 0.57f, 0.78f}},
    {75, {0.09f, 0.35f, 0.65f}},
    {100, {0.03f, 0.14f, 0.40f}},
}};

static_assert(kSlope.size() <= MOST_STOPS && kDepth.size() <= MOST_STOPS && kSpeed.size() <= MOST_STOPS &&
              kStretch.size() <= MOST_STOPS && kPressure.size() <= MOST_STOPS &&
              kProbability.size() <= MOST_STOPS && kWater.size() <= MOST_STOPS);

}  // namespace

Legend legend_of(Overlay overlay) {
    switch (overlay) {
        case Overlay::kSlope:
            return {kSlope, "°", true};
        case Overlay::kStanding:
        case Overlay::kRolling:
            return {kDepth, "m", false};
        case Overlay::kSpeed:
            return {kSpeed, "m/s", false};
        case Overlay::kStretch:
            return {kStretch, ": 1", false};
        case Overlay::kPressure:
            return {kPressure, "kPa", true};
        case Overlay::kProbability:
            return {kProbability, "%", true};
        case Overlay::kWater:
            return {kWater, "%", false};
        case Overlay::kNone:
            break;
    }
    return {{}, "", false};
}

Outline outline_of(glm::dvec2 middle, double turn, double length, double width, const glm::vec3& colour) {
    const double angle = glm::radians(turn);
    const glm::dvec2 half = 0.5 * length * glm::dvec2(std::sin(angle), std::cos(angle));
    return {middle - half, middle + half, width, true, colour};
}

double contour_interval(HeightRange heights) {
    constexpr double kMostLines = 40;
    const double range = static_cast<double>(heights.highest) - heights.lowest;
    for (double power = 1;; power *= 10) {
        for (const double interval : {power, 2 * power, 5 * power}) {
            if (!(range > kMostLines * interval)) return interval;
        }
    }
}

}  // namespace render

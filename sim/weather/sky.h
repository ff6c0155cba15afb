#pragma once

#include "sim/core/angle.h"
#include "sim/world/weather.h"

namespace sim::weather {

// What an hour brings, the same for the whole world: its events together, and where the sun stands in the middle of it.
struct Sky {
    float temperature = 0;    // degrees Celsius, at the calendar's reference
    float precipitation = 0;  // mm/h of water, there
    float cloud = 0;          // share of the sky
    float wind = 0;           // m/s, of the strongest wind; high above the ground
    Direction wind_to{0, 0};  // unit vector along it; none without wind
    Direction sun{0, 0};      // unit vector toward the sun, east and north
    float sun_up = 0;         // its part upward, the sine of the sun's height
    int event = -1;           // number of the storm or wind that was given last; none: -1

    // Direct light reaches the ground.
    bool shines() const { return sun_up > 0.05f && cloud < 0.8f; }
    // W/m² of it, on a surface turned to the sun.
    float beam() const { return 1367 * sun_up / (sun_up + 0.33f) * (1 - 0.75f * cloud); }
    // The ground loses warmth to a clear sky.
    bool is_clear_night() const { return sun_up < 0 && cloud < 0.3f; }
};

// Of the next hour.
Sky sky_of(const Weather& weather);

}  // namespace sim::weather

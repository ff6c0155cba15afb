#pragma once

#include "render/view/look.h"

namespace render {

// Returns where the sun stands, seen from a place on Earth: azimuth 0 to 360 degrees from true north, and the
// apparent elevation, −90 to 90 degrees, raised by refraction at sea level (half a degree at the horizon).
// `latitude_deg`: −90 to 90, north positive. `longitude_deg`: −360 to 360, east positive. `unix_s`: UTC, in
// seconds from 1970-01-01. Within 0.05 degrees from 1900 to 2100 while the sun is up, save for the
// weather's part in refraction. From −6 degrees down the elevation is geometric.
Light sun_position(double latitude_deg, double longitude_deg, double unix_s);

}  // namespace render

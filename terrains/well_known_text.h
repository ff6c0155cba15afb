#pragma once

#include <string>

namespace terrains {

// WKT of WGS 84 in degrees for PlaneTransform: x is the longitude, y the latitude.
const std::string& wgs84_wkt();

// WKT of the transverse Mercator plane through a point: WGS 84, scale 1 at the centre meridian, origin there,
// metres.
std::string local_plane_wkt(double latitude, double longitude);

}  // namespace terrains

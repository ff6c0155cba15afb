#pragma once

#include "terrains/georeference.h"

// The transverse Mercator plane through a point: WGS 84, scale 1 on the point's meridian, metres from the
// point. It is the plane of local_plane_wkt(), computed by GeographicLib.
namespace terrains {

LocalPoint to_local_plane(LatLon centre, LatLon p);

LatLon from_local_plane(LatLon centre, LocalPoint p);

}  // namespace terrains

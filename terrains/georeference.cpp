#include "terrains/georeference.h"

#include <cmath>
#include <string>
#include <utility>

#include "terrains/well_known_text.h"

namespace terrains {
bool on_earth(LatLon p) {
    return std::abs(p.latitude) <= 90 && std::abs(p.longitude) <= 360;  // false for NaN
}

Georeference Georeference::unnamed(double origin_x, double origin_y) {
    Georeference made;
    made.kind_ = Kind::kUnnamed;
    made.origin_x_ = origin_x;
    made.origin_y_ = origin_y;
    return made;
}

Georeference Georeference::projected(std::string wkt, double easting, double northing) {
    Georeference made = unnamed(easting, northing);
    made.kind_ = Kind::kProjected;
    made.wkt_ = std::move(wkt);
    return made;
}

Georeference Georeference::local(LatLon centre, double false_x, double false_y) {
    Georeference made = unnamed(false_x, false_y);
    made.kind_ = Kind::kLocal;
    made.wkt_ = local_plane_wkt(centre.latitude, centre.longitude);
    made.centre_ = centre;
    return made;
}

}  // namespace terrains

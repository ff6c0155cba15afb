#include "terrains/local_plane.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/TransverseMercator.hpp>

namespace terrains {
namespace {

const GeographicLib::TransverseMercator& projection() {
    static const GeographicLib::TransverseMercator made(GeographicLib::Constants::WGS84_a(),
                                                        GeographicLib::Constants::WGS84_f(), 1.0);
    return made;
}

// Measured from the equator, as in GeographicLib.
LocalPoint forward(double meridian, LatLon p) {
    LocalPoint made;
    projection().Forward(meridian, p.latitude, p.longitude, made.x, made.y);
    return made;
}

}  // namespace

LocalPoint to_local_plane(LatLon centre, LatLon p) {
    const LocalPoint made = forward(centre.longitude, p);
    return {made.x, made.y - forward(centre.longitude, centre).y};
}

LatLon from_local_plane(LatLon centre, LocalPoint p) {
    LatLon made;
    projection().Reverse(centre.longitude, p.x, p.y + forward(centre.longitude, centre).y, made.latitude,
                         made.longitude);
    return made;
}

}  // namespace terrains

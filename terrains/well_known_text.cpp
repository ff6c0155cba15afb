#include "terrains/well_known_text.h"

#include <fmt/format.h>

namespace terrains {

const std::string& wgs84_wkt() {
    static const std::string wkt =
        R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],)"
        R"(AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",)"
        R"(0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG","4326"]])";
    return wkt;
}

std::string local_plane_wkt(double latitude, double longitude) {
    return fmt::format(
        R"(PROJCS["Local transverse Mercator",{},PROJECTION["Transverse_Mercator"],)"
        R"(PARAMETER["latitude_of_origin",{}],PARAMETER["central_meridian",{}],PARAMETER["scale_factor",1],)"
        R"(PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1,AUTHORITY["EPSG","9001"]],)"
        R"(AXIS["Easting",EAST],AXIS["Northing",NORTH]])",
        wgs84_wkt(), latitude, longitude);
}

}  // namespace terrains

#include "terrains/raster_door.h"

// raster_door.cpp finds this symbol by name.
extern "C" {
[[gnu::visibility("default")]] extern const terrains::RasterDoor couloir_rasters;
const terrains::RasterDoor couloir_rasters{terrains::read_dem,
                                           terrains::set_system,
                                           terrains::read_depth_raster,
                                           terrains::read_signed_raster,
                                           terrains::encode_geotiff,
                                           terrains::esri_wkt,
                                           terrains::PlaneTransform::between,
                                           &terrains::PlaneTransform::apply,
                                           terrains::PlaneTransform::destroy};
}

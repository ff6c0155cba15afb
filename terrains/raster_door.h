#pragma once

#include "terrains/dem_gdal.h"
#include "terrains/depth_raster.h"
#include "terrains/geotiff.h"
#include "terrains/plane_transform.h"

namespace terrains {

// The functions that need GDAL. GDAL depends on over a hundred libraries, so a separate module links it and
// is loaded when one of these is first called. Each function exists twice: the real one in the module
// (raster_module.cpp), and one that forwards to it (raster_door.cpp) for all other code. The signatures
// contain no GDAL types.
struct RasterDoor {
    decltype(&terrains::read_dem) read_dem;
    decltype(&terrains::set_system) set_system;
    decltype(&terrains::read_depth_raster) read_depth_raster;
    decltype(&terrains::read_signed_raster) read_signed_raster;
    decltype(&terrains::encode_geotiff) encode_geotiff;
    decltype(&terrains::esri_wkt) esri_wkt;
    decltype(&PlaneTransform::between) between;
    decltype(&PlaneTransform::apply) apply;
    decltype(&PlaneTransform::destroy) destroy;
};

}  // namespace terrains

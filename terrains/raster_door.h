#pragma once

#include "terrains/dem_gdal.h"
#include "terrains/depth_raster.h"
#include "terrains/geotiff.h"
#include "terrains/plane_transform.h"

namespace terrains {

// What needs GDAL. GDAL comes with over a hundred libraries, so it is linked to a module of its own that is
// loaded when one of these is first called. The program has each of these functions twice: the real one in
// the module (raster_module.cpp), and one that calls it (raster_door.cpp) for everybody else. Nothing of GDAL
// is in the signatures.
struct RasterDoor {
    decltype(&terrains::read_dem) read_dem;
    decltype(&terrains::read_depth_raster) read_depth_raster;
    decltype(&terrains::read_signed_raster) read_signed_raster;
    decltype(&terrains::encode_geotiff) encode_geotiff;
    decltype(&terrains::esri_wkt) esri_wkt;
    decltype(&PlaneTransform::between) between;
    decltype(&PlaneTransform::apply) apply;
    decltype(&PlaneTransform::destroy) destroy;
};

}  // namespace terrains

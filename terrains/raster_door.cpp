#include "terrains/raster_door.h"

#include "files/module.h"

namespace terrains {
namespace {

const RasterDoor& door() {
    static const auto* opened =
        static_cast<const RasterDoor*>(files::symbol_of_module("libcouloir_rasters.so", "couloir_rasters"));
    return *opened;
}

}  // namespace

tl::expected<Terrain, std::string> read_dem(const std::filesystem::path& path, const GridChoice& choice,
                                            References references, Quantity quantity) {
    return door().read_dem(path, choice, references, quantity);
}

tl::expected<void, std::string> set_system(const std::string& system, Terrain& terrain) {
    return door().set_system(system, terrain);
}

tl::expected<DepthRaster, std::string> read_depth_raster(const std::filesystem::path& path,
                                                         const Terrain& terrain, References references) {
    return door().read_depth_raster(path, terrain, references);
}

tl::expected<DepthRaster, std::string> read_signed_raster(const std::filesystem::path& path,
                                                          const Terrain& terrain, References references) {
    return door().read_signed_raster(path, terrain, references);
}

tl::expected<std::string, std::string> encode_geotiff(const sim::Grid& grid, const Georeference& place,
                                                      std::span<const float> rows) {
    return door().encode_geotiff(grid, place, rows);
}

std::string esri_wkt(const std::string& wkt) {
    return door().esri_wkt(wkt);
}

tl::expected<PlaneTransform, std::string> PlaneTransform::between(const std::string& from_wkt,
                                                                  const std::string& to_wkt) {
    return door().between(from_wkt, to_wkt);
}

bool PlaneTransform::apply(std::span<double> x, std::span<double> y) const {
    return (this->*door().apply)(x, y);
}

void PlaneTransform::destroy(void* transform) {
    door().destroy(transform);
}

}  // namespace terrains

#include "terrains/gdal_support.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>

#include <cpl_error.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>
#include <proj.h>

#include "files/input.h"

namespace terrains {
namespace {

void CPL_STDCALL keep_first_failure(CPLErr severity, CPLErrorNum, const char* message) {
    auto* first = static_cast<std::string*>(CPLGetErrorHandlerUserData());
    if (severity < CE_Failure || !first->empty()) return;
    *first = message;
    std::replace(first->begin(), first->end(), '\n', ' ');
}

// Elevation formats that refer to no other files or servers. Nothing else is registered, so a raster opened
// for another one (an overview, a mask, a tile) is also one of these. Drivers are registered one by one,
// because GDALAllRegister() would load plugins that the environment names.
struct Format {
    const char* driver;
    void (*register_it)();
};
constexpr std::array kFormats{
    Format{"GTiff", GDALRegister_GTiff},
    Format{"COG", GDALRegister_COG},
    Format{"AAIGrid", GDALRegister_AAIGrid},
    Format{"GRASSASCIIGrid", GDALRegister_GRASSASCIIGrid},
    Format{"AIG", GDALRegister_AIGrid},
    Format{"EHdr", GDALRegister_EHdr},
    Format{"ENVI", GDALRegister_ENVI},
    Format{"SRTMHGT", GDALRegister_SRTMHGT},
    Format{"HFA", GDALRegister_HFA},
    Format{"DTED", GDALRegister_DTED},
    Format{"USGSDEM", GDALRegister_USGSDEM},
    Format{"XYZ", GDALRegister_XYZ},
    Format{"SAGA", GDALRegister_SAGA},
    Format{"GSAG", GDALRegister_GSAG},
    Format{"GSBG", GDALRegister_GSBG},
    Format{"GS7BG", GDALRegister_GS7BG},
    Format{"JP2OpenJPEG", GDALRegister_JP2OpenJPEG},
    Format{"GPKG", RegisterOGRGeoPackage},
    Format{"PNG", GDALRegister_PNG},  // for the tiles of a GeoPackage
    Format{"JPEG", GDALRegister_JPEG},
};

bool prepare_gdal() {
    // What no GdalErrors keeps is not printed: libtiff reports to GDAL from then on, even what other code reads by it.
    CPLSetErrorHandler(CPLQuietErrorHandler);
    for (const Format& format : kFormats) format.register_it();
    OSRSetPROJEnableNetwork(0);
    // libgeotiff also calls PROJ and lets it print failed look-ups. Its contexts are copies of this one.
    proj_log_level(PJ_DEFAULT_CTX, PJ_LOG_NONE);
    return close_file_system_to_gdal();
}

bool is_prepared() {
    static const bool prepared = prepare_gdal();
    return prepared;
}

// Why a file that GDAL rejects may refer elsewhere; empty if it does not.
std::string reference_in(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string beginning(1024, '\0');
    file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    if (beginning.find("<VRTDataset") != std::string::npos)
        return "is a virtual raster, which reads other files; add --allow-references if you trust it";
    for (const char* service : {"<GDAL_WMS", "<WCS_GDAL", "<GDAL_WMTS"})
        if (beginning.find(service) != std::string::npos)
            return "refers to a server, and the network is never read; download the raster and open the copy";
    return {};
}

// PROJ opens correction grids by the names in the WKT. A path among them comes from the file's author, not
// the user.
bool names_a_path(const std::string& wkt) {
    static const std::regex path_of_grid(R"((grids|parameterfile|catalog)[^\]]*/)", std::regex::icase);
    return std::regex_search(wkt, path_of_grid);
}

// GDAL opens the sources of a virtual raster only when it reads their pixels, which may be never.
void note_named_files(GDALDatasetH dataset) {
    char** names = GDALGetFileList(dataset);
    for (char** name = names; name != nullptr && *name != nullptr; ++name) note_read(*name);
    CSLDestroy(names);
}

}  // namespace

GdalErrors::GdalErrors() {
    CPLPushErrorHandlerEx(keep_first_failure, &first_);
    is_prepared();
}

GdalErrors::~GdalErrors() {
    CPLPopErrorHandler();
}

std::string GdalErrors::first() const {
    return first_.empty() ? "no reason given" : first_;
}

VirtualRasters::VirtualRasters(References references) {
    if (references != References::kAllowed || GDALGetDriverByName("VRT") != nullptr) return;
    GDALRegister_VRT();
    registered_ = true;
}

VirtualRasters::~VirtualRasters() {
    if (!registered_) return;
    GDALDriverH driver = GDALGetDriverByName("VRT");
    GDALDeregisterDriver(driver);
    GDALDestroyDriver(driver);
}

tl::expected<Raster, std::string> Raster::open(const std::filesystem::path& path, References references) {
    const GdalErrors errors;
    const auto bad = [&path](const std::string& fact) {
        return tl::unexpected(fmt::format("{}: {}", path.string(), fact));
    };
    if (!is_prepared())
        return bad("not opened, because this version of GDAL cannot be restricted to one file");
    std::error_code error;
    const bool is_binary_grid =
        std::filesystem::is_regular_file(path / "hdr.adf", error);  // the folder names the grid
    if (auto is_file = files::check_input(path); !is_file && !is_binary_grid)
        return tl::unexpected(is_file.error());
    Raster raster;
    raster.files_ = std::make_unique<RasterFiles>(path, references);
    raster.virtual_rasters_ = std::make_unique<VirtualRasters>(references);
    // Use an absolute path, so that GDAL does not read the name as one of its special ones.
    raster.path_ = std::filesystem::absolute(path, error);
    raster.dataset_.reset(GDALOpenEx(raster.path_.c_str(),
                                     GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr,
                                     nullptr, nullptr));
    if (raster.get() != nullptr && GDALGetRasterCount(raster.get()) >= 1) {
        note_named_files(raster.get());
        return raster;
    }
    if (const std::string reference = reference_in(path); !reference.empty()) return bad(reference);
    return bad(fmt::format("not a readable raster ({})", errors.first()));
}

void DestroyReference::operator()(void* handle) const {
    OSRDestroySpatialReference(handle);
}

SpatialReference SpatialReference::from_wkt(const std::string& wkt) {
    if (names_a_path(wkt)) return SpatialReference(nullptr);
    SpatialReference made(OSRNewSpatialReference(nullptr));
    std::string text = wkt;
    char* rest = text.data();
    if (OSRImportFromWkt(made.get(), &rest) != OGRERR_NONE) return SpatialReference(nullptr);
    if (made.has_code_of_another_kind()) return SpatialReference(nullptr);
    OSRSetAxisMappingStrategy(made.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return made;
}

// PROJ looks such a code up, takes what it finds for what is described, and reads at address 0.
bool SpatialReference::has_code_of_another_kind() const {
    const auto is_word = [](std::string_view text) {
        return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
    };
    // The system itself, and the geographic one that a projected one has inside.
    for (const char* part : {static_cast<const char*>(nullptr), "GEOGCS"}) {
        const char* const authority = OSRGetAuthorityName(get(), part);
        const char* const code = OSRGetAuthorityCode(get(), part);
        if (authority == nullptr || code == nullptr) continue;
        const std::string name = fmt::format("{}:{}", authority, code);
        const SpatialReference known(OSRNewSpatialReference(nullptr));
        const bool named = is_word(authority) && is_word(code) &&
                           OSRSetFromUserInput(known.get(), name.c_str()) == OGRERR_NONE;
        if (!named) continue;  // nor does PROJ find it
        const bool fits = part != nullptr ? OSRIsGeographic(known.get()) != 0
                                          : OSRIsGeographic(known.get()) == OSRIsGeographic(get()) &&
                                                OSRIsProjected(known.get()) == OSRIsProjected(get());
        if (fits) continue;
        CPLError(CE_Failure, CPLE_AppDefined, "%s is the code of another kind of system", name.c_str());
        return true;
    }
    return false;
}

}  // namespace terrains

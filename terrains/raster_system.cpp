#include "terrains/raster_system.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <ogr_srs_api.h>

#include "terrains/lower_case.h"

namespace terrains {
namespace {

OwnedReference new_system() {
    return OwnedReference(OSRNewSpatialReference(nullptr));
}

std::string to_wkt(OGRSpatialReferenceH system) {
    char* text = nullptr;
    std::string wkt;
    if (OSRExportToWkt(system, &text) == OGRERR_NONE && text != nullptr) wkt = text;
    CPLFree(text);
    return wkt;
}

// Takes its vertical part off.
RasterSystem described(OGRSpatialReferenceH system) {
    RasterSystem result;
    if (OSRIsCompound(system) != 0) {
        result.metres_per_height = OSRGetTargetLinearUnits(system, "VERT_CS", nullptr);
        result.counts_down =
            to_wkt(system).find(",DOWN]") != std::string::npos;  // an axis; OSRGetAxis finds none
        OSRStripVertical(system);
    }
    result.geographic = OSRIsGeographic(system) != 0;
    result.projected = OSRIsProjected(system) != 0;
    result.metres_per_unit = OSRGetLinearUnits(system, nullptr);
    if (result.geographic || result.projected) result.wkt = to_wkt(system);
    return result;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";  // a byte order mark
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    constexpr std::string_view kBlank(" \t\r\n\0", 5);
    const auto first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// "EPSG:n", "EPSG:n+m" or "n" of a text in any case; empty if it is none of these.
std::string code_in(std::string_view text) {
    constexpr std::string_view kPrefix = "EPSG:";
    std::string code(kPrefix);
    if (text.size() > kPrefix.size() && lower_case(text.substr(0, kPrefix.size())) == "epsg:")
        text.remove_prefix(kPrefix.size());
    constexpr std::size_t kMostDigits = 6;
    std::size_t digits = 0, parts = 1;
    for (const char c : text) {
        const bool next_part = c == '+' && parts == 1 && digits > 0;
        if (!next_part && (c < '0' || c > '9')) return {};
        digits = next_part ? 0 : digits + 1;
        parts += next_part ? 1 : 0;
        if (digits > kMostDigits) return {};
        code += c;
    }
    return digits > 0 ? code : std::string();
}

// What a .prj of ESRI may be besides WKT: lines of "Projection UTM", "Zone 32".
std::optional<RasterSystem> read_lines(const std::string& text) {
    char** lines = CSLTokenizeString2(text.c_str(), "\r\n", CSLT_STRIPLEADSPACES | CSLT_STRIPENDSPACES);
    const OwnedReference system = new_system();
    const bool read = CSLCount(lines) > 0 && std::string_view(lines[0]).starts_with("Projection") &&
                      OSRImportFromESRI(system.get(), lines) == OGRERR_NONE;
    CSLDestroy(lines);
    if (!read) return std::nullopt;
    return described(system.get());
}

// The text of the .prj beside a raster; none if there is none, or one too long to be a system.
std::optional<std::string> prj_text(const std::filesystem::path& prj) {
    constexpr std::size_t kLongest = 65'536;
    VSILFILE* file = VSIFOpenL(prj.c_str(), "rb");  // which knows what may be read
    if (file == nullptr) return std::nullopt;
    std::string text(kLongest, '\0');
    text.resize(VSIFReadL(text.data(), 1, text.size(), file));
    VSIFCloseL(file);
    return text;
}

// Whether a .prj is the customary place of a format's system. Beside a GeoTIFF it is a shapefile's.
bool has_prj(GDALDatasetH dataset) {
    const std::string_view format = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
    static constexpr std::array<std::string_view, 10> kFormats{
        "AAIGrid", "GRASSASCIIGrid", "XYZ", "GSAG", "GSBG", "GS7BG", "EHdr", "SAGA", "PNG", "JPEG"};
    return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end();
}

tl::expected<RasterSystem, std::string> system_beside(const std::filesystem::path& raster) {
    for (const char* ending : {".prj", ".PRJ", ".Prj"}) {
        const auto prj = std::filesystem::path(raster).replace_extension(ending);
        const auto text = prj_text(prj);
        if (!text) continue;
        const std::string bare(trimmed(*text));
        if (bare.empty()) continue;
        auto system = read_system(bare);
        if (!system) system = read_lines(bare);
        if (system && !system->wkt.empty()) return *system;
        return tl::unexpected(fmt::format(
            "{} beside it cannot be read as a coordinate system; replace it by WKT or by a code such as "
            "EPSG:32632",
            prj.filename().string()));
    }
    return RasterSystem();
}

}  // namespace

std::optional<RasterSystem> read_system(const std::string& text) {
    const GdalErrors errors;
    const std::string bare(trimmed(text));
    const OwnedReference by_code = new_system();
    if (const std::string code = code_in(bare); !code.empty()) {
        if (OSRSetFromUserInput(by_code.get(), code.c_str()) != OGRERR_NONE) return std::nullopt;
        return described(by_code.get());
    }
    const auto by_wkt = SpatialReference::from_wkt(bare);
    if (!by_wkt) return std::nullopt;
    return described(by_wkt.get());
}

tl::expected<RasterSystem, std::string> system_of(const Raster& raster) {
    OGRSpatialReferenceH declared = GDALGetSpatialRef(raster.get());
    if (declared == nullptr) return has_prj(raster.get()) ? system_beside(raster.path()) : RasterSystem();
    const OwnedReference own(OSRClone(declared));
    return described(own.get());
}

}  // namespace terrains

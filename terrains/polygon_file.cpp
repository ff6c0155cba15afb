#include "terrains/polygon_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "files/input.h"

namespace terrains {
namespace {

// The format of a file with this beginning; null if it is none with polygons.
const char* format_of(std::string_view beginning, const std::filesystem::path& path) {
    using namespace std::string_view_literals;
    struct Signature {
        std::string_view bytes;
        const char* format;
    };
    constexpr std::array kSignatures{
        Signature{"\0\0\x27\x0a"sv, "a shapefile"},
        Signature{"SQLite format 3"sv, "a GeoPackage"},
        Signature{"fgb\x03"sv, "a FlatGeobuf"},
        Signature{"PK\x03\x04"sv, "an archive"},
    };
    for (const Signature& signature : kSignatures)
        if (beginning.starts_with(signature.bytes)) return signature.format;
    if (beginning.find("<kml") != std::string_view::npos) return "a KML file";
    if (beginning.find("opengis.net/gml") != std::string_view::npos) return "a GML file";
    // A table of a shapefile has no bytes of its own.
    return path.extension() == ".dbf" || path.extension() == ".DBF" ? "a part of a shapefile" : nullptr;
}

}  // namespace

std::optional<std::string> advice_on_polygons(const std::filesystem::path& path) {
    auto file = files::open_input(path);
    if (!file) return std::nullopt;
    std::string beginning(4096, ' ');
    file->read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    const char* format = format_of(beginning, path);
    if (format == nullptr) return std::nullopt;
    std::filesystem::path source = path;
    if (std::string_view(format).ends_with("shapefile")) source.replace_extension(".shp");
    const bool archive = beginning.starts_with("PK");
    return fmt::format(
        "{}: {} is not read, but GeoJSON is; make one by: ogr2ogr -f GeoJSON -t_srs EPSG:4326 {} {}{}",
        path.string(), format, std::filesystem::path(path).replace_extension(".geojson").string(),
        archive ? "/vsizip/" : "", source.string());
}

}  // namespace terrains

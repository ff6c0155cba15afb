// The limits of an untrusted file: it reaches itself, its own sidecars, and nothing else.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include "terrains/dem_gdal.h"
#include "terrains/gdal_support.h"
#include "terrains/grey_picture.h"
#include "terrains/plane_transform.h"
#include "terrains/release.h"
#include "terrains/well_known_text.h"
#include "tests/support/places.h"
#include "tests/terrains/files.h"
#include "tests/terrains/memory_files.h"

namespace terrains {
namespace {

namespace fs = std::filesystem;

// A server on the loopback that accepts connections and never answers.
class SilentServer {
  public:
    SilentServer() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
        address_.sin_family = AF_INET;
        address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address_;
        const bool listens = bind(socket_, reinterpret_cast<sockaddr*>(&address_), size) == 0 &&
                             listen(socket_, 16) == 0 &&
                             getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size) == 0;
        EXPECT_TRUE(listens);
    }
    ~SilentServer() { close(socket_); }
    SilentServer(const SilentServer&) = delete;
    SilentServer& operator=(const SilentServer&) = delete;

    std::string url() const { return fmt::format("http://127.0.0.1:{}/hill.tif", ntohs(address_.sin_port)); }

    int requests() {
        int count = 0;
        for (int peer; (peer = accept(socket_, nullptr, nullptr)) >= 0; close(peer)) ++count;
        return count;
    }

  private:
    int socket_;
    sockaddr_in address_{};
};

std::string virtual_raster(const std::string& source, const char* relative = "0") {
    return fmt::format(
        "<VRTDataset rasterXSize=\"21\" rasterYSize=\"17\"><GeoTransform>-5,10,0,165,0,-10</GeoTransform>"
        "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"{}\">{}"
        "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>",
        relative, source);
}

// Whether any raster reader accepts the file.
bool is_read(const fs::path& path, References references) {
    static const support::TemporaryFolder folder;
    static const Terrain ground =
        read_dem(test::write_ascii_grid(folder.path(), "ground", {}, [](double, double) { return 500.0; }),
                 16)
            .value();
    return read_dem(path, 16, references) || read_release(path, ground, {}, references) ||
           read_reference(path, ground, references) || read_grey_picture(path);
}

TEST(Strangers, contact_no_server_with_any_permission) {
    const support::TemporaryFolder folder;
    SilentServer server;
    const std::string url = server.url();
    const std::vector<std::string> texts{
        virtual_raster("/vsicurl/" + url),
        virtual_raster("/vsicurl?url=" + url),
        virtual_raster("/vsicurl_streaming/" + url),
        virtual_raster("/vsigzip//vsicurl/" + url),
        virtual_raster("/vsizip//vsicurl/" + url),
        virtual_raster("/vsisubfile/0_9,/vsicurl/" + url),
        virtual_raster("/vsicached?file=/vsicurl/" + url),
        virtual_raster(url),
        virtual_raster("/vsis3/bucket/hill.tif"),
        virtual_raster("WCS:" + url),
        fmt::format("<GDAL_WMS><Service name=\"TMS\"><ServerUrl>{}</ServerUrl></Service><DataWindow>"
                    "<UpperLeftX>0</UpperLeftX><UpperLeftY>9</UpperLeftY><LowerRightX>9</LowerRightX>"
                    "<LowerRightY>0</LowerRightY><SizeX>9</SizeX><SizeY>9</SizeY></DataWindow></GDAL_WMS>",
                    url),
        fmt::format("<WCS_GDAL><ServiceURL>{}?</ServiceURL><CoverageName>hill</CoverageName></WCS_GDAL>",
                    url),
        fmt::format("<GDAL_WMTS><GetCapabilitiesUrl>{}</GetCapabilitiesUrl></GDAL_WMTS>", url),
        fmt::format("#EXTM3U\n#EXT-X-TARGETDURATION:10\n#EXTINF:10,\n{}\n", url),
        "v=0\no=- 0 0 IN IP4 127.0.0.1\ns=x\nc=IN IP4 127.0.0.1\nt=0 0\nm=video 5004 RTP/AVP 96\n",
    };
    const auto began = std::chrono::steady_clock::now();
    for (const std::string& text : texts)
        for (const char* name : {"hill.tif", "hill.vrt", "hill.xml"})
            for (const References references : {References::kRefused, References::kAllowed}) {
                test::write_text(folder.path() / name, text);
                EXPECT_FALSE(is_read(folder.path() / name, references)) << text;
                EXPECT_EQ(server.requests(), 0) << text;
            }
    // Waiting for one answer takes at least 30 s.
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(30));
}

// The system of a recording comes from its header.
TEST(Strangers, may_not_put_an_address_or_path_in_a_coordinate_system) {
    const support::TemporaryFolder folder;
    SilentServer server;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto utm = folder.path() / "utm.prj";
    test::write_text(utm, test::utm_32n());
    const std::string grid = fmt::format(
        R"(GEOGCS["shifted",DATUM["D",SPHEROID["S",6378137,298.257223563],EXTENSION["PROJ4_GRIDS","{}"]],)"
        R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])",
        pipe.string());
    for (const std::string& wkt : {server.url(), "urn:" + server.url(), utm.string(),
                                   "/vsicurl/" + server.url(), pipe.string(), grid}) {
        EXPECT_FALSE(PlaneTransform::between(wkt, wgs84_wkt())) << wkt;
        EXPECT_EQ(server.requests(), 0) << wkt;
    }
    EXPECT_TRUE(PlaneTransform::between(test::utm_32n(), wgs84_wkt()));
}

// PROJ reads at address 0 if it finds another kind of system by a code than is described beside it.
TEST(Strangers, may_not_give_a_coordinate_system_the_code_of_another_kind) {
    const auto geographic = [](const std::string& code) {
        return R"(GEOGCS["D",DATUM["D",SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],)"
               R"(UNIT["degree",0.0174532925199433],AUTHORITY["EPSG",")" +
               code + R"("]])";
    };
    const auto projected = [&](const std::string& base, const std::string& code) {
        return R"(PROJCS["P",)" + geographic(base) +
               R"(,PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],)"
               R"(PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],)"
               R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],)"
               R"(AUTHORITY["EPSG",")" +
               code + R"("]])";
    };
    // 4258 geographic, 4342 and 4978 geocentric, 25832 projected, 5773 vertical, 7423 compound, 999999 none
    EXPECT_TRUE(PlaneTransform::between(geographic("4258"), wgs84_wkt()));
    EXPECT_TRUE(PlaneTransform::between(geographic("999999"), wgs84_wkt()));
    EXPECT_TRUE(PlaneTransform::between(projected("4258", "25832"), wgs84_wkt()));
    for (const char* code : {"4342", "4978", "25832", "5773"}) {
        EXPECT_FALSE(PlaneTransform::between(geographic(code), wgs84_wkt())) << code;
        EXPECT_FALSE(PlaneTransform::between(projected(code, "25832"), wgs84_wkt())) << code;
    }
    for (const char* code : {"4258", "4342", "4978", "5773"}) {
        const auto refused = PlaneTransform::between(projected("4258", code), wgs84_wkt());
        ASSERT_FALSE(refused) << code;
        EXPECT_NE(refused.error().find("another kind of system"), std::string::npos) << refused.error();
    }
}

TEST(Strangers, refer_to_other_files_only_if_allowed) {
    const support::TemporaryFolder folder, elsewhere;
    const auto source =
        test::write_ascii_grid(elsewhere.path(), "hill", {}, [](double x, double) { return 900 + x; });
    const auto path = folder.path() / "hill.tif";
    test::write_text(path, virtual_raster(source.string()));
    EXPECT_FALSE(read_dem(path, 16));
    EXPECT_TRUE(read_dem(path, 16, References::kAllowed));
    EXPECT_FALSE(read_dem(path, 16));  // and not for the one after it
}

TEST(Strangers, are_not_raw_bytes_of_any_file) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "hill.vrt";
    test::write_text(
        path,
        "<VRTDataset rasterXSize=\"20\" rasterYSize=\"20\"><GeoTransform>0,1,0,0,0,-1</GeoTransform>"
        "<VRTRasterBand dataType=\"Byte\" band=\"1\" subClass=\"VRTRawRasterBand\"><SourceFilename>"
        "/etc/passwd</SourceFilename></VRTRasterBand></VRTDataset>");
    EXPECT_FALSE(is_read(path, References::kRefused));
}

TEST(Strangers, reach_their_sidecars_and_no_other_file) {
    const support::TemporaryFolder folder, elsewhere;
    const auto hill = folder.path() / "hill.tif", link = elsewhere.path() / "linked.tif";
    for (const char* name : {"hill.tif", "hill.prj", "HILL.TFW", "hill.tif.aux.xml", "hill.hdr", "hills.tif",
                             "other.prj", "hdr.adf"})
        test::write_text(folder.path() / name, name);
    test::write_text(elsewhere.path() / "secret.tif", "secret");
    fs::create_symlink(elsewhere.path() / "secret.tif", folder.path() / "hill.msk");
    fs::create_symlink("other.prj", folder.path() / "hill.qpj");
    fs::create_symlink(hill, link);
    fs::create_symlink(folder.path() / "hill.prj", elsewhere.path() / "linked.prj");

    const RasterFiles files(hill, References::kRefused), linked(link, References::kRefused),
        everything(hill, References::kAllowed);
    for (const char* own :
         {"hill.tif", "hill.prj", "HILL.TFW", "hill.tif.aux.xml", "hill.hdr", "hill.qpj", "../"})
        EXPECT_EQ(files.includes(folder.path() / own), std::string(own) != "../") << own;
    for (const char* other : {"hills.tif", "other.prj", "hdr.adf", "hill.msk", "none.tif", "hill.none", ""})
        EXPECT_FALSE(files.includes(folder.path() / other)) << other;
    EXPECT_FALSE(files.includes(folder.path() / ".." / elsewhere.path().filename() / "secret.tif"));
    EXPECT_FALSE(files.includes("/etc/passwd"));
    EXPECT_TRUE(files.includes(folder.path() / ".." / folder.path().filename() / "hill.prj"));
    EXPECT_TRUE(linked.includes(link));
    EXPECT_TRUE(linked.includes(elsewhere.path() / "linked.prj"));
    EXPECT_FALSE(linked.includes(elsewhere.path() / "secret.tif"));
    EXPECT_TRUE(everything.includes("/etc/passwd"));
}

// GDAL itself obeys these rules, for overviews that a file names and for files that it writes.
TEST(Strangers, are_opened_by_gdal_through_these_rules) {
    const support::TemporaryFolder folder;
    const auto hill = test::write_ascii_grid(folder.path(), "hill", {}, [](double, double) { return 500.0; });
    test::write_ascii_grid(folder.path(), "other", {}, [](double, double) { return 700.0; });
    test::write_text(
        folder.path() / "hill.asc.aux.xml",
        fmt::format("<PAMDataset><Metadata domain=\"OVERVIEWS\"><MDI key=\"OVERVIEW_FILE\">{}</MDI>"
                    "</Metadata></PAMDataset>",
                    (folder.path() / "other.asc").string()));
    const auto raster = Raster::open(hill, References::kRefused);
    ASSERT_TRUE(raster) << raster.error();
    GDALRasterBandH band = GDALGetRasterBand(raster->get(), 1);
    EXPECT_EQ(GDALGetOverviewCount(band), 0);
    EXPECT_EQ(VSIFOpenL((folder.path() / "other.asc").c_str(), "rb"), nullptr);
    EXPECT_EQ(VSIFOpenL(hill.c_str(), "r+b"), nullptr);
    EXPECT_EQ(VSIFOpenL((folder.path() / "new.tif").c_str(), "wb"), nullptr);
    EXPECT_EQ(VSIFOpenL("/vsistdin/", "rb"), nullptr);
}

TEST(Strangers, do_not_block_on_a_pipe_or_a_device) {
    const support::TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe.tif";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const fs::path& path : {pipe, fs::path("/dev/zero"), folder.path()})
        for (const References references : {References::kRefused, References::kAllowed})
            EXPECT_FALSE(is_read(path, references)) << path;

    const auto hill = test::write_ascii_grid(folder.path(), "hill", {}, [](double, double) { return 500.0; });
    for (const char* sidecar : {"hill.prj", "hill.asc.aux.xml", "hill.asc.msk", "hill.asc.ovr"})
        ASSERT_EQ(mkfifo((folder.path() / sidecar).c_str(), 0600), 0);
    EXPECT_TRUE(read_dem(hill, 16));
}

struct Format {
    const char *driver, *name;
    GDALDataType type = GDT_Float32;
};

// A plane of 40 by 30 pixels, 10 m each.
Dataset plane_in_memory(GDALDataType type, const char* name = "/vsimem/source.tif", int columns = 40,
                        int rows = 30) {
    Dataset made(GDALCreate(GDALGetDriverByName("GTiff"), name, columns, rows, 1, type, nullptr));
    double pixels[6] = {683'000, 10, 0, 5'240'000, 0, -10};
    GDALSetGeoTransform(made.get(), pixels);
    const SpatialReference system = SpatialReference::from_wkt(test::utm_32n());
    GDALSetSpatialRef(made.get(), system.get());
    std::vector<double> row(static_cast<std::size_t>(columns));
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) row[static_cast<std::size_t>(x)] = 100 + 2 * x + y;
        EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(made.get(), 1), GF_Write, 0, y, columns, 1, row.data(),
                               columns, 1, GDT_Float64, 0, 0),
                  CE_None);
    }
    return made;
}

TEST(Formats, of_elevation_are_read_with_all_their_files) {
    for (const Format& format : {
             Format{"GTiff", "hill.tif"},
             Format{"COG", "hill.tif"},
             Format{"AAIGrid", "hill.asc"},
             Format{"EHdr", "hill.bil"},
             Format{"ENVI", "hill.img"},
             Format{"HFA", "hill.img"},
             Format{"SAGA", "hill.sdat"},
             Format{"GSAG", "hill.grd"},
             Format{"GSBG", "hill.grd"},
             Format{"GS7BG", "hill.grd"},
             Format{"XYZ", "hill.xyz"},
             Format{"JP2OpenJPEG", "hill.jp2", GDT_UInt16},
             Format{"GPKG", "hill.gpkg", GDT_Int16},
             Format{"USGSDEM", "hill.dem", GDT_Int16},
         }) {
        const support::TemporaryFolder folder;
        const GdalErrors errors;
        GDALDriverH driver = GDALGetDriverByName(format.driver);
        ASSERT_NE(driver, nullptr) << format.driver;
        VSIMkdir("/vsimem/made", 0700);
        {
            const Dataset source = plane_in_memory(format.type);
            const Dataset made(GDALCreateCopy(driver, (std::string("/vsimem/made/") + format.name).c_str(),
                                              source.get(), FALSE, nullptr, nullptr, nullptr));
            ASSERT_NE(made, nullptr) << format.driver << ": " << errors.first();
        }
        VSIUnlink("/vsimem/source.tif");
        EXPECT_FALSE(test::unload("/vsimem/made", folder.path()).empty());
        const auto terrain = read_dem(folder.path() / format.name, 16);
        ASSERT_TRUE(terrain) << format.driver << ": " << terrain.error();
        EXPECT_NEAR(terrain->surface.front(), 100 + 29, 30) << format.driver;
    }
}

TEST(Formats, that_hold_no_elevation_or_lead_elsewhere_are_not_registered) {
    const GdalErrors errors;
    for (const char* driver :
         {"VRT", "WMS", "WCS", "WMTS", "HTTP", "netCDF", "HDF5", "MRF", "ERS", "PDF", "MEM", "DERIVED",
          "STACIT", "PLMOSAIC", "EEDAI", "GRIB", "OGR_VRT", "KML", "PostGISRaster"})
        EXPECT_EQ(GDALGetDriverByName(driver), nullptr) << driver;
}

// More than 32 pixels along a cell.
TEST(Blocks, reproduce_a_plane_exactly_with_and_without_voids) {
    const support::TemporaryFolder folder;
    const auto truth = [](double x, double y) { return 1500 + 0.5 * x - 0.25 * y; };
    for (const bool voids : {false, true})
        for (const int columns : {420, 421, 435}) {
            test::AsciiGrid grid{.columns = columns, .rows = 311, .west = 3, .south = 7, .cell = 2};
            if (voids)
                grid.is_void = [](int column, int row) {
                    return column % 7 == row % 5 || std::hypot(column - 200, row - 150) < 80;
                };
            const auto path = test::write_ascii_grid(folder.path(), "hill", grid, truth);
            const auto terrain = read_dem(path, 8);
            ASSERT_TRUE(terrain) << terrain.error();
            int known = 0;
            for (int y = 0; y < terrain->grid.ny; ++y)
                for (int x = 0; x < terrain->grid.nx; ++x) {
                    const auto at = static_cast<std::size_t>(y) * terrain->grid.nx + x;
                    if (terrain->has_data[at] == 0) continue;
                    ++known;
                    ASSERT_NEAR(terrain->surface[at],
                                truth(3 + x * static_cast<double>(terrain->grid.dx),
                                      7 + y * static_cast<double>(terrain->grid.dx)),
                                1e-3);
                }
            EXPECT_GT(known, static_cast<int>(terrain->grid.size()) / (voids ? 2 : 1) - 1);
        }
}

TEST(Blocks, have_positions_matching_their_pixels_in_degrees) {
    const support::TemporaryFolder folder;
    const test::AsciiGrid grid{
        .columns = 400, .rows = 300, .west = 11.42, .south = 47.29, .cell = 0.00001, .prj = test::degrees()};
    const auto truth = Georeference::local({47.2915, 11.422}, 0, 0);
    const auto path =
        test::write_ascii_grid(folder.path(), "hill", grid, [&](double longitude, double latitude) {
            const auto p = truth.to_local({latitude, longitude}).value();
            return 1500 + 0.5 * p.x - 0.25 * p.y;
        });
    const auto terrain = read_dem(path, 8);
    ASSERT_TRUE(terrain) << terrain.error();
    for (int y = 0; y < terrain->grid.ny; ++y)
        for (int x = 0; x < terrain->grid.nx; ++x) {
            const LocalPoint p{x * static_cast<double>(terrain->grid.dx),
                               y * static_cast<double>(terrain->grid.dx)};
            const auto there = truth.to_local(terrain->georeference.to_lat_lon(p).value()).value();
            ASSERT_NEAR(terrain->surface[static_cast<std::size_t>(y) * terrain->grid.nx + x],
                        1500 + 0.5 * there.x - 0.25 * there.y, 2e-3);
        }
}

TEST(Blocks, that_would_take_too_much_memory_are_refused_before_a_pixel_is_read) {
    const support::TemporaryFolder folder;
    const auto path = folder.path() / "strip.tif";
    {
        const GdalErrors errors;
        CPLStringList options;
        options.SetNameValue("COMPRESS", "DEFLATE");
        options.SetNameValue("SPARSE_OK", "TRUE");
        options.SetNameValue("BLOCKYSIZE", "20000");
        const Dataset made(GDALCreate(GDALGetDriverByName("GTiff"), "/vsimem/made/strip.tif", 20'000, 20'000,
                                      1, GDT_Float32, options.List()));
        ASSERT_NE(made, nullptr) << errors.first();
        double pixels[6] = {0, 1, 0, 0, 0, -1};
        GDALSetGeoTransform(made.get(), pixels);
    }
    test::unload("/vsimem/made", folder.path());
    ASSERT_LT(fs::file_size(path), 100'000u);
    EXPECT_FALSE(read_dem(path, 16));
    EXPECT_LT(GDALGetCacheUsed64(), 1 << 20);
}

}  // namespace
}  // namespace terrains
